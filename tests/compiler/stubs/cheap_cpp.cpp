// Header: tests/compiler/stubs/cheap_cpp.hpp. Test: tests/compiler/stubs/orders_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/compiler/stubs/cheap_cpp.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace director::tests {

namespace {

using namespace compiler::stubs;

struct Token {
  std::string_view text;
  std::size_t at = 0;
  std::size_t end() const { return at + text.size(); }
};

struct Region {
  std::size_t begin, end;
};

struct Tokens {
  std::vector<Token> all;
  std::vector<Region> regions;
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Lexer {
public:
  explicit Lexer(std::string_view text) : text_(text) {}

  Tokens run() {
    if (text_.starts_with("\xEF\xBB\xBF")) begin_ = at_ = 3; // a byte order mark
    while (at_ < text_.size()) step();
    return std::move(out_);
  }

private:
  void step() {
    const std::string_view rest = text_.substr(at_);
    const bool first = begins_line();
    if (rest.starts_with("//")) return skip_line();
    if (rest.starts_with("/*")) return skip_to(text_.find("*/", at_ + 2), 2);
    if (rest.starts_with("R\"(")) return skip_to(text_.find(")\"", at_), 2);
    if (rest.front() == '"' || rest.front() == '\'') return skip_quoted(rest.front());
    if (rest.front() == '#' && first) return directive();
    if (std::isspace(static_cast<unsigned char>(rest.front())) != 0) return void(++at_);
    std::size_t size = 0;
    while (size < rest.size() && is_letter(rest[size])) ++size;
    if (size == 0) size = rest.starts_with("::") ? 2 : 1;
    out_.all.push_back({rest.substr(0, size), at_});
    at_ += size;
  }

  bool begins_line() const {
    std::size_t i = at_;
    while (i > begin_ && (text_[i - 1] == ' ' || text_[i - 1] == '\t')) --i;
    return i == begin_ || text_[i - 1] == '\n';
  }
  void skip_to(std::size_t found, std::size_t size) { at_ = found == text_.npos ? text_.size() : found + size; }
  void skip_quoted(char quote) {
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_)
      if (text_[at_] == '\\') ++at_;
    ++at_;
  }
  /// With the lines that a backslash joins to it.
  void skip_line() {
    while (true) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      std::string_view line = text_.substr(at_, end - at_);
      if (line.ends_with('\r')) line.remove_suffix(1);
      at_ = std::min(end + 1, text_.size());
      if (!line.ends_with('\\') || at_ == text_.size()) return;
    }
  }

  void directive() {
    const std::size_t begin = at_;
    skip_line();
    const std::string_view line = text_.substr(begin, at_ - begin);
    if (line.starts_with("#if")) {
      open_.push_back(out_.regions.size());
      out_.regions.push_back({begin, text_.size()});
      if (line.starts_with("#if 0")) skip_inactive();
    } else if (line.starts_with("#endif") && !open_.empty()) {
      out_.regions[open_.back()].end = begin;
      open_.pop_back();
    }
  }

