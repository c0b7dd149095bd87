// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_names_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/beyond_ascii.hpp"
#include "dsl/lexical/cpp_type.hpp"
#include "dsl/lexical/duration.hpp"
#include "dsl/lexical/names.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// Kinds whose names conflict with the generated class `Behaviour`.
bool lives_beside_the_behaviour(std::string_view kind) {
  return kind == "group" || kind == "state" || kind == "trigger" || kind == "module";
}

/// Kinds that become a type, with a capital letter; other names are unchanged in C++.
bool becomes_a_type(std::string_view kind) { return lives_beside_the_behaviour(kind) || kind == "provider"; }

/// A similar name without conflicts: `LINE_group` for `__LINE__`.
std::string other_name(std::string_view text, std::string_view kind) {
  while (dsl::is_director_macro(capitalised(text))) text.remove_prefix(text.find('_') + 1);
  std::string out;
  for (const char c : text) {
    if (c != '_' || (!out.empty() && out.back() != '_')) out += c;
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  return fmt::format("{}_{}", out.empty() ? "my" : out, kind);
}

/// Why a namespace cannot have this name; empty: it can.
std::string taken(const std::string& part, bool outermost) {
  if (dsl::is_cpp_keyword(part)) return "that is a keyword of C++";
  if (dsl::is_reserved_in_cpp(part))
    return "C++ keeps names with two underscores, or that begin with one and a capital letter, for itself";
  if (dsl::is_cpp_macro(part)) return "that is a macro of the standard headers of C++";
  if (dsl::is_director_macro(part)) return "names that begin with `DIRECTOR_` are macros of Director's own";
  if (outermost && dsl::is_cpp_global(part))
    return "the standard headers of C++, C and POSIX declare something of that name";
  return {};
}

/// Whether the generated code is in a namespace of that name; from outside only the outermost one is found.
bool is_part_of(std::string_view name_space, const dsl::FirstWord& name) {
  for (bool outermost = true;; outermost = false) {
    const std::size_t end = name_space.find("::");
    if (name_space.substr(0, end) == name.word && (outermost || !name.from_outside)) return true;
    if (end == std::string_view::npos) return false;
    name_space.remove_prefix(end + 2);
  }
}

/// Candidates for what was meant.
template <class Table>
std::vector<std::string> names_of(const Resolver& r, const Table& table) {
  std::vector<std::string> out;
  if (!dsl::is_slip(table.size(), r.findings.size())) return out;
  for (const auto& row : table) out.push_back(row.name.value);
  return out;
}

/// Of what a name consists; with the character that it cannot have, which may look like another one, or like nothing.
std::string help_for_name(std::string_view text) {
  const std::string odd = dsl::first_beyond_ascii(text);
  return fmt::format("a name has letters from a to z or A to Z, digits and `_`, {}",
                     odd.empty() ? "and does not begin with a digit" : fmt::format("but not {}, as this one has", odd));
}

} // namespace

bool check_name(Resolver& r, std::string_view kind, const Word& name, bool whole_rule) {
  const std::string& text = name.value;
  if (text.empty()) return false; // the reader has reported that it is missing
  if (!dsl::is_identifier(text)) {
    r.error("reserved_name", name.span, fmt::format("`{}` is no name for a {}", text, kind), help_for_name(text));
    return false;
  }
  std::string why;
  const bool is_type = becomes_a_type(kind), in_cpp = kind != "layer";
  const std::string cpp_name = is_type ? capitalised(text) : text;
  if (dsl::is_cpp_keyword(text)) {
    why = "that is a keyword of C++";
  } else if (in_cpp && dsl::is_reserved_in_cpp(text)) {
    why = "C++ keeps names with two underscores, or that begin with one and a capital letter, for itself";
  } else if (in_cpp && dsl::is_cpp_macro(cpp_name)) {
    why = cpp_name == text ? "that is a macro of the standard headers of C++"
                           : fmt::format("in C++ it becomes `{}`, a macro of the standard headers", cpp_name);
  } else if (in_cpp && dsl::is_director_macro(cpp_name)) {
    why = fmt::format("{}names that begin with `DIRECTOR_` are macros of Director's own",
                      cpp_name == text ? "" : fmt::format("in C++ it becomes `{}`, and ", cpp_name));
  } else if (whole_rule && dsl::is_reserved(text)) {
    why = "that is a word of Director's own";
  } else if (lives_beside_the_behaviour(kind) && capitalised(text) == "Behaviour") {
    why = "the generated class is called `Behaviour`";
  } else if (kind == "pack" && dsl::is_context_word(text)) {
    why = fmt::format("a body's context has a word `{}` of its own", text);
  } else {
    return true;
  }
  r.error("reserved_name", name.span, fmt::format("a {} cannot be called `{}`: {}", kind, text, why),
          fmt::format("choose another name, such as `{}`", other_name(text, kind)));
  return false;
}

bool claim_cpp_name(Resolver& r, std::string_view kind, const Word& name) {
  const auto [at, is_new] =
      r.cpp_names.try_emplace(capitalised(name.value), Resolver::Declared{std::string(kind), name});
  if (is_new) return true;
  const Resolver::Declared& first = at->second;
  const bool same = first.name.value == name.value;
  const bool is_again = same && first.kind == kind;
  std::string message;
  if (is_again) {
    message = fmt::format("the {} `{}` is declared twice", kind, name.value);
  } else {
    message = fmt::format("the {} `{}` and the {} `{}` become one name in C++, `{}`", kind, name.value, first.kind,
                          first.name.value, at->first);
  }
  r.error("redefined_name", name.span, std::move(message),
          is_again ? "give one of them another name, or leave it out" : "give one of them another name")
      .notes.push_back(
          {first.name.span, is_again ? "declared first here" : fmt::format("the {} is declared here", first.kind)});
  return false;
}

