// Header: tests/support/golden.hpp. Test: tests/system/bless/bless.cmake.
// SPDX-License-Identifier: MIT
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

namespace director::tests {

namespace {

bool blessing() {
  const char* bless = std::getenv("DIRECTOR_BLESS");
  return bless != nullptr && std::string_view{bless} == "1";
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) FAIL("cannot write " << path.string());
}

std::string_view line_at(std::string_view text, std::size_t position) {
  const std::size_t before = position == 0 ? std::string_view::npos : text.rfind('\n', position - 1);
  const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
  return text.substr(start, text.find('\n', start) - start);
}

// Where two texts part, for a person: the place and both lines.
std::string difference(std::string_view golden, std::string_view actual) {
  const auto [in_golden, in_actual] = std::mismatch(golden.begin(), golden.end(), actual.begin(), actual.end());
  const auto position = static_cast<std::size_t>(std::distance(golden.begin(), in_golden));
  const auto line = 1 + std::count(golden.begin(), in_golden, '\n');
  return "line " + std::to_string(line) + "\n  golden: " + std::string(line_at(golden, position)) +
         "\n  actual: " + std::string(line_at(actual, position));
}

} // namespace

std::filesystem::path source_dir() { return DIRECTOR_SOURCE_DIR; }

std::filesystem::path binary_dir() { return DIRECTOR_BINARY_DIR; }

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) FAIL("cannot read " << path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

void check_golden(std::string_view path, std::string_view actual) {
  const std::filesystem::path file = source_dir() / path;
  const bool known = std::filesystem::exists(file);
  if (blessing()) {
    if (!known || read_file(file) != actual) write_file(file, actual);
    SUCCEED();
  } else if (!known) {
    FAIL_CHECK(path << " is missing; ./bless writes it");
  } else if (const std::string golden = read_file(file); golden != actual) {
    FAIL_CHECK(path << " differs at " << difference(golden, actual) << "\n./bless rewrites it, if the change is meant");
  } else {
    SUCCEED();
  }
}

void check_golden_folder(std::string_view folder, const std::map<std::string, std::string>& files) {
  const std::filesystem::path root = source_dir() / folder;
  std::set<std::filesystem::path> expected;
  for (const auto& [name, text] : files) {
    expected.insert((root / name).lexically_normal());
    check_golden(std::string(folder) + "/" + name, text);
  }
  if (!std::filesystem::exists(root)) return;
  std::set<std::filesystem::path> strangers;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    if (entry.is_regular_file() && !expected.contains(entry.path().lexically_normal())) strangers.insert(entry.path());
  for (const std::filesystem::path& stranger : strangers) {
    if (blessing())
      std::filesystem::remove(stranger);
    else
      FAIL_CHECK(stranger.lexically_relative(source_dir()).string() << " is not written any more; ./bless removes it");
  }
}

} // namespace director::tests
