#pragma once
// SPDX-License-Identifier: MIT
// Selects the files of a program that may concern a behaviour, by their words alone: those that name its header, its
// namespace, a module or a group. Reading a file with Clang takes a thousand times longer.

#include "compiler/stubs/wanted.hpp"

#include <set>
#include <string>
#include <string_view>

namespace director::compiler::stubs {

using Words = std::set<std::string, std::less<>>;

/// Identifiers of which every relevant source has at least one.
Words identifying_words(const Wanted& wanted);

/// Likewise for a header with a class: the names of its interfaces. A header that no file includes may not compile by
/// itself, so it is read only if necessary.
Words interface_words(const Wanted& wanted);

bool mentions(std::string_view text, const Words& words);

/// Whether a class of this name, `Legs`, seems to be a base of another one there: the word is in the place of a base.
bool derives(std::string_view text, const Words& names);

/// A file in C++, by its name.
bool is_cpp(const std::string& path);

} // namespace director::compiler::stubs
