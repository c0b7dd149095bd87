// Header: compiler/facts/scanner.hpp. Test: tests/compiler/facts/scanner_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/scanner.hpp"

#include "compiler/base/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

constexpr const char* name = "director-clang";

ScanFault absent() {
  return {
      true,
      "director-clang is not installed, and without it nothing can be read in C++: no `verify`, `stubs` only into new "
      "files, and a state with a `type` needs its `values`; install the package director-clang, or, where you build "
      "Director, clang-19 libclang-19-dev llvm-19-dev"};
}

} // namespace

std::string find_scanner(const std::string& directorc, const std::string& chosen) {
  if (!chosen.empty()) return chosen;
  const fs::path bin = fs::path(directorc).parent_path();
  if (bin.empty()) return name;
  const fs::path root = bin.parent_path();
  std::vector<fs::path> places{bin / name, root / "libexec/director" / name, root / "lib/director" / name};
  std::error_code fault;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "lib", fault))
    places.push_back(entry.path() / "director" / name);
  std::sort(places.begin() + 3, places.end());
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place, fault)) return place.string();
  }
  return name;
}

Json unit_question(const std::string& file, const std::string& directory, const std::vector<std::string>& arguments) {
  return Json::object(
      {{"file", Json::text(file)}, {"directory", Json::text(directory)}, {"arguments", Json::texts(arguments)}});
}

std::string find_headers(const std::string& directorc) {
  const fs::path folder = fs::path(directorc).parent_path().parent_path() / "include/director";
  std::error_code fault;
  return fs::is_directory(folder / "runtime", fault) ? folder.string() : std::string{};
}

std::string find_schemas(const std::string& directorc) {
  const fs::path folder = fs::path(directorc).parent_path().parent_path() / "share/director/schemas";
  std::error_code fault;
  return fs::is_directory(folder, fault) ? folder.string() : std::string{};
}

Scan Scanner::ask(const std::string& subcommand, const Json& request) {
  const Answer answer = programs_.run({program_, subcommand}, to_line(request) + "\n");
  if (!answer.started) return absent();
  const std::optional<Json> json = parse_json(answer.output);
  if (!json || !json->is_object())
    return ScanFault{false, fmt::format("`{} {}` failed with exit status {}", program_, subcommand, answer.status)};
  const std::string& error = (*json)["error"].as_text();
  if (!error.empty()) return ScanFault{false, fmt::format("director-clang: {}", error)};
  return *json;
}

Scan Scanner::version() {
  if (version_) return *version_;
  Scan answer = ask("version", Json::object({}));
  if (answer && answer.value()["director"].as_text() != compiler::version()) {
    answer = ScanFault{false, fmt::format("`{}` is of version {}, and directorc of {}: install both of one version",
                                          program_, answer.value()["director"].as_text(), compiler::version())};
  }
  version_ = answer;
  return answer;
}

} // namespace director::compiler
