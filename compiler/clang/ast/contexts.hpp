#pragma once
// SPDX-License-Identifier: MIT
// Recognises the parts of a program that belong to Director: contexts, which bodies get, and the generated interfaces
// that modules implement.
//
// A context, such as soccer::Walk::Halting, is recognised by its base director::Context<Facts<soccer::Walk::Halting>,
// ...>, independent of names in the user's code.

#include <clang/AST/DeclCXX.h>

#include <map>
#include <string>
#include <utility>

namespace director::scanning {

bool is_system(const clang::Decl& decl);    ///< of a system header
bool is_standard(const clang::Decl& decl);  ///< of a system header, in a namespace of the C++ library
bool is_directors(const clang::Decl& decl); ///< in namespace director, at any depth

/// The type without const, references and pointers.
clang::QualType bare(clang::QualType type);

/// The name of the provider's or handler's context that the type is; empty: it is none.
std::string context_of(clang::QualType type);
/// Whether a context may be reached through a value. A type is searched once.
class Carriers {
public:
  bool has(clang::QualType type);
  /// ... also if a cast hides its type: `void*`, a base class.
  bool has(const clang::Expr& value);
  /// ... in another way than through what a lambda captures: the effect of a lambda is known.
  bool has_outside_of_lambdas(const clang::Expr& value);
  /// ... and than as a parameter of a function.
  bool holds(const clang::Expr& value);
  bool holds(clang::QualType type);

private:
  enum class Skipped { nothing, lambdas, code };
  bool has(clang::QualType type, Skipped skipped);
  bool has(const clang::Expr& value, Skipped skipped);
  friend class ContextSearch;

  std::map<std::pair<void*, Skipped>, bool> known_; ///< by type
};
/// The context of the only parameter of a body; empty: it has another one, or several.
std::string parameter_context(const clang::CXXMethodDecl& method);

/// Whether the name is `provide`, `start` or `stop`.
bool is_called_like_body(const clang::NamedDecl& decl);

/// A generated module: pure virtual functions that take contexts.
bool is_interface(const clang::CXXRecordDecl& record);
/// The first interface that a class implements, through any bases; null: none.
const clang::CXXRecordDecl* interface_of(const clang::CXXRecordDecl& record);
/// The function that an interface of the class declares for this context, with this name; null: none.
const clang::CXXMethodDecl* declared_for(const clang::CXXRecordDecl& record, llvm::StringRef name,
                                         const std::string& context);
/// The function of an interface that this one overrides; null: none.
const clang::CXXMethodDecl* promised_by(const clang::CXXMethodDecl& method);

} // namespace director::scanning
