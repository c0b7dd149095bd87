#pragma once
// SPDX-License-Identifier: MIT
// Finds the values that an expression may have according to the text: what a body sets a state to.

#include <clang/AST/Expr.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace director::scanning {

class Values {
public:
  explicit Values(const clang::ASTContext& context) : context_(context) {}

  /// Names of one value: all enumerators that have it, or a number.
  using Names = std::vector<std::string>;
  /// Empty: it is computed.
  std::optional<std::set<Names>> of(const clang::Expr* expr) const;

  /// The type of the values: the enum, or the struct that a number is put into; empty: another type.
  std::string state_of(const clang::Expr* expr) const;

private:
  std::optional<std::set<Names>> of(const clang::Expr* expr, const clang::EnumDecl* names, int depth) const;

  const clang::ASTContext& context_;
};

} // namespace director::scanning
