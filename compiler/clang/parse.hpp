#pragma once
// SPDX-License-Identifier: MIT
// One translation unit as Clang understands it, read quickly: bodies of functions in system headers are passed over,
// and what looks at the tree begins at what no system header declares.

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
  std::string directory;              ///< absolute; relative paths in the arguments begin here
  std::vector<std::string> arguments; ///< fit for Clang, without the compiler and the file
  std::string text;                   ///< if not empty: what the file holds, whatever lies on the disk
  bool is_deep = false;               ///< bodies of functions in system headers are read too
  /// A name that is not there is taken for the one most like it, and the fault says for which. Of bodies that would
  /// tell what nobody wrote: where a group was renamed, the body of the old name seems to be a second one of the new.
  bool corrects_names = false;
};

struct Included {
  std::string path; ///< absolute
  bool system = false;
};

struct Fault {
  std::string message;
  std::string file; ///< absolute; empty: of the command line
  unsigned line = 0;
};

struct Reading {
  std::vector<Included> files; ///< all that were read, in order of path
  std::vector<Fault> errors;
};

/// Calls `look` with the tree, also where there were errors; not where there is no tree at all. `complete`, before it,
/// may have templates instantiated that nothing uses.
Reading parse(const Unit& unit, const std::function<void(clang::ASTContext&)>& look,
              const std::function<void(clang::Sema&)>& complete = {});

} // namespace director::scanning
