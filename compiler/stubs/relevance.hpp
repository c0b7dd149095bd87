#pragma once
// Which files of a program may have to do with a behaviour, by their words alone: those that name its header, its
// namespace, a module or a group. Reading a file with Clang takes a thousand times longer.

#include "compiler/stubs/wanted.hpp"

#include <set>
#include <string>
#include <string_view>

namespace director::compiler::stubs {

/// Identifiers.
std::set<std::string, std::less<>> telling_words(const Wanted& wanted);

bool mentions(std::string_view text, const std::set<std::string, std::less<>>& words);

/// A file in C++, by its name.
bool is_cpp(const std::string& path);

} // namespace director::compiler::stubs
