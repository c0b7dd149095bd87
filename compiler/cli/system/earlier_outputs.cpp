// Header: compiler/cli/system/earlier_outputs.hpp. Test: tests/compiler/cli/commands/explore_test.cpp,
// tests/compiler/play/why/moment_test.cpp. SPDX-License-Identifier: MIT
#include "compiler/cli/system/earlier_outputs.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace director::compiler::cli {

void print_earlier_outputs(const std::string& folder, const std::vector<Output>& written,
                           const std::function<bool(std::string_view name, std::string_view text)>& is_such,
                           std::string_view what, Console& console) {
  namespace fs = std::filesystem;
  constexpr std::size_t most = 5; // that are named
  const fs::path here = fs::path(folder).lexically_normal() / "";
  std::size_t count = 0;
  std::string names;
  for (const std::string& path : console.outputs.list(here.parent_path().string())) {
    const fs::path file = fs::path(path).lexically_normal();
    const auto is_same = [&](const Output& each) { return fs::path(each.path).lexically_normal() == file; };
    if (file.parent_path() / "" != here || std::any_of(written.begin(), written.end(), is_same)) continue;
    const auto text = console.files.read(path, dsl::largest_file, dsl::Kinds::ordinary);
    const std::string name = file.filename().string();
    if (!text || !has_notice(text.value()) || !is_such(name, text.value())) continue;
    if (++count <= most) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
  }
  if (count == 0) return;
  print_message(console,
                fmt::format("directorc: note: `{}` also has {} of an earlier run: {}{}; remove {} if you do not "
                            "need {}\n",
                            folder, counted(count, what), names,
                            count > most ? fmt::format(" and {} more", count - most) : "", count == 1 ? "it" : "them",
                            count == 1 ? "it" : "them"));
}

} // namespace director::compiler::cli
