#pragma once
// compile_commands.json: how each file of a build is compiled. Source:
// clang.llvm.org/docs/JSONCompilationDatabase.html.

#include "dsl/result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct CompileCommand {
  std::string file;               ///< absolute
  std::string directory;          ///< absolute
  std::vector<std::string> words; ///< the compiler first
  bool operator==(const CompileCommand&) const = default;
};

/// The text of the file; or what is wrong with it.
dsl::Result<std::vector<CompileCommand>, std::string> read_compile_commands(std::string_view text);

/// Words of a command line, as a POSIX shell would take them apart; nothing else of a shell is known.
std::vector<std::string> split_command(std::string_view line);

} // namespace director::compiler
