// Door: compiler/model/resolver.hpp. Test: tests/compiler/model/resolve_names_test.cpp.
#include "compiler/model/resolver.hpp"
#include "dsl/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace director::compiler {

namespace {

constexpr std::string_view cpp_keywords[] = {
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char8_t",
    "char16_t",    "char32_t", "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq"};

constexpr std::string_view own_words[] = {"Start", "Stop", "Default", "Root", "Limbo"};

constexpr std::string_view context_words[] = {"task", "reasons", "request", "done", "fail",     "keep",
                                              "set",  "try_set", "wait",    "uses", "triggered"};

template <std::size_t count>
bool is_one_of(std::string_view name, const std::string_view (&words)[count]) {
  return std::find(std::begin(words), std::end(words), name) != std::end(words);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_identifier(std::string_view name) {
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

/// Kinds of which the generated class `Behaviour` leaves no room for another one of its name.
bool lives_beside_the_behaviour(std::string_view kind) {
  return kind == "group" || kind == "state" || kind == "trigger" || kind == "module";
}

} // namespace

std::string capitalised(std::string_view name) {
  std::string out(name);
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

bool is_context_word(std::string_view name) { return is_one_of(name, context_words); }

bool is_reserved(std::string_view name) {
  return is_one_of(name, cpp_keywords) || is_one_of(capitalised(name), own_words);
}

bool check_name(Resolver& r, std::string_view kind, const Word& name, bool whole_rule) {
  const std::string& text = name.value;
  if (!is_identifier(text)) {
    r.error("reserved_name", name.span, fmt::format("`{}` is no name for a {}", text, kind)).help =
        "a name has letters, digits and `_`, and does not begin with a digit";
  } else if (is_one_of(text, cpp_keywords)) {
    r.error("reserved_name", name.span,
            fmt::format("a {} cannot be called `{}`: that is a keyword of C++", kind, text));
  } else if (whole_rule && is_one_of(capitalised(text), own_words)) {
    r.error("reserved_name", name.span,
            fmt::format("a {} cannot be called `{}`: that is a word of Director's own", kind, text));
  } else if (lives_beside_the_behaviour(kind) && capitalised(text) == "Behaviour") {
    r.error("reserved_name", name.span,
            fmt::format("a {} cannot be called `{}`: the generated class is called `Behaviour`", kind, text));
  } else if (kind == "pack" && is_context_word(text)) {
    r.error("reserved_name", name.span,
            fmt::format("a pack cannot be called `{}`: a body's context has a word `{}` of its own", text, text));
  } else {
    return true;
  }
  return false;
}

bool claim_cpp_name(Resolver& r, std::string_view kind, const Word& name) {
  const auto [at, is_new] =
      r.cpp_names.try_emplace(capitalised(name.value), Resolver::Declared{std::string(kind), name});
  if (is_new) return true;
  const Resolver::Declared& first = at->second;
  const bool same = first.name.value == name.value;
  std::string message;
  if (same && first.kind == kind) {
    message = fmt::format("the {} `{}` is declared twice", kind, name.value);
  } else {
    message = fmt::format("the {} `{}` and the {} `{}` become one name in C++, `{}`", kind, name.value, first.kind,
                          first.name.value, at->first);
  }
  r.error("redefined_name", name.span, std::move(message))
      .notes.push_back({first.name.span, same && first.kind == kind
                                             ? "declared first here"
                                             : fmt::format("the {} is declared here", first.kind)});
  return false;
}

void report_undefined(Resolver& r, std::string_view kind, const Word& name, const std::vector<std::string>& known) {
  Diagnostic& finding =
      r.error("undefined_name", name.span, fmt::format("there is no {} called `{}`", kind, name.value));
  const auto other = r.cpp_names.find(capitalised(name.value));
  if (other != r.cpp_names.end() && other->second.name.value == name.value && other->second.kind != kind)
    finding.notes.push_back(
        {other->second.name.span, fmt::format("this `{}` is a {}", name.value, other->second.kind)});
  if (const auto nearest = dsl::suggest(name.value, known)) finding.help = fmt::format("did you mean `{}`?", *nearest);
}

std::optional<GroupId> find_group(Resolver& r, const Word& name) {
  const auto at = r.groups.find(name.value);
  if (at != r.groups.end()) return at->second;
  std::vector<std::string> known;
  for (const Group& group : r.model.groups) known.push_back(group.name.value);
  report_undefined(r, "group", name, known);
  return std::nullopt;
}

std::optional<StateId> find_state(Resolver& r, const Word& name) {
  const auto at = r.states.find(name.value);
  if (at != r.states.end()) return at->second;
  std::vector<std::string> known;
  for (const State& state : r.model.states) known.push_back(state.name.value);
  report_undefined(r, "state", name, known);
  return std::nullopt;
}

} // namespace director::compiler
