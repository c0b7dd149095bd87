// SPDX-License-Identifier: MIT
// The pages themselves.
#include "tests/docs/comment.hpp"
#include "tests/docs/expected_page.hpp"
#include "tests/docs/names.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>

using namespace director::tests;

namespace {

std::vector<std::string> pages_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir() / folder))
    if (entry.path().extension() == ".md")
      paths.push_back(entry.path().lexically_relative(source_dir()).generic_string());
  std::ranges::sort(paths);
  return paths;
}

/// The pages that list the folders beside them.
const std::vector<std::string> maps{"compiler/README.md", "dsl/README.md", "runtime/README.md",
                                    "runtime/core/README.md", "tests/README.md"};

std::vector<std::string> documentation() {
  std::vector<std::string> paths = pages_in("docs");
  std::erase_if(paths,
                [](const std::string& path) { return path.starts_with("docs/behaviours/"); }); // see own_pages_test.cpp
  paths.insert(paths.begin(), "README.md");
  for (const char* path : {"CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "runtime/dds/README.md"})
    paths.emplace_back(path);
  paths.insert(paths.end(), maps.begin(), maps.end());
  return paths;
}

Markdown read(const std::string& path) { return read_markdown(read_file(source_dir() / path)); }

/// The version that drew a picture, which is in a comment; another one may draw it differently.
std::string renderer(const std::string& svg) {
  const std::size_t at = svg.find("graphviz version");
  return at == std::string::npos ? "" : svg.substr(at, svg.find('\n', at) - at);
}

} // namespace

TEST_CASE("each block of a page equals the source that it names", "[golden]") {
  for (const std::string& path : documentation()) {
    const ExpectedPage page = expected_page(path, read(path));
    for (const std::string& fault : page.faults) FAIL_CHECK(fault);
    check_golden(path, page.text);
  }
}

TEST_CASE("code is between fences, where a comment can name its source") {
  for (const std::string& path : documentation())
    for (const Inline& line : read(path).indented)
      FAIL_CHECK(path << ":" << line.line + 1 << ": code by its indentation alone");
  SUCCEED();
}

TEST_CASE("a picture is what its command draws", "[golden]") {
  for (const std::string& path : documentation())
    for (const Picture& picture : read(path).pictures) {
      const Comment comment = read_comment(picture.comment);
      CAPTURE(path, picture.line + 1);
      REQUIRE(comment.word == "run");
      if (run_command("dot -V", source_dir()).status != 0) continue;
      const Ran ran = run_command(comment.argument, source_dir());
      CHECK(ran.status == 0);
      const std::filesystem::path file =
          (std::filesystem::path(path).parent_path() / picture.target).lexically_normal();
      const bool known = std::filesystem::exists(source_dir() / file);
      if (known && renderer(read_file(source_dir() / file)) != renderer(ran.output)) continue;
      check_golden(file.generic_string(), ran.output);
    }
}

TEST_CASE("links lead somewhere") {
  std::vector<std::string> paths = documentation();
  for (const char* folder : {"docs/behaviours", "behaviours", "compiler", "tests"})
    for (std::string& path : pages_in(folder)) paths.push_back(std::move(path));
  for (const std::string& path : paths)
    for (const std::string& fault : link_faults(path, read(path))) FAIL_CHECK(fault);
  SUCCEED();
}

TEST_CASE("files and commands that the pages name exist") {
  for (const std::string& path : documentation())
    for (const std::string& fault : name_faults(path, read(path))) FAIL_CHECK(fault);
  SUCCEED();
}

TEST_CASE("a page that lists what is beside it leads to each folder there") {
  for (const std::string& path : maps)
    for (const std::string& fault : folder_faults(path, read(path))) FAIL_CHECK(fault);
  SUCCEED();
}

TEST_CASE("the glossary explains each word once") {
  std::set<std::string> words;
  for (const std::string& line : read("docs/glossary.md").lines) {
    if (!line.starts_with("| ") || line.starts_with("| word |") || line.starts_with("| --- ")) continue;
    std::istringstream row(line.substr(2, line.find(" |") - 2));
    for (std::string word; std::getline(row >> std::ws, word, ',');)
      if (!words.insert(word).second) FAIL_CHECK("docs/glossary.md: `" << word << "` stands there twice");
  }
  CHECK(words.size() > 80);
}
