#pragma once
// SPDX-License-Identifier: MIT
// Converts the flags of a user's compiler for Clang: options that only g++ has and options for outputs (objects, lists
// of dependencies) are left out; macros, include paths, the standard, the sysroot and the target stay. A g++, also a
// cross compiler, is called once for its default target and include folders.

#include "compiler/facts/compile_commands.hpp"
#include "compiler/facts/programs.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler {

struct Flags {
  std::string compiler;           ///< as it was called; empty: none was named
  std::vector<std::string> words; ///< for Clang, without the file
  bool operator==(const Flags&) const = default;
};

/// `command`: the compiler (a launcher such as ccache before it is skipped) and its arguments.
Flags fit_for_clang(const std::vector<std::string>& command);
/// ... of an entry: a compiler with a relative path is in the entry's folder, and a file of C is read as one.
Flags fit_for_clang(const CompileCommand& command);

/// Whether an entry compiles another language than C++: C, or assembly.
bool is_of_c(const CompileCommand& command);

/// What a compiler reports with -v.
struct Habits {
  std::string target;                ///< `arm-none-eabi`
  std::vector<std::string> includes; ///< without the compiler's own, such as that of its stddef.h
};
Habits read_habits(const std::string& text);

/// Queries compilers, once for each way of calling one.
class Compilers {
public:
  explicit Compilers(Programs& programs) : programs_(programs) {}
  /// The arguments with the compiler's defaults made explicit. Unchanged for a clang, and if the compiler cannot be
  /// called.
  std::vector<std::string> complete(const Flags& flags);

private:
  Programs& programs_;
  std::map<std::string, Habits> known_;
};

/// The folders for `#include "..."`, or for `#include <...>` if it is `angled`, in order: absolute.
std::vector<std::string> include_folders(const std::vector<std::string>& words, const std::string& directory,
                                         bool angled = false);

/// Files that are included before the source, by `-include`: absolute, in order. The caller ignores those that do not
/// exist.
std::vector<std::string> forced_includes(const std::vector<std::string>& words, const std::string& directory);

} // namespace director::compiler
