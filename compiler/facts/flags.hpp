#pragma once
// SPDX-License-Identifier: MIT
// The flags of a user's compiler, made fit for Clang: what only g++ knows is left out, what is written (objects, lists
// of dependencies) too; macros, include paths, the standard, the sysroot and the target stay. A g++, also one for
// another machine, is asked once for its target and for the folders that it looks into unasked.

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

/// `command`: the compiler (a launcher such as ccache before it is passed over) and its words.
Flags fit_for_clang(const std::vector<std::string>& command);

/// What a compiler says with -v.
struct Habits {
  std::string target;                ///< `arm-none-eabi`
  std::vector<std::string> includes; ///< without the compiler's own, such as that of its stddef.h
};
Habits read_habits(const std::string& text);

/// Asks compilers, each way of calling one once.
class Compilers {
public:
  explicit Compilers(Programs& programs) : programs_(programs) {}
  /// The words with what the compiler does unasked said aloud. What cannot be asked, and a clang, is left as it is.
  std::vector<std::string> complete(const Flags& flags);

private:
  Programs& programs_;
  std::map<std::string, Habits> known_;
};

/// Where `#include "..."` looks, or `#include <...>` where it is `angled`, in order: absolute folders.
std::vector<std::string> include_folders(const std::vector<std::string>& words, const std::string& directory,
                                         bool angled = false);

/// Files that are read before the source, as `-include` says: absolute, in order. Those that no folder has are left out
/// by whoever reads them.
std::vector<std::string> forced_includes(const std::vector<std::string>& words, const std::string& directory);

} // namespace director::compiler
