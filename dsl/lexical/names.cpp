// Header: dsl/lexical/names.hpp. Test: tests/dsl/lexical/names_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/names.hpp"

#include "dsl/lexical/characters.hpp"

#include <algorithm>
#include <array>

namespace director::dsl {

namespace {

constexpr std::array<std::string_view, 93> cpp_keywords{
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "typeof",       "union",
    "unsigned",    "using",    "virtual",    "void",      "volatile",  "wchar_t",      "while",
    "xor",         "xor_eq"};
static_assert(std::is_sorted(cpp_keywords.begin(), cpp_keywords.end()));

constexpr std::array<std::string_view, 5> reserved{"start", "stop", "default", "root", "limbo"};
constexpr std::array<std::string_view, 11> context_words{"task", "reasons", "request", "done", "fail",     "keep",
                                                         "set",  "try_set", "wait",    "uses", "triggered"};
// Other spellings, such as `nO`, are no booleans for any tool.
constexpr std::array<std::string_view, 16> old_booleans{"yes", "Yes", "YES", "no",  "No", "NO", "on", "On",
                                                        "ON",  "off", "Off", "OFF", "y",  "Y",  "n",  "N"};
constexpr std::array<std::string_view, 4> other_booleans{"True", "TRUE", "False", "FALSE"};

template <class Words>
bool among(const Words& words, std::string_view text) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

} // namespace

bool is_identifier(std::string_view text) {
  return !text.empty() && !is_digit(text[0]) && std::all_of(text.begin(), text.end(), is_word);
}

bool is_cpp_keyword(std::string_view text) {
  return std::binary_search(cpp_keywords.begin(), cpp_keywords.end(), text);
}

bool is_reserved_in_cpp(std::string_view text) {
  return text.find("__") != std::string_view::npos ||
         (text.size() > 1 && text[0] == '_' && text[1] >= 'A' && text[1] <= 'Z');
}

bool is_director_macro(std::string_view text) { return text.starts_with("DIRECTOR_"); }

bool is_reserved(std::string_view text) {
  std::string name(text);
  if (!name.empty()) name[0] = lower(name[0]);
  return among(reserved, name);
}

bool is_context_word(std::string_view text) { return among(context_words, text); }

bool is_old_boolean(std::string_view text) { return among(old_booleans, text); }

bool is_other_boolean(std::string_view text) { return among(other_booleans, text); }

std::string capitalised(std::string_view name) {
  std::string out(name);
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

} // namespace director::dsl
