// Header: tests/layout/includes.hpp. Test: tests/layout/includes_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/layout/includes.hpp"

#include <algorithm>
#include <array>
#include <regex>

namespace director::tests {

namespace {

using Names = std::vector<std::string_view>;

struct Component {
  std::string_view folder; // of the files that the row is about; the first row that fits counts
  Names allowed;           // dependencies: the folders whose headers these may include
};

// One way only. Generated code includes its own header by its bare name, and so do the behaviours that are written
// against it.
const std::vector<Component>& components() {
  static const std::vector<Component> all{
      {"runtime/core/base/", {"runtime/core/base/"}},
      {"runtime/core/arbitration/", {"runtime/core/base/", "runtime/core/arbitration/"}},
      {"runtime/core/engine/", {"runtime/core/base/", "runtime/core/arbitration/", "runtime/core/engine/"}},
      {"runtime/core/saved/", {"runtime/core/base/", "runtime/core/engine/", "runtime/core/saved/"}},
      {"runtime/core/inspect/",
       {"runtime/core/base/", "runtime/core/arbitration/", "runtime/core/engine/", "runtime/core/inspect/"}},
      {"runtime/core/api/",
       {"runtime/core/base/", "runtime/core/engine/", "runtime/core/saved/", "runtime/core/inspect/",
        "runtime/core/api/"}},
      {"runtime/core/", {"runtime/core/"}}, // headers that forward
      {"runtime/hosted/", {"runtime/core/", "runtime/hosted/"}},
      {"runtime/live/", {"runtime/core/", "runtime/hosted/", "runtime/live/"}},
      {"runtime/dds/", {"runtime/core/", "runtime/hosted/", "runtime/dds/"}},
      {"schemas/", {}},
      {"dsl/", {"dsl/"}},
      {"compiler/", {"compiler/", "dsl/", "runtime/core/", "runtime/hosted/"}},
      {"generated/", {"runtime/core/", "behaviours/"}},
      {"behaviours/", {"behaviours/", "runtime/core/", "runtime/hosted/", "runtime/live/", "runtime/dds/"}},
      {"tests/oracle/", {"tests/oracle/", "tests/support/", "dsl/", "compiler/model/"}},
      {"tests/",
       {"tests/", "compiler/", "dsl/", "runtime/core/", "runtime/hosted/", "runtime/live/", "runtime/dds/",
        "behaviours/"}},
  };
  return all;
}

struct Library {
  std::string_view prefix; // of the header's name
  std::vector<std::string_view> places;
};

// One library, one place: what each costs the compiler is paid once.
const std::vector<Library>& libraries() {
  static const std::vector<Library> all{
      {"yaml-cpp/", {"dsl/yaml/yaml_tree.cpp"}},
      {"fmt/", {"dsl/", "compiler/", "tests/"}},
      {"CLI/", {"compiler/cli/options/"}},
      {"nlohmann/", {"compiler/base/json.hpp", "compiler/base/json.cpp"}},
      {"boost/", {"compiler/graph/"}},
      {"clang/", {"compiler/clang/"}},
      {"llvm/", {"compiler/clang/"}},
      {"catch2/", {"tests/"}},
      {"rapidcheck", {"tests/"}},
      {"benchmark/", {"tests/bench/"}},
      {"dds/", {"runtime/dds/", "tests/runtime/dds/"}},
      {"httplib.h", {"runtime/live/http.cpp"}},
      {"zlib.h", {"compiler/base/packed.cpp", "tests/compiler/base/packed_test.cpp"}},
  };
  return all;
}

constexpr std::array core_headers{"array",  "atomic", "bit",  "compare", "concepts",    "cstddef", "cstdint",
                                  "limits", "new",    "span", "tuple",   "type_traits", "utility"};
constexpr std::array generated_headers{"cassert", "chrono", "exception"};

bool is_standard(std::string_view name) { return name.find_first_of("./") == std::string_view::npos; }

bool is_among(const auto& names, std::string_view name) { return std::ranges::find(names, name) != std::end(names); }

bool starts_with_one_of(std::string_view name, const Names& prefixes) {
  return std::ranges::any_of(prefixes, [name](std::string_view prefix) { return name.starts_with(prefix); });
}

std::string angled_fault(std::string_view path, std::string_view name) {
  const std::string header = "<" + std::string(name) + ">";
  if (is_standard(name)) {
    const bool core = path.starts_with("runtime/core/");
    const bool generated = path.starts_with("generated/");
    if (!core && !generated) return {};
    if (is_among(core_headers, name) || (generated && is_among(generated_headers, name))) return {};
    return header + " is not among the standard headers that " + (core ? "runtime/core" : "generated") + " may use";
  }
  for (const Library& library : libraries()) {
    if (!name.starts_with(library.prefix)) continue;
    if (starts_with_one_of(path, library.places)) return {};
    return header + " may be included only in " + std::string(library.places.front());
  }
  // What remains is the operating system: the terminal and child processes, and what runs on a computer.
  if (starts_with_one_of(path, {"dsl/source/file_access.cpp", "compiler/cli/", "runtime/hosted/", "runtime/live/",
                                "runtime/dds/", "behaviours/soccer/program.hpp", "tests/"}))
    return {};
  return header + " is of no library among the allowed dependencies of this component";
}

std::string quoted_fault(std::string_view path, std::string_view name) {
  const std::string header = "\"" + std::string(name) + "\"";
  const auto component =
      std::ranges::find_if(components(), [path](const Component& each) { return path.starts_with(each.folder); });
  if (component == components().end()) return "this folder is no component of the project, so it includes nothing";
  if (name.find('/') == std::string_view::npos) {
    if (starts_with_one_of(path, {"generated/", "behaviours/", "tests/"})) return {};
    return header + " must be written from the root of the project";
  }
  if (starts_with_one_of(name, component->allowed)) return {};
  return header + " is not among the allowed dependencies of " +
         std::string(component->folder.substr(0, component->folder.size() - 1));
}

// What stands before the name, and the name.
bool is_include(const std::string& line, std::smatch& match) {
  static const std::regex include{R"(^\s*#\s*include\s*([<"])([^>"]*)[>"])"};
  return std::regex_search(line, match, include);
}

} // namespace

std::string include_fault(std::string_view path, std::string_view name, bool angled) {
  return angled ? angled_fault(path, name) : quoted_fault(path, name);
}

std::vector<std::string> project_includes(const std::vector<std::string>& lines) {
  std::vector<std::string> out;
  for (const std::string& line : lines) {
    std::smatch match;
    if (is_include(line, match) && match[1] == "\"") out.push_back(match[2].str());
  }
  return out;
}

std::vector<std::string> include_faults(std::string_view path, const std::vector<std::string>& lines) {
  std::vector<std::string> faults;
  for (std::size_t index = 0; index < lines.size(); ++index) {
    std::smatch match;
    if (!is_include(lines[index], match)) continue;
    if (const std::string fault = include_fault(path, match[2].str(), match[1] == "<"); !fault.empty())
      faults.push_back(std::string(path) + ":" + std::to_string(index + 1) + ": " + fault);
  }
  return faults;
}

} // namespace director::tests
