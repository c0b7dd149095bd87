#pragma once
// SPDX-License-Identifier: MIT
// compile_commands.json: how each file of a build is compiled. Source:
// clang.llvm.org/docs/JSONCompilationDatabase.html.

#include "dsl/source/file_access.hpp"
#include "dsl/source/result.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct CompileCommand {
  std::string file;               ///< absolute
  std::string directory;          ///< absolute
  std::vector<std::string> words; ///< the compiler first
  std::string output{};           ///< output file; empty: not given
  bool operator==(const CompileCommand&) const = default;
};

/// Why a text has no commands.
struct CommandsFault {
  std::string message;
  std::optional<std::size_t> offset{}; ///< where, if the message does not say it
  bool operator==(const CommandsFault&) const = default;
};

/// The commands in the text; or its fault. Response files are not read yet.
dsl::Result<std::vector<CompileCommand>, CommandsFault> read_compile_commands(std::string_view text);

struct LoadedCommands {
  std::string path; ///< of the file
  std::vector<CompileCommand> commands;
  std::string fault;    ///< why there are none, in a sentence that names the file; otherwise empty
  bool was_read = true; ///< though it may have faults
};

/// Why the compile_commands.json of this folder cannot be read, and what to do.
std::string fault_of_build(const std::string& build, const dsl::FileError& error, dsl::FileAccess& files);

/// That of a build's folder.
LoadedCommands load_compile_commands(const std::string& build, dsl::FileAccess& files);

/// The nearest one, searched as clangd does: in the folder and those above it, and in their folders `build`. `folder`
/// is absolute. If none can be read, the fault names none.
LoadedCommands find_compile_commands(const std::string& folder, dsl::FileAccess& files);

/// The arguments with those of response files, `@flags.rsp`, in their place, as g++ and Clang read these. `directory`:
/// base of relative paths. What cannot be read stays unchanged.
std::vector<std::string> with_response_files(const std::vector<std::string>& words, const std::string& directory,
                                             dsl::FileAccess& files);

/// Arguments of a command line, split as by a POSIX shell, without any other feature of a shell. `"\$$"`, which CMake
/// writes for a `$`, is one, too.
std::vector<std::string> split_command(std::string_view line);

} // namespace director::compiler
