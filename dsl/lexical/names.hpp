#pragma once
// SPDX-License-Identifier: MIT
// The rules for names. Source: the language page, "Names". Which of them apply to a name is decided by the stage that
// resolves it.

#include <string>
#include <string_view>

namespace director::dsl {

/// [A-Za-z_][A-Za-z0-9_]*
bool is_identifier(std::string_view text);
/// Of C++20, with its alternative spellings (`and`, `xor`); they end where a name becomes a C++ name.
bool is_cpp_keyword(std::string_view text);
/// Whether C++ reserves it for the compiler and its library: `__LINE__`, `_Complex`.
bool is_reserved_in_cpp(std::string_view text);
/// Whether a standard header defines a macro of this name, like `EOF` and `errno`.
bool is_cpp_macro(std::string_view text); // standard_names.cpp, as the next one
/// Whether the headers of the standard or of POSIX declare it in the global namespace, like `abs`, `FILE` and `stat`.
bool is_cpp_global(std::string_view text);
/// Whether it begins with `DIRECTOR_`, like all macros of the runtime, and those that a program defines for it.
bool is_director_macro(std::string_view text);
/// `start`, `stop`, `default`, `root`, `limbo`, with either case of the first letter.
bool is_reserved(std::string_view text);
/// Whether it is a member of a run's context (`task`, `request`, `done` ...): no pack can have its name.
bool is_context_word(std::string_view text);
/// Whether tools that follow YAML 1.1, and no others, read it as a boolean: `yes`, `No`, `OFF`, `y`.
bool is_old_boolean(std::string_view text);
/// Whether all YAML tools read it as a boolean, and this language does not: `True`, `FALSE`.
bool is_other_boolean(std::string_view text);
/// The name with its first letter in upper case, as in C++.
std::string capitalised(std::string_view name);

} // namespace director::dsl
