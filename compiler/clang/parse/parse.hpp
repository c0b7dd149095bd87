#pragma once
// SPDX-License-Identifier: MIT
// Parses one translation unit quickly: bodies of functions in system headers are skipped, and visitors start at
// declarations outside of system headers.

#include <functional>
#include <string>
#include <vector>

namespace clang {
class ASTContext;
class Sema;
} // namespace clang

namespace director::scanning {

struct Unit {
  std::string file;                   ///< absolute
  std::string directory;              ///< absolute; base of relative paths in the arguments
  std::vector<std::string> arguments; ///< fit for Clang, without the compiler and the file
  std::string text;                   ///< if not empty: the content of the file, instead of the one on the disk
  bool is_deep = false;               ///< bodies of functions in system headers are read too
  /// Clang replaces an unknown name by the most similar one, and reports that. For bodies that would be wrong: after a
  /// group is renamed, the body of the old name would look like a second one of the new.
  bool corrects_names = false;
};

struct Included {
  std::string path; ///< absolute
  bool system = false;
};

struct Fault {
  std::string message;
  std::string file; ///< absolute; empty: of the command line
  unsigned line = 0, column = 0;
};

struct Reading {
  std::vector<Included> files;     ///< all that were read, in order of path
  std::vector<std::string> absent; ///< paths that were looked for in vain, absolute: had they existed, they might count
  std::vector<Fault> errors;
};

/// Calls `look` with the tree, also after errors; not if there is no tree at all. `complete`, before it, may have
/// templates instantiated that nothing uses.
Reading parse(const Unit& unit, const std::function<void(clang::ASTContext&)>& look,
              const std::function<void(clang::Sema&)>& complete = {});

} // namespace director::scanning
