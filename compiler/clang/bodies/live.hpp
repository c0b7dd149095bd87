#pragma once
// SPDX-License-Identifier: MIT
// Finds the code of a function that can run, as far as its text alone decides: not what is under a constant condition,
// behind a `return` or an endless loop, or in a case that is never taken.

#include <clang/AST/Decl.h>
#include <clang/AST/Stmt.h>

#include <unordered_set>

namespace director::scanning {

class Live {
public:
  /// `function`: with a body, no template.
  explicit Live(const clang::FunctionDecl& function);

  /// True also for code outside of the function: false only if it is known.
  bool runs(const clang::Stmt* stmt) const { return dead_.count(stmt) == 0; }

  /// Whether its closing brace can be reached. A throw, an end of the program, or a switch over all values of an enum
  /// does not lead there.
  bool reaches_end() const { return reaches_end_; }

private:
  std::unordered_set<const clang::Stmt*> dead_;
  bool reaches_end_ = false;
};

} // namespace director::scanning
