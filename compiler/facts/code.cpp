// Header: compiler/facts/code.hpp. Test: tests/compiler/checks/code_check_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/code.hpp"

#include "dsl/source/load_file.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

class UnitReader {
public:
  UnitReader(const CodeFacts& code, const Json& unit, CodeFiles& files) : unit_(unit), files_(files) {
    for (const Json& each : unit["functions"].items()) {
      const CodeFunction* known = code.find(each["key"].as_text());
      if (known != nullptr) add_other(*known, each);
    }
    for (const Json& each : unit["classes"].items()) {
      const CodeClass* known = code.find_class(each["key"].as_text());
      if (known != nullptr) add_other(*known, each);
    }
  }

  dsl::Span span(const Json& at) const { return files_.span(place_in(at, unit_["paths"])); }

  std::string key(const Json& from) const {
    const auto at = others_.find(from.as_text());
    return at == others_.end() ? from.as_text() : at->second;
  }
  std::vector<std::string> keys(const Json& from) const {
    std::vector<std::string> out;
    for (const Json& each : from.items()) out.push_back(key(each));
    return out;
  }

  CodeFunction function(const Json& from) const {
    CodeFunction out;
    out.key = key(from["key"]);
    out.name = from["name"].as_text();
    out.span = span(from["at"]);
    out.overrides = keys(from["overrides"]);
    out.context = from["context"].as_text();
    out.class_name = from["class"].as_text();
    if (!from["open_end"].is_null()) out.open_end = span(from["open_end"]);
    out.unwritten = from["unwritten"].as_boolean();
    out.stores = from["stores"].as_boolean();
    out.doubtful = !unit_["errors"].items().empty();
    for (const Json& each : from["does"].items()) out.words.push_back(word(each));
    for (const Json& each : from["calls"].items()) {
      out.calls.push_back({key(each["to"]), each["name"].as_text(), span(each["at"]),
                           place_in(each["declared"], unit_["paths"]).path, each["carries"].as_boolean(),
                           each["maybe"].as_boolean(), each["virtual"].as_boolean()});
    }
    for (const Json& each : from["blocks"].items())
      out.blocks.push_back({each["name"].as_text(), each["why"].as_text(), span(each["at"])});
    for (const Json& each : from["hidden"].items())
      out.hidden.push_back(
          {each["what"].as_text(), span(each["at"]), each["carries"].as_boolean(), each["if_stored"].as_boolean()});
    return out;
  }

  CodeClass record(const Json& from) const {
    CodeClass out{key(from["key"]),
                  from["name"].as_text(),
                  from["module"].as_text(),
                  span(from["at"]),
                  keys(from["bases"]),
                  from["missing"].as_texts(),
                  {}};
    for (const Json& each : from["stray"].items())
      out.stray.push_back({key(each["key"]), each["context"].as_text(), each["unlike"].as_text(),
                           each["wrote"].as_text(), span(each["at"])});
    return out;
  }

private:
  CodeWord word(const Json& from) const {
    using Kind = CodeWord::Kind;
    const std::string& name = from["word"].as_text();
    const Kind kind = name == "request" ? Kind::request
                      : name == "pack"  ? Kind::pack
                      : name == "set"   ? Kind::set
                      : name == "done"  ? Kind::done
                      : name == "fail"  ? Kind::fail
                                        : Kind::keep;
    CodeWord out{
        kind, from["context"].as_text(), from["pack"].as_text(), from["tasks"].as_texts(), from["state"].as_text(),
        {},   span(from["at"])};
    if (from["values"].is_list()) {
      out.values.emplace();
      for (const Json& names : from["values"].items()) {
        if (!names.items().empty()) out.values->push_back(names.as_texts());
      }
    }
    return out;
  }

  /// Gives it a key of its own, if it is defined at another place.
  template <typename Known>
  void add_other(const Known& known, const Json& from) {
    const CodePlace place = place_in(from["at"], unit_["paths"]);
    if (known.span == files_.span(place)) return;
    others_.emplace(known.key, known.key + "@" + place.path + ":" + std::to_string(place.begin));
  }

  const Json& unit_;
  CodeFiles& files_;
  std::map<std::string, std::string, std::less<>> others_; ///< by key: that of what this file means by it
};

} // namespace

namespace {

template <typename Row>
void join(std::vector<Row>& to, std::vector<Row> from) {
  for (Row& each : from) {
    if (std::find(to.begin(), to.end(), each) == to.end()) to.push_back(std::move(each));
  }
}

/// The same function, compiled in another file or with other flags.
void join(CodeFunction& to, CodeFunction from) {
  join(to.words, std::move(from.words));
  join(to.calls, std::move(from.calls));
  join(to.blocks, std::move(from.blocks));
  join(to.hidden, std::move(from.hidden));
  // An end that is open where Clang found errors may be none.
  if (to.doubtful && !from.doubtful) to.open_end.reset();
  if (!to.open_end && (to.doubtful || !from.doubtful)) to.open_end = from.open_end;
  to.stores = to.stores || from.stores;
  to.unwritten = to.unwritten && from.unwritten;
  to.doubtful = to.doubtful && from.doubtful;
}

} // namespace

const CodeFunction* CodeFacts::find(std::string_view key) const {
  const auto at = by_key.find(key);
  return at == by_key.end() ? nullptr : &functions[at->second];
}

const CodeClass* CodeFacts::find_class(std::string_view key) const {
  const auto at = std::find_if(classes.begin(), classes.end(), [&](const CodeClass& each) { return each.key == key; });
  return at == classes.end() ? nullptr : &*at;
}

CodePlace place_in(const Json& at, const Json& paths) {
  if (at.items().size() != 3) return {};
  const auto row = static_cast<std::size_t>(at.items()[0].as_number());
  if (row >= paths.items().size()) return {};
  return {paths.items()[row].as_text(), static_cast<std::uint32_t>(at.items()[1].as_number()),
          static_cast<std::uint32_t>(at.items()[2].as_number())};
}

dsl::Span CodeFiles::span(const CodePlace& place) {
  return place.path.empty() ? dsl::Span{} : dsl::Span{of(place.path), place.begin, place.end};
}

dsl::FileId CodeFiles::of(const std::string& path) {
  const auto at = known_.find(path);
  if (at != known_.end()) return at->second;
  auto text = files_.read(path, dsl::largest_file, dsl::Kinds::ordinary);
  const dsl::FileId id = sources_.add(shown_(path), text ? std::move(text.value()) : std::string{});
  known_.emplace(path, id);
  return id;
}

void add_unit(CodeFacts& code, const Json& unit, CodeFiles& files) {
  const UnitReader reader(code, unit, files);
  for (const Json& each : unit["functions"].items()) {
    const auto [at, is_new] = code.by_key.emplace(reader.key(each["key"]), code.functions.size());
    if (is_new) {
      code.functions.push_back(reader.function(each));
    } else {
      join(code.functions[at->second], reader.function(each));
    }
  }
  for (const Json& each : unit["classes"].items()) {
    CodeClass record = reader.record(each);
    if (code.find_class(record.key) == nullptr) code.classes.push_back(std::move(record));
  }
  for (const Json& each : unit["continued"].items()) code.continued.insert(reader.key(each));
  for (const Json& each : unit["runs"].items()) code.runs.insert(reader.key(each));
  code.has_templates = code.has_templates || unit["templates"].as_boolean();
  const Json& aliases = unit["aliases"];
  for (std::size_t i = 0; i < aliases.keys().size(); ++i)
    code.aliases.emplace(aliases.keys()[i], aliases.items()[i].as_text());
}

} // namespace director::compiler