  void skip_inactive() {
    for (int depth = 1; at_ < text_.size();) {
      const std::size_t begin = at_;
      skip_line();
      const std::string_view line = text_.substr(begin, at_ - begin);
      if (line.starts_with("#if")) ++depth;
      if (line.starts_with("#endif") && --depth == 0) {
        at_ = begin;
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t begin_ = 0, at_ = 0;
  Tokens out_;
  std::vector<std::size_t> open_;
};

using Classes = std::map<std::string, std::vector<SourcePlace>>; ///< by name

struct FileReader {
  const std::string& path;
  std::string_view text;
  const Wanted& wanted;
  const std::set<std::string>& contexts;
  Classes& types; ///< every class, also those that implement nothing any more
  Found& out;
  Tokens tokens = Lexer(text).run();
  std::size_t i = 0;

  bool is(std::size_t at, std::string_view word) const { return at < tokens.all.size() && tokens.all[at].text == word; }
  Conditional inside(std::size_t offset) const {
    Conditional best = unconditional;
    for (const Region& each : tokens.regions)
      if (each.begin <= offset && offset < each.end) best = static_cast<Conditional>(each.begin);
    return best;
  }
  SourcePlace place(std::size_t offset) const {
    const std::string_view before = text.substr(0, offset);
    const std::size_t line = before.rfind('\n');
    return {path, static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1),
            static_cast<std::uint32_t>(offset - (line == before.npos ? 0 : line + 1) + 1)};
  }

  /// From an opening bracket to behind the one that closes it.
  std::size_t closed(std::size_t at) const {
    const bool brace = is(at, "{");
    int depth = 0;
    for (; at < tokens.all.size(); ++at) {
      if (is(at, brace ? "{" : "(")) ++depth;
      if (is(at, brace ? "}" : ")") && --depth == 0) return at + 1;
    }
    return at;
  }

  /// Until the brace that closes the scope.
  void scope(const std::string& name, const FoundClass* type) {
    std::size_t statement = i;
    while (i < tokens.all.size() && !is(i, "}")) {
      if (is(i, "template")) {
        while (!is(i, ">")) ++i;
        ++i;
      } else if (is(i, "namespace")) {
        statement = open_namespace(name);
      } else if ((is(i, "class") || is(i, "struct")) && opens_class()) {
        statement = open_class(name, is(statement, "template"));
      } else if (is_function(statement)) {
        statement = function(statement, name, type);
      } else if (is(i, "{")) {
        statement = i = closed(i);
      } else if (is(i, ";") || is_label()) {
        statement = i = is(i, ";") ? i + 1 : i + 2;
      } else {
        ++i;
      }
    }
  }

  bool is_label() const { return is(i + 1, ":") && (is(i, "public") || is(i, "private") || is(i, "protected")); }

  std::size_t open_namespace(const std::string& outer) {
    std::string name = outer;
    for (++i; !is(i, "{"); ++i)
      if (!is(i, "::")) name += (name.empty() ? "" : "::") + std::string(tokens.all[i].text);
    if (is(i - 1, "namespace")) name += (name.empty() ? "" : "::") + std::string("(anonymous namespace)");
    ++i;
    scope(name, nullptr);
    return ++i;
  }

  bool opens_class() const {
    for (std::size_t at = i; at < tokens.all.size() && !is(at, ";") && !is(at, "("); ++at)
      if (is(at, "{")) return true;
    return false;
  }

  std::size_t open_class(const std::string& outer, bool is_template) {
    const bool is_class = is(i, "class");
    FoundClass type;
    const Token& word = tokens.all[i + 1];
    type.name = outer + (outer.empty() ? "" : "::") + std::string(word.text);
    type.place = place(word.at);
    type.only_inline = is_template;
    std::string base;
    for (i += 2; !is(i, "{"); ++i) {
      if (is(i, "public") || is(i, "final") || is(i, ":")) continue;
      base += tokens.all[i].text;
    }
    for (const WantedModule& module : wanted.modules)
      if (base == module.interface) type.interfaces = {base};
    const std::size_t end = closed(i) - 1;
    type.end = tokens.all[end].at;
    type.inside = inside(type.end);
    type.is_public = !is_class;
    for (std::size_t at = i; at < end; ++at) {
      if (is(at, "public") && is(at + 1, ":")) type.is_public = true;
      if ((is(at, "private") || is(at, "protected")) && is(at + 1, ":")) type.is_public = false;
    }
    types[type.name].push_back(type.place);
    ++i;
    scope(type.name, &type);
    if (!type.interfaces.empty()) out.classes.push_back(type);
    return ++i;
  }

  bool is_function(std::size_t statement) const {
    return i > statement && (is(i, "provide") || is(i, "start") || is(i, "stop")) && is(i + 1, "(") && !is(i - 1, ".");
  }

  std::size_t function(std::size_t statement, const std::string& scope_name, const FoundClass* type) {
    FoundFunction row;
    row.name = tokens.all[i].text;
    row.place = place(tokens.all[i].at);
    row.begin = tokens.all[statement].at;
    row.within = type != nullptr;
    std::size_t name = i;
    while (name > statement && is(name - 1, "::")) name -= 2;
    if (!row.within)
      row.qualifier = std::string(text.substr(tokens.all[name].at, tokens.all[i].at - tokens.all[name].at));
    std::size_t result = statement;
    for (; is(result, "inline") || is(result, "virtual"); ++result) row.is_inline |= !row.within;
    if (row.name == "provide")
      row.result = std::string(text.substr(tokens.all[result].at, tokens.all[name - 1].end() - tokens.all[result].at));
    row.of = row.within ? type->name : class_of(scope_name, row.qualifier);
    row.class_place = row.within ? type->place : place_of(row.of);
    for (std::size_t at = i + 2; !is(at, "&") && !is(at, ")"); ++at) row.context += tokens.all[at].text;
    row.known = contexts.count(row.context) > 0;
    for (i = closed(i + 1); !is(i, ";") && !is(i, "{"); ++i) row.overrides |= is(i, "override");
    row.defines = is(i, "{");
    i = is(i, "{") ? closed(i) : i + 1;
    row.end = tokens.all[i - 1].end();
    row.inside = inside(row.end - 1);
    out.functions.push_back(row);
    return i;
  }

  /// The class that a qualifier names in a namespace, or further out.
  std::string class_of(std::string scope_name, std::string qualifier) const {
    qualifier.resize(qualifier.size() - 2);
    while (true) {
      const std::string whole = scope_name + (scope_name.empty() ? "" : "::") + qualifier;
      if (types.count(whole) > 0) return whole;
      if (scope_name.empty()) return qualifier;
      const std::size_t cut = scope_name.rfind("::");
      scope_name = cut == scope_name.npos ? "" : scope_name.substr(0, cut);
    }
  }

  /// Of a class with this name in this file, otherwise in a header.
  SourcePlace place_of(const std::string& name) const {
    const auto all = types.find(name);
    if (all == types.end()) return {};
    const auto here = std::find_if(all->second.begin(), all->second.end(),
                                   [&](const SourcePlace& each) { return each.path == path; });
    return here == all->second.end() ? all->second.front() : *here;
  }
};

} // namespace

Found read_cheaply(const Texts& texts, const Wanted& wanted) {
  std::set<std::string> contexts;
  for (const WantedModule& module : wanted.modules)
    for (const WantedFunction& function : module.functions) contexts.insert(function.context);
  Found out;
  Classes types;
  for (const bool headers : {true, false}) { // classes first
    for (const auto& [path, text] : texts)
      if (path.ends_with(".hpp") == headers) FileReader{path, text, wanted, contexts, types, out}.scope("", nullptr);
  }
  std::sort(out.classes.begin(), out.classes.end(), [](const FoundClass& a, const FoundClass& b) {
    return std::tie(a.place.path, a.place.line, a.place.column) < std::tie(b.place.path, b.place.line, b.place.column);
  });
  std::sort(out.functions.begin(), out.functions.end(), [](const FoundFunction& a, const FoundFunction& b) {
    return std::tie(a.place.path, a.begin) < std::tie(b.place.path, b.begin);
  });
  return out;
}

} // namespace director::tests
