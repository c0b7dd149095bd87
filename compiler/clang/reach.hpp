#pragma once
// SPDX-License-Identifier: MIT
// What a function of the standard library, or of another system header, comes to: whether its definition, or what that
// calls, takes memory, a lock, a file, and which functions of the user it calls back. Definitions stand in headers, as
// templates do; of what is compiled already, blocking.hpp knows names.

#include <clang/AST/Decl.h>
#include <clang/AST/DeclCXX.h>

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace director::scanning {

struct Reached {
  std::string_view why;                            ///< as blocking.hpp says it; empty: nothing is known
  std::vector<const clang::FunctionDecl*> users;   ///< of the user's, which it calls
  std::vector<const clang::FunctionDecl*> unknown; ///< compiled already, and nobody knows what they do
  bool has_definition = false;                     ///< it was looked into
};

/// What is known of it without a look.
std::string_view known_effect(const clang::FunctionDecl& function);

class Reach {
public:
  /// `callee`: of a system header. `destroys`: it is called where an object goes, and what the library frees then does
  /// not count.
  const Reached& of(const clang::FunctionDecl& callee, bool destroys = false);

private:
  struct Edge {
    const clang::FunctionDecl* to = nullptr;
    bool destroys = false;
    bool operator<(const Edge& other) const { return std::tie(to, destroys) < std::tie(other.to, other.destroys); }
  };
  friend class EdgeReader;
  struct Step {
    std::string_view why; ///< of what it does itself: `new`, `delete`
    std::vector<Edge> edges;
  };
  const Step& step(const clang::FunctionDecl& definition);
  Reached walk(const Edge& from);

  std::map<const clang::FunctionDecl*, Step> steps_;
  std::map<Edge, Reached> known_;
};

} // namespace director::scanning
