// Door: compiler/facts/scanned_types.hpp. Test: tests/compiler/facts/types_test.cpp.
#include "compiler/facts/scanned_types.hpp"

#include "compiler/version.hpp"
#include "dsl/load_file.hpp"

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
  const Json& values = from["enum"];
  out.is_enum = values.is_object();
  out.place = place_in(out.is_enum ? values["at"] : from["at"], paths);
  for (const Json& each : values["enumerators"].items())
    out.enumerators.push_back({each["name"].as_text(), each["value"].as_text(), place_in(each["at"], paths)});
  return out;
}

} // namespace

const CppType* Types::find(std::string_view name) const {
  const auto at = by_name.find(name);
  return at == by_name.end() ? nullptr : &at->second;
}

const CompileCommand* ScannedTypes::choose(const std::vector<std::string>& headers, std::string& missing) {
  for (const CompileCommand& command : flags_.commands) {
    const std::vector<std::string> folders = include_folders(fit_for_clang(command.words).words, command.directory);
    const auto is_found = [&](const std::string& header) {
      return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        return static_cast<bool>(files_.read((fs::path(folder) / header).string(), dsl::largest_file));
      });
    };
    const auto lost = std::find_if_not(headers.begin(), headers.end(), is_found);
    if (lost == headers.end()) return &command;
    missing = *lost;
  }
  return nullptr;
}

Types ScannedTypes::read(const TypeReader::Question& question) {
  Types out;
  const auto fail = [&](std::string fault) {
    out.fault = std::move(fault);
    return out;
  };
  if (!flags_.fault.empty()) return fail(flags_.fault);
  if (question.headers.empty()) return fail("no header is named under `cpp: headers`");
  std::string missing;
  const CompileCommand* command = choose(question.headers, missing);
  if (command == nullptr)
    return fail(fmt::format("no include folder of {} has the header `{}`", flags_.source, missing));
  const Scan version = scanner_.version();
  if (!version) return fail(version.error().message);
  const std::string file = (fs::path(command->directory) / "director_types.cpp").string();
  const Json unit = unit_question(file, command->directory, compilers_.complete(fit_for_clang(command->words)));
  Json request = Json::object({{"unit", unit},
                               {"headers", Json::texts(question.headers)},
                               {"namespace", Json::text(question.name_space)},
                               {"names", Json::texts(question.names)}});
  Json asked = request;
  asked.add("director", Json::text(version.value()["director"].as_text())).add("clang", version.value()["clang"]);
  std::optional<Json> answer = cache_.recall(to_line(asked));
  if (!answer) {
    const Scan scan = scanner_.ask("types", request);
    if (!scan) return fail(scan.error().message);
    cache_.keep(to_line(asked), scan.value());
    answer = scan.value();
  }
  const std::vector<Json>& types = (*answer)["types"].items();
  bool any = false;
  for (std::size_t i = 0; i < types.size() && i < question.names.size(); ++i) {
    if (!types[i].is_object()) continue;
    any = true;
    out.by_name.emplace(question.names[i], type_of(types[i], (*answer)["paths"]));
  }
  for (const Json& each : (*answer)["files"].items()) {
    const bool system = each.items().size() == 2 && each.items()[1].as_boolean();
    if (!system && each.items()[0].as_text() != file) out.files.push_back(each.items()[0].as_text());
  }
  const std::vector<Json>& errors = (*answer)["errors"].items();
  if (!any && !errors.empty())
    out.fault = fmt::format("Clang does not understand the headers: {}", errors.front()["message"].as_text());
  return out;
}

} // namespace director::compiler
