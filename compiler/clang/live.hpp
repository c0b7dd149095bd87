#pragma once
// SPDX-License-Identifier: MIT
// What of a function can run, as far as its text alone decides: what stands under a condition that is a constant,
// behind a `return`, behind a loop that never ends, or in a case that is never taken does not.

#include <clang/AST/Decl.h>
#include <clang/AST/Stmt.h>

#include <unordered_set>

namespace director::scanning {

class Live {
public:
  /// `function`: with a body, of no template.
  explicit Live(const clang::FunctionDecl& function);

  /// Also of what is no part of the function: false only where it is known.
  bool runs(const clang::Stmt* stmt) const { return dead_.count(stmt) == 0; }

  /// Its closing brace can be reached. What throws, ends the program or is a switch over all values of an enum does not
  /// lead there.
  bool reaches_end() const { return reaches_end_; }

private:
  std::unordered_set<const clang::Stmt*> dead_;
  bool reaches_end_ = false;
};

} // namespace director::scanning
