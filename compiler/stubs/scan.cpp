// Header: compiler/stubs/scan.hpp. Test: tests/compiler/stubs/scan_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/scan.hpp"

namespace director::compiler::stubs {

namespace {

Json to_json(const Insertion& each) {
  return Json::object(
      {{"path", Json::text(each.path)}, {"offset", Json::count(each.offset)}, {"text", Json::text(each.text)}});
}

Json to_json(const std::vector<Insertion>& insertions) {
  Json out = Json::list({});
  for (const Insertion& each : insertions) out.add(to_json(each));
  return out;
}

Json to_json(const Artefact& file) {
  return Json::object({{"path", Json::text(file.path)}, {"text", Json::text(file.text)}});
}

std::size_t size_in(const Json& json) { return static_cast<std::size_t>(json.as_number()); }

SourcePlace place_in(const Json& row) {
  return {row["path"].as_text(), static_cast<std::uint32_t>(row["line"].as_number()),
          static_cast<std::uint32_t>(row["column"].as_number())};
}

FoundClass class_in(const Json& row) {
  FoundClass out;
  out.name = row["name"].as_text();
  out.interfaces = row["interfaces"].as_texts();
  for (const Json& base : row["bases"].items()) out.bases.push_back(place_in(base));
  out.given = row["given"].as_texts();
  out.place = place_in(row);
  out.end = size_in(row["end"]);
  out.inside = row["inside"].as_number();
  out.is_public = row["public"].as_boolean();
  out.in_macro = row["macro"].as_boolean();
  out.only_inline = row["only_inline"].as_boolean();
  out.hides = row["hides"].as_boolean();
  return out;
}

FoundFunction function_in(const Json& row) {
  FoundFunction out;
  out.of = row["class"].as_text();
  out.name = row["name"].as_text();
  out.context = row["context"].as_text();
  out.place = place_in(row);
  out.begin = size_in(row["begin"]);
  out.end = size_in(row["end"]);
  out.inside = row["inside"].as_number();
  out.known = row["known"].as_boolean();
  out.within = row["within"].as_boolean();
  out.defines = row["defines"].as_boolean();
  out.pure = row["pure"].as_boolean();
  out.overrides = row["overrides"].as_boolean();
  out.in_macro = row["macro"].as_boolean();
  out.is_inline = row["inline"].as_boolean();
  out.for_any = row["for_any"].as_boolean();
  out.result = row["result"].as_text();
  out.qualifier = row["qualifier"].as_text();
  out.class_place = place_in(row["class_at"]);
  return out;
}

} // namespace

Json to_json(const DeclarationsRequest& request) {
  Json units = Json::list({}), fresh = Json::list({});
  for (const Unit& unit : request.units)
    units.add(Json::object({{"path", Json::text(unit.path)},
                            {"directory", Json::text(unit.directory)},
                            {"flags", Json::texts(unit.flags)},
                            {"only_unseen", Json::boolean(unit.only_unseen)}}));
  for (const Artefact& file : request.fresh) fresh.add(to_json(file));
  return Json::object({{"header", to_json(request.header)},
                       {"facts", to_json(request.facts)},
                       {"interfaces", Json::texts(request.interfaces)},
                       {"units", std::move(units)},
                       {"insertions", to_json(request.insertions)},
                       {"fresh", std::move(fresh)}});
}

Found found_in(const Json& answer) {
  Found out;
  for (const Json& row : answer["classes"].items()) out.classes.push_back(class_in(row));
  for (const Json& row : answer["functions"].items()) out.functions.push_back(function_in(row));
  for (const Json& row : answer["problems"].items()) out.problems.push_back({place_in(row), row["message"].as_text()});
  return out;
}

Json to_json(const std::vector<FormatRequest>& files) {
  Json list = Json::list({});
  for (const FormatRequest& file : files) {
    Json row = Json::object({{"path", Json::text(file.path)}});
    if (file.insertions.empty()) row.add("text", Json::text(file.text));
    if (!file.insertions.empty()) row.add("insertions", to_json(file.insertions));
    list.add(std::move(row));
  }
  return Json::object({{"files", std::move(list)}});
}

std::vector<std::vector<Replacement>> replacements_in(const Json& answer) {
  std::vector<std::vector<Replacement>> out;
  for (const Json& file : answer["files"].items()) {
    std::vector<Replacement>& all = out.emplace_back();
    for (const Json& each : file.items())
      all.push_back({size_in(each["offset"]), size_in(each["length"]), each["text"].as_text()});
  }
  return out;
}

} // namespace director::compiler::stubs
