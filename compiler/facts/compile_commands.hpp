#pragma once
// SPDX-License-Identifier: MIT
// compile_commands.json: how each file of a build is compiled. Source:
// clang.llvm.org/docs/JSONCompilationDatabase.html.

#include "dsl/file_access.hpp"
#include "dsl/result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct CompileCommand {
  std::string file;               ///< absolute
  std::string directory;          ///< absolute
  std::vector<std::string> words; ///< the compiler first
  std::string output{};           ///< what it is compiled to; empty: nobody says so
  bool operator==(const CompileCommand&) const = default;
};

/// The text of the file; or what is wrong with it. Response files are not read yet.
dsl::Result<std::vector<CompileCommand>, std::string> read_compile_commands(std::string_view text);

struct LoadedCommands {
  std::string path; ///< of the file
  std::vector<CompileCommand> commands;
  std::string fault;    ///< why there are none, in a sentence that names the file; else empty
  bool was_read = true; ///< though it may be wrong
};

/// Why the compile_commands.json of this folder cannot be read, and what to do.
std::string fault_of_build(const std::string& build, const dsl::FileError& error, dsl::FileAccess& files);

/// That of a build's folder.
LoadedCommands load_compile_commands(const std::string& build, dsl::FileAccess& files);

/// The nearest, looked for as clangd does: in the folder and those above it, and in their folders `build`. `folder` is
/// absolute. Where none can be read, the fault names none.
LoadedCommands find_compile_commands(const std::string& folder, dsl::FileAccess& files);

/// The words with those of response files, `@flags.rsp`, in their place, as g++ and Clang read these. `directory`:
/// where relative paths begin. What cannot be read stays as it is.
std::vector<std::string> with_response_files(const std::vector<std::string>& words, const std::string& directory,
                                             dsl::FileAccess& files);

/// Words of a command line, as a POSIX shell would take them apart; nothing else of a shell is known.
std::vector<std::string> split_command(std::string_view line);

} // namespace director::compiler
