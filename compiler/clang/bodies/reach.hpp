#pragma once
// SPDX-License-Identifier: MIT
// Finds the effects of a function of the standard library, or of another system header: whether its definition, or what
// that calls, uses memory, a lock, a file, and which functions of the user it calls back. Definitions are in headers,
// like templates; compiled functions are in blocking.hpp by name.

#include <clang/AST/Decl.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace director::scanning {

struct Reached {
  std::string_view why;                            ///< as in blocking.hpp; empty: unknown
  std::vector<const clang::FunctionDecl*> users;   ///< of the user's, which it calls
  std::vector<const clang::FunctionDecl*> unknown; ///< compiled, with unknown effects
  bool has_definition = false;                     ///< it was examined
};

/// The object of which a method is called, also by an operator; null: none.
const clang::Expr* object_of(const clang::CallExpr& call);
/// The function that a call of a method runs, as far as the type of its object decides that; null: any overrider may.
const clang::CXXMethodDecl* target_of(const clang::CallExpr& call, const clang::CXXMethodDecl& method);

/// Whether it is compiled, and may do anything. A C function of glibc's headers that cannot throw cannot be cancelled
/// while it waits either; the exceptions have known names.
bool may_do_anything(const clang::FunctionDecl& function);
/// What is known of it by name.
std::string_view known_effect(const clang::FunctionDecl& function);

class Reach {
public:
  /// `callee`: of a system header. `destroys`: the call is a destruction, for which what the library frees does not
  /// count.
  const Reached& of(const clang::FunctionDecl& callee, bool destroys = false);

private:
  struct Edge {
    const clang::FunctionDecl* to = nullptr;
    bool destroys = false;
    bool operator<(const Edge& other) const { return std::tie(to, destroys) < std::tie(other.to, other.destroys); }
  };
  friend class EdgeReader;
  struct Step {
    std::string_view why; ///< of its own: `new`, `delete`
    std::vector<Edge> edges;
  };
  const Step& step(const clang::FunctionDecl& definition);
  Reached walk(const Edge& from);

  std::map<const clang::FunctionDecl*, Step> steps_;
  std::map<Edge, Reached> known_;
};

} // namespace director::scanning