void check_namespace(Resolver& r, const Word& name) {
  std::string_view rest = name.value;
  constexpr const char* another = "choose another one: `cpp: {namespace: ...}`";
  if (rest == "main" || rest.starts_with("main::")) {
    r.error("reserved_name", name.span, "a C++ namespace cannot be called `main`: that is the function of the program",
            another);
    return;
  }
  bool outermost = true;
  for (bool more = true; more; outermost = false) {
    const std::size_t end = rest.find("::");
    const std::string part(rest.substr(0, end));
    more = end != std::string_view::npos;
    rest = more ? rest.substr(end + 2) : std::string_view();
    if (!dsl::is_identifier(part)) {
      r.error("reserved_name", name.span, fmt::format("`{}` is no name for a C++ namespace", name.value),
              "one name, or several with `::` between them; each has letters, digits and `_`, and does not begin with "
              "a digit");
    } else if (const std::string why = taken(part, outermost); !why.empty()) {
      r.error("reserved_name", name.span, fmt::format("a C++ namespace cannot be called `{}`: {}", part, why), another);
    } else if (part == "std" || part == "director") {
      r.error("reserved_name", name.span, fmt::format("the C++ of a behaviour cannot be in a namespace `{}`", part),
              another);
    } else {
      continue;
    }
    return;
  }
}

void check_foreign_type(Resolver& r, const Word& type, std::string_view own) {
  std::string text = type.value;
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  if (text.starts_with("::")) text.erase(0, 2);
  const std::string before = r.model.name_space + "::";
  if (text.starts_with(before)) {
    const auto at = r.cpp_names.find(text.substr(before.size()));
    if (at == r.cpp_names.end() || at->second.kind == "state") return;
    const Word& other = at->second.name;
    r.error("redefined_name", type.span,
            fmt::format("`{}` is what the {} `{}` becomes in C++, so it cannot be a type of yours", type.value,
                        at->second.kind, other.value),
            "name your own type, or choose another `cpp: {namespace: ...}`")
        .notes.push_back({other.span, fmt::format("the {} is declared here", at->second.kind)});
    return;
  }
  for (const dsl::FirstWord& first : dsl::first_words(type.value)) {
    if (first.whole && is_part_of(r.model.name_space, first)) {
      r.error("redefined_name", type.span,
              fmt::format("`{}` is a namespace of the generated C++, `{}`, so a type of yours is not found by it",
                          first.word, r.model.name_space),
              "name your own type, or choose another `cpp: {namespace: ...}`");
      return;
    }
    const auto at = r.cpp_names.find(first.word);
    if (first.from_outside || at == r.cpp_names.end() || first.word == own) continue;
    const Word& other = at->second.name;
    r.error("redefined_name", type.span,
            fmt::format("`{}` in `{}` is what the {} `{}` becomes in C++, so a type of yours is not found by it",
                        first.word, type.value, at->second.kind, other.value),
            fmt::format("write `::{}` if yours is in no namespace, else its whole name", first.word))
        .notes.push_back({other.span, fmt::format("the {} is declared here", at->second.kind)});
    return;
  }
}

void report_undefined(Resolver& r, std::string_view kind, const Word& name, const std::vector<std::string>& known) {
  Diagnostic& finding =
      r.error("undefined_name", name.span, fmt::format("there is no {} called `{}`", kind, name.value),
              "`directorc checks` lists them");
  const auto other = r.cpp_names.find(capitalised(name.value));
  if (other != r.cpp_names.end() && other->second.name.value == name.value && other->second.kind != kind)
    finding.notes.push_back(
        {other->second.name.span, fmt::format("this `{}` is a {}", name.value, other->second.kind)});
  const std::string group = name.value.substr(0, name.value.find('.'));
  if (!dsl::first_beyond_ascii(name.value).empty()) {
    finding.help = help_for_name(name.value);
  } else if (kind == "group" && group.size() < name.value.size() && r.groups.count(group) != 0) {
    finding.help = fmt::format("name the group alone, `{}`: which provider runs is not for others to say", group);
  } else if (kind == "trigger" && dsl::parse_duration(name.value)) {
    finding.help = fmt::format("a period has a key of its own: `every: {}`", name.value);
  } else if (const auto nearest = dsl::suggest(name.value, known)) {
    finding.help = fmt::format("did you mean `{}`?", *nearest);
  } else if (kind == "group") {
    finding.help = r.main.roots ? "declare it under `groups`, or import a file that does" // nothing would provide it
                                : "declare it under `groups`, import a file that does, or list it under `extern`";
  } else if (kind == "state" || kind == "trigger") {
    finding.help = fmt::format("declare it under `{}s`, or import a file that does", kind);
  } else if (kind == "layer") {
    finding.help = "list it under `layers`";
  }
}

std::optional<GroupId> find_group(Resolver& r, const Word& name) {
  const auto at = r.groups.find(name.value);
  if (at != r.groups.end()) return at->second;
  report_undefined(r, "group", name, names_of(r, r.model.groups));
  return std::nullopt;
}

std::optional<StateId> find_state(Resolver& r, const Word& name) {
  const auto at = r.states.find(name.value);
  if (at != r.states.end()) return at->second;
  report_undefined(r, "state", name, names_of(r, r.model.states));
  return std::nullopt;
}

} // namespace director::compiler
