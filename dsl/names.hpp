#pragma once
// SPDX-License-Identifier: MIT
// What a name may look like. Source: the language page, "Names". Which of these rules a thing must follow is decided
// where names are resolved.

#include <string>
#include <string_view>

namespace director::dsl {

/// [A-Za-z_][A-Za-z0-9_]*
bool is_identifier(std::string_view text);
/// Of C++20, with its alternative spellings (`and`, `xor`); they end where a name becomes a C++ name.
bool is_cpp_keyword(std::string_view text);
/// What the compiler and its library keep for themselves: `__LINE__`, `_Complex`.
bool is_reserved_in_cpp(std::string_view text);
/// Of the standard headers, like `EOF` and `errno`.
bool is_cpp_macro(std::string_view text); // standard_names.cpp, as the next one
/// What the standard headers and those of POSIX declare outside of all namespaces, like `abs`, `FILE` and `stat`.
bool is_cpp_global(std::string_view text);
/// Begins with `DIRECTOR_`, like all macros of the runtime, and what a program defines for it.
bool is_director_macro(std::string_view text);
/// `start`, `stop`, `default`, `root`, `limbo`, with either case of the first letter.
bool is_reserved(std::string_view text);
/// What a run's context is asked for (`task`, `request`, `done` ...): no pack can be called so.
bool is_context_word(std::string_view text);
/// What YAML 1.1 tools take for booleans: yes, no, on, off, y, n, in any case.
bool is_yaml_word_trap(std::string_view text);
/// With its first letter in upper case: what a name becomes in C++.
std::string capitalised(std::string_view name);

} // namespace director::dsl
