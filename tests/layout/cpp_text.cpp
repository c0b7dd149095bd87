// Header: tests/layout/cpp_text.hpp. Test: tests/layout/used_names_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/layout/cpp_text.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace director::tests {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// How many characters the word, sign or number has that `text` begins with. A quote within a number parts its digits.
std::size_t token_length(std::string_view text) {
  if (text.starts_with("::") || text.starts_with("->") || text.starts_with("&&")) return 2;
  if (!is_word(text.front())) return 1;
  const bool digit = std::isdigit(static_cast<unsigned char>(text.front())) != 0;
  const auto ends = [digit](char c) { return !is_word(c) && !(digit && c == '\''); };
  return static_cast<std::size_t>(std::ranges::find_if(text, ends) - text.begin());
}

/// How many characters of `text` the literal takes that it begins with.
std::size_t literal_length(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && text[length] != text.front()) length += text[length] == '\\' ? 2 : 1;
  return std::min(length + 1, text.size());
}

/// How the raw literal ends that `text` begins with.
std::string end_of_raw(std::string_view text) { return ")" + std::string(text.substr(2, text.find('(') - 2)) + "\""; }

bool is_operator(std::string_view word) {
  static const NameSet all{"sizeof", "alignof", "decltype", "noexcept", "typeid", "static_assert"};
  return all.count(word) != 0;
}

bool ends_type(const Token& token) {
  static const NameSet others{"return",    "else", "case", "throw", "new", "delete",
                              "co_return", "do",   "and",  "or",    "not"};
  if (is_word(token)) return others.count(token.text) == 0;
  return token.text == ">" || token.text == "&" || token.text == "&&" || token.text == "*";
}

} // namespace

bool is_word(const Token& token) { return is_word(token.text.front()); }

bool is_title(std::string_view word) { return std::isupper(static_cast<unsigned char>(word.front())) != 0; }

std::vector<Token> tokens_of(const std::vector<std::string>& lines) {
  std::vector<Token> out;
  std::string raw; // how the raw literal ends that the line begins within
  for (std::size_t number = 1; number <= lines.size(); ++number) {
    std::string_view rest = lines[number - 1];
    if (raw.empty() && rest.substr(std::min(rest.find_first_not_of(' '), rest.size())).starts_with('#')) continue;
    while (!rest.empty() && (!raw.empty() || !rest.starts_with("//"))) {
      if (raw.empty() && rest.starts_with("R\"")) raw = end_of_raw(rest);
      if (!raw.empty()) {
        const std::size_t end = rest.find(raw);
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + std::exchange(raw, {}).size());
        continue;
      }
      const char c = rest.front();
      const bool literal = c == '"' || c == '\'';
      const std::size_t length = literal ? literal_length(rest) : token_length(rest);
      if (!literal && c != ' ') out.push_back({std::string(rest.substr(0, length)), number});
      rest.remove_prefix(length);
    }
  }
  return out;
}

Declared declared_in(const std::vector<Token>& tokens) {
  Declared out;
  std::vector<bool> scopes;     // of the braces that are open: whether each is of a namespace
  bool opens_namespace = false; // since the last end of a declaration
  std::size_t parentheses = 0;
  const auto outside = [&] { return parentheses == 0 && std::ranges::find(scopes, false) == scopes.end(); };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& text = tokens[i].text;
    const auto next = [&](std::size_t by) -> std::string_view {
      return i + by < tokens.size() ? std::string_view(tokens[i + by].text) : std::string_view("");
    };
    if (text == "{") scopes.push_back(std::exchange(opens_namespace, false));
    if (text == "}" && !scopes.empty()) scopes.pop_back();
    if (text == "(") ++parentheses;
    if (text == ")" && parentheses > 0) --parentheses;
    if (text == ";" || text == "}") opens_namespace = false;
    if (text == "namespace") opens_namespace = true;
    if (text == "namespace" && next(1) == "director")
      for (std::size_t by = 1; by == 1 || next(by - 1) == "::"; by += 2) out.opened.insert(std::string(next(by)));
    if (text == "class" || text == "struct" || text == "concept" || text == "using" || text == "enum") {
      const std::size_t by = next(1) == "class" || next(1) == "struct" ? 2 : 1;
      const std::string_view name = next(by), behind = next(by + 1);
      if (name.empty() || !is_word(name.front()) || (text == "using" && behind != "=")) continue;
      out.provided.insert(std::string(name));
      if (outside() && (behind == "{" || behind == ":" || behind == "=" || behind == "final"))
        out.defined.insert(std::string(name));
      i += by;
    } else if (i > 0 && is_word(tokens[i]) && !is_operator(text) && ends_type(tokens[i - 1])) {
      out.provided.insert(text);
      if (outside() && next(1) == "(") out.defined.insert(text);
    }
  }
  return out;
}

} // namespace director::tests
