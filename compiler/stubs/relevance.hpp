#pragma once
// SPDX-License-Identifier: MIT
// Which files of a program may have to do with a behaviour, by their words alone: those that name its header, its
// namespace, a module or a group. Reading a file with Clang takes a thousand times longer.

#include "compiler/stubs/wanted.hpp"

#include <set>
#include <string>
#include <string_view>

namespace director::compiler::stubs {

using Words = std::set<std::string, std::less<>>;

/// Identifiers of which a source that may have to do with it has one at least.
Words identifying_words(const Wanted& wanted);

/// Likewise a header with a class: what its interfaces are called. A header that nobody includes may be no whole text
/// by itself, so it is read only if it has to be.
Words interface_words(const Wanted& wanted);

bool mentions(std::string_view text, const Words& words);

/// A class of this name, `Legs`, seems to be a base of another one there: the word stands where bases do.
bool derives(std::string_view text, const Words& names);

/// A file in C++, by its name.
bool is_cpp(const std::string& path);

} // namespace director::compiler::stubs
