#pragma once
// SPDX-License-Identifier: MIT
// Clang's frontend over one file, as the compiler of this version would be called for it.

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
  std::string directory;              ///< relative paths begin here
  std::vector<std::string> arguments; ///< without the compiler and the file
};

using Files = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

/// Those of the disk, but for pipes: to open one would wait for who writes to it, for ever if nobody does.
Files ordinary_files();

/// Remembers what Clang's driver made of a command line: to ask it takes longer than to read a small file, and most
/// files of a program are compiled alike. For one thread.
class Frontend {
public:
  Frontend();
  ~Frontend();
  Frontend(const Frontend&) = delete;
  Frontend& operator=(const Frontend&) = delete;

  /// The working directory of `files` becomes that of the invocation. Warnings are off, and errors are told however
  /// many there are. False: there were errors.
  bool run(const Invocation& invocation, const Files& files, clang::FrontendAction& action,
           clang::DiagnosticConsumer& faults);

private:
  struct Known;
  std::unique_ptr<Known> known_;
};

/// Drops what a g++ knows and Clang does not, an option or a processor, as errors without a place say. False: there is
/// none.
bool drop_unknown(std::vector<std::string>& arguments, const std::vector<std::string>& errors);

} // namespace director::scanning
