// Header: tests/layout/source_tree.hpp. Test: the tests beside it.
// SPDX-License-Identifier: MIT
#include "tests/layout/source_tree.hpp"

#include "tests/support/golden.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace director::tests {

std::vector<ProjectFile> project_files() {
  std::vector<ProjectFile> files;
  const std::filesystem::path root = source_dir();
  for (auto entry = std::filesystem::recursive_directory_iterator(root); entry != std::filesystem::end(entry);
       ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (path == ".git" || path == "build" || path == "install" || path == ".cache") {
      if (entry->is_directory()) entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file()) continue;
    const std::string text = read_file(entry->path());
    if (text.find('\0') != std::string::npos) continue;
    ProjectFile file{path, {}};
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &ProjectFile::path);
  return files;
}

} // namespace director::tests
