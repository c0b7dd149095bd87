#pragma once
// SPDX-License-Identifier: MIT
// Runs Clang's frontend on one file, as the compiler of this version would.

#include <llvm/ADT/IntrusiveRefCntPtr.h>

#include <memory>
#include <string>
#include <vector>

namespace clang {
class DiagnosticConsumer;
class FrontendAction;
} // namespace clang
namespace llvm::vfs {
class FileSystem;
} // namespace llvm::vfs

namespace director::scanning {

struct Invocation {
  std::string file;
  std::string directory;              ///< base of relative paths
  std::vector<std::string> arguments; ///< without the compiler and the file
};

using Files = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

/// The files of the disk, except pipes: opening one would wait for a writer, for ever if there is none.
Files ordinary_files();

/// Caches what Clang's driver makes of a command line: running it takes longer than reading a small file, and most
/// files of a program are compiled alike. For one thread.
class Frontend {
public:
  Frontend();
  ~Frontend();
  Frontend(const Frontend&) = delete;
  Frontend& operator=(const Frontend&) = delete;

  /// The working directory of `files` becomes that of the invocation. Warnings are off, and errors are reported without
  /// a limit. False: there were errors.
  bool run(const Invocation& invocation, const Files& files, clang::FrontendAction& action,
           clang::DiagnosticConsumer& faults);

private:
  struct Known;
  std::unique_ptr<Known> known_;
};

/// Drops what a g++ supports and Clang does not, an option or a processor, according to errors without a place. False:
/// there is none.
bool drop_unknown(std::vector<std::string>& arguments, const std::vector<std::string>& errors);

} // namespace director::scanning
