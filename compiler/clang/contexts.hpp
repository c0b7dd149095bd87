#pragma once
// SPDX-License-Identifier: MIT
// What of a program is Director's: contexts, which bodies get, and the generated interfaces that modules implement.
//
// A context, such as soccer::Walk::Halting, is known by its base director::Context<Facts<soccer::Walk::Halting>, ...>,
// whatever the function that has it calls it.

#include <clang/AST/DeclCXX.h>

#include <string>

namespace director::scanning {

bool is_system(const clang::Decl& decl);    ///< of a system header
bool is_directors(const clang::Decl& decl); ///< in namespace director, at any depth

/// Without const, references and pointers.
clang::QualType bare(clang::QualType type);

/// The provider's or handler's context that this is, by name; empty: it is none.
std::string context_of(clang::QualType type);
/// Whoever has such a value may have a context by it.
bool carries_context(clang::QualType type);
/// Of the one parameter of a body; empty: it has another one, or several.
std::string parameter_context(const clang::CXXMethodDecl& method);

/// `provide`, `start` or `stop`.
bool is_called_like_body(const clang::NamedDecl& decl);

/// A generated module: pure virtual functions that take contexts.
bool is_interface(const clang::CXXRecordDecl& record);
/// The first one that a class implements, through whatever bases; null: none.
const clang::CXXRecordDecl* interface_of(const clang::CXXRecordDecl& record);
/// What an interface that the class implements declares for this context, under this name; null: nothing.
const clang::CXXMethodDecl* declared_for(const clang::CXXRecordDecl& record, llvm::StringRef name,
                                         const std::string& context);
/// The function of an interface that this one overrides; null: none.
const clang::CXXMethodDecl* promised_by(const clang::CXXMethodDecl& method);

} // namespace director::scanning
