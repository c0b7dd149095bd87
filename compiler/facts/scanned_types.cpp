// Header: compiler/facts/scanned_types.hpp. Test: tests/compiler/facts/types_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/scanned_types.hpp"

#include "compiler/base/version.hpp"
#include "dsl/lexical/cpp_type.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

CppType type_of(const Json& from, const Json& paths) {
  CppType out;
  out.wrong = from["wrong"].as_text();
  out.complete = from["complete"].as_boolean();
  out.form = from["form"].as_text();
  const Json& values = from["enum"];
  out.is_enum = values.is_object();
  out.place = place_in(out.is_enum ? values["at"] : from["at"], paths);
  for (const Json& each : values["enumerators"].items())
    out.enumerators.push_back({each["name"].as_text(), each["value"].as_text(), place_in(each["at"], paths)});
  return out;
}

/// Whether Clang found a fault outside of the requested names: in a header.
bool fails_elsewhere(const Json& answer, const std::string& file) {
  const std::vector<Json>& errors = answer["errors"].items();
  return std::any_of(errors.begin(), errors.end(), [&](const Json& error) { return error["file"].as_text() != file; });
}

Types types_in(const Json& answer, const std::vector<std::string>& names, const std::string& file) {
  Types out;
  const bool uncertain = fails_elsewhere(answer, file);
  const std::vector<Json>& types = answer["types"].items();
  bool any = false, unknown = false;
  for (std::size_t i = 0; i < types.size() && i < names.size(); ++i) {
    if (!types[i].is_object()) continue;
    // If a header does not compile, a missing type may only not have been read.
    if (uncertain && !types[i]["wrong"].as_text().empty()) {
      unknown = true;
      continue;
    }
    any = true;
    out.by_name.emplace(names[i], type_of(types[i], answer["paths"]));
  }
  for (const Json& each : answer["files"].items()) {
    const bool system = each.items().size() == 2 && each.items()[1].as_boolean();
    if (!system && each.items()[0].as_text() != file) out.files.push_back(each.items()[0].as_text());
  }
  const std::vector<Json>& errors = answer["errors"].items();
  if ((!any || unknown) && !errors.empty()) {
    const Json& first = errors.front();
    const std::string& path = first["file"].as_text();
    const std::string place = path.empty() || path == file ? std::string{}
                                                           : fmt::format("{}:{}:{}: ", path, first["line"].as_number(),
                                                                         first["column"].as_number());
    out.fault = fmt::format("Clang does not understand the headers: {}{}", place, first["message"].as_text());
  }
  return out;
}

} // namespace

const CppType* Types::find(std::string_view name) const {
  const auto at = by_name.find(name);
  return at == by_name.end() ? nullptr : &at->second;
}

std::vector<std::string> ScannedTypes::missing_in(const CompileCommand& command,
                                                  const std::vector<std::string>& headers) {
  const auto without = [&](const std::vector<std::string>& words, const std::vector<std::string>& wanted) {
    std::vector<std::string> out;
    for (const std::string& header : wanted) {
      const dsl::NamedHeader named = dsl::named_header(header);
      const std::vector<std::string> folders = include_folders(words, command.directory, named.angled);
      const bool found = std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        const auto text =
            files_.read((fs::path(folder) / named.path).string(), dsl::largest_file, dsl::Kinds::ordinary);
        if (!text && text.error().kind != dsl::FileError::Kind::not_found) unreadable_[header] = text.error().message;
        return static_cast<bool>(text);
      });
      if (!found) out.push_back(header);
    }
    return out;
  };
  const Flags flags = fit_for_clang(command);
  const std::vector<std::string> missing = without(flags.words, headers);
  // The compiler is queried only for a header that may be one of the system's.
  return missing.empty() ? missing : without(compilers_.complete(flags), missing);
}

bool ScannedTypes::has_runtime(const CompileCommand& command) {
  const std::vector<std::string> folders = include_folders(fit_for_clang(command).words, command.directory);
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    return static_cast<bool>(files_.read((fs::path(folder) / "runtime/core/behaviour.hpp").string(), dsl::largest_file,
                                         dsl::Kinds::ordinary));
  });
}

/// Rather one of a program with the runtime: other programs may have other macros.
const CompileCommand* ScannedTypes::choose(const std::vector<std::string>& headers, std::vector<std::string>& missing) {
  std::optional<std::vector<std::string>> nowhere;
  const CompileCommand* out = nullptr;
  for (const CompileCommand& command : flags_.commands) {
    if (is_of_c(command)) continue;
    std::vector<std::string> here = missing_in(command, headers);
    if (here.empty()) {
      if (has_runtime(command)) return &command;
      if (out == nullptr) out = &command;
      continue;
    }
    missing = here;
    if (!nowhere) {
      nowhere = std::move(here);
    } else {
      std::erase_if(*nowhere, [&](const std::string& header) {
        return std::find(here.begin(), here.end(), header) == here.end();
      });
    }
  }
  if (nowhere && out == nullptr) missing_everywhere_ = *nowhere;
  return out;
}

/// Why no command finds all headers.
Types ScannedTypes::failure_to_choose(const std::vector<std::string>& missing) const {
  Types out;
  out.missing = missing_everywhere_;
  out.unreadable = unreadable_;
  if (missing.empty()) {
    out.fault = fmt::format("{} compiles no C++", flags_.source);
    return out;
  }
  const std::string& first = (out.missing.empty() ? missing : out.missing).front();
  const auto why = unreadable_.find(first);
  out.fault = why == unreadable_.end()
                  ? fmt::format("no include folder of {} has the header `{}`", flags_.source, first)
                  : fmt::format("the header `{}` cannot be read: {}", first, why->second);
  return out;
}

/// From the cache, or from director-clang. `file`: which includes the headers.
Scan ScannedTypes::answer_to(const TypeReader::Question& question, const CompileCommand& command,
                             const std::string& file) {
  const Scan version = scanner_.version();
  if (!version) return version;
  const Json unit = unit_question(file, command.directory, compilers_.complete(fit_for_clang(command)));
  Json request = Json::object({{"unit", unit},
                               {"headers", Json::texts(question.headers)},
                               {"namespace", Json::text(question.name_space)},
                               {"names", Json::texts(question.names)}});
  Json versioned = request;
  versioned.add("format", Json::number(facts_format));
  versioned.add("director", Json::text(version.value()["director"].as_text())).add("clang", version.value()["clang"]);
  if (std::optional<Json> known = cache_.recall(to_line(versioned))) return std::move(*known);
  Scan scan = scanner_.ask("types", request);
  // A header that the build has yet to generate is not among the files that were read.
  if (scan && !fails_elsewhere(scan.value(), file)) cache_.keep(to_line(versioned), scan.value());
  return scan;
}

Types ScannedTypes::read(const TypeReader::Question& question) {
  const auto failure = [](std::string fault) {
    Types out;
    out.fault = std::move(fault);
    return out;
  };
  if (!flags_.fault.empty()) return failure(flags_.fault);
  std::vector<std::string> missing;
  const CompileCommand* command = choose(question.headers, missing);
  if (command == nullptr) return failure_to_choose(missing);
  if (question.names.empty()) return {};
  const std::string file = (fs::path(command->directory) / "director_types.cpp").string();
  const Scan scan = answer_to(question, *command, file);
  return scan ? types_in(scan.value(), question.names, file) : failure(scan.error().message);
}

} // namespace director::compiler
