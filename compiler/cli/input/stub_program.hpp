#pragma once
// SPDX-License-Identifier: MIT
// Finds the C++ for `directorc stubs`: the texts below a folder, and how to read those that may concern the behaviour.

#include "compiler/cli/options/commands.hpp"
#include "compiler/stubs/insertion.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/scan.hpp"

#include <string>
#include <vector>

namespace director::compiler::cli {

/// How one file is compiled.
struct Compiled {
  std::string path;
  std::string directory;
  std::vector<std::string> flags; ///< without the compiler, the file, and the output
};

struct Program {
  std::string folder;             ///< its whole path, after symbolic links
  stubs::Texts texts;             ///< all C++ below it, by whole paths
  std::vector<Compiled> compiled; ///< the content of compile_commands.json
  std::vector<std::string> default_flags;
  std::vector<stubs::Remark> unread; ///< C++ files that cannot be read, and why
  std::string fault;                 ///< why it cannot be read as it is compiled; else empty
  std::vector<stubs::Unit> units;    ///< to be read: sources first, then headers that none of them may include
};

Program read_program(const Stubs& request, const stubs::Wanted& wanted, Console& console);

/// Adds files that may have classes derived from these, by their text, and are not read yet. False: there are none.
bool add_heirs(Program& program, const std::vector<stubs::FoundClass>& classes);

/// How a file is read: as it is compiled, or otherwise like the nearest compiled file.
stubs::Unit unit_for(const Program& program, const std::string& path);

} // namespace director::compiler::cli
