// SPDX-License-Identifier: MIT
#include "compiler/base/version.hpp"
#include "compiler/facts/scanner.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace director::compiler;
namespace fs = std::filesystem;

/// A child that gives prepared answers, and records its requests.
class Child final : public Programs {
public:
  Answer run(const std::vector<std::string>& words, const std::string& text) override {
    command = words;
    input = text;
    ++calls;
    return answer;
  }
  Answer answer;
  std::vector<std::string> command;
  std::string input;
  int calls = 0;
};

TEST_CASE("requests to director-clang and its answers are JSON") {
  Child child;
  child.answer = {true, 0, R"({"values": [1, "two", true, null]})"};
  Scanner scanner("/opt/director-clang", child);
  const Scan answer = scanner.ask("types", Json::object({{"name", Json::text("x")}}));
  REQUIRE(answer);
  CHECK(answer.value()["values"].items().size() == 4);
  CHECK(answer.value()["values"].items()[1].as_text() == "two");
  CHECK(child.command == std::vector<std::string>{"/opt/director-clang", "types"});
  CHECK(child.input == "{\"name\":\"x\"}\n");
}

TEST_CASE("a director-clang that is not installed, that fails or that refuses") {
  Child child;
  Scanner scanner("director-clang", child);
  const auto fault = [&] { return scanner.ask("types", Json::object({})).error(); };
  CHECK(fault().absent);
  CHECK(fault().message == "director-clang is not installed, and without it nothing can be read in C++: no `verify`, "
                           "`stubs` only into new files, and a state "
                           "with a `type` needs its `values`; install the package director-clang, or, where you "
                           "build Director, clang-19 libclang-19-dev llvm-19-dev");
  child.answer = {true, 139, ""};
  CHECK_FALSE(fault().absent);
  CHECK(fault().message == "`director-clang types` failed with exit status 139");
  child.answer = {true, 1, "{\"error\": \"the request is no JSON\"}"};
  CHECK(fault().message == "director-clang: the request is no JSON");
}

TEST_CASE("a director-clang of another version is refused, and queried once") {
  Child child;
  child.answer = {true, 0, R"({"director": "0.0.9", "clang": "19.1.7"})"};
  Scanner scanner("director-clang", child);
  const std::string expected = "`director-clang` is of version 0.0.9, and directorc of " + std::string(version()) +
                               ": install both of one version";
  CHECK(scanner.version().error().message == expected);
  CHECK(scanner.version().error().message == expected);
  CHECK(child.calls == 1);
}

TEST_CASE("where director-clang is looked for") {
  const fs::path root = fs::temp_directory_path() / ("director_find_scanner_test_" + std::to_string(getpid()));
  fs::remove_all(root);
  const auto put = [&](const char* place) {
    fs::create_directories((root / place).parent_path());
    std::ofstream(root / place) << "";
    return (root / place).string();
  };
  const std::string directorc = (root / "bin/directorc").string();
  CHECK(find_scanner(directorc, "") == "director-clang");
  CHECK(find_scanner("", "") == "director-clang");
  const std::string deep = put("lib/some-machine/director/director-clang");
  CHECK(find_scanner(directorc, "") == deep);
  for (const char* const other : {"lib/z/director/director-clang", "lib/c/director/director-clang",
                                  "lib/b/director/director-clang", "lib/y/director/director-clang"})
    put(other);
  const std::string first = put("lib/a/director/director-clang"); // in whatever order the file system lists them
  CHECK(find_scanner(directorc, "") == first);
  const std::string lib = put("lib/director/director-clang");
  CHECK(find_scanner(directorc, "") == lib);
  const std::string libexec = put("libexec/director/director-clang");
  CHECK(find_scanner(directorc, "") == libexec);
  const std::string beside = put("bin/director-clang");
  CHECK(find_scanner(directorc, "") == beside);
  CHECK(find_scanner(directorc, "/elsewhere/director-clang") == "/elsewhere/director-clang");
  fs::remove_all(root);
}

TEST_CASE("where the headers of the runtime are looked for") {
  const fs::path root = fs::temp_directory_path() / ("director_find_headers_test_" + std::to_string(getpid()));
  fs::remove_all(root);
  fs::create_directories(root / "include/director");
  CHECK(find_headers((root / "bin/directorc").string()).empty());
  fs::create_directories(root / "include/director/runtime");
  CHECK(find_headers((root / "bin/directorc").string()) == (root / "include/director").string());
  CHECK(find_headers("").empty());
  fs::remove_all(root);
}

} // namespace
