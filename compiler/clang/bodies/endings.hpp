#pragma once
// SPDX-License-Identifier: MIT
// Finds what runs when an object is destroyed: destructors of its class, of its members and bases, and of what an
// object of the library holds.

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>

#include <vector>

namespace director::scanning {

struct Ending {
  enum class Kind {
    own,      ///< this destructor, or the operator of a deleter
    virtual_, ///< it, or that of a class below
    library,  ///< of a system header
    unread    ///< a deleter that is a template, which only the library's code instantiates
  };
  Kind kind = Kind::own;
  const clang::FunctionDecl* function = nullptr; ///< null: unread
};

/// `by_pointer`: the object may be one of a class below. `held`: where the library's definitions are not read, also of
/// what an object of the library may hold, such as a `std::unique_ptr<Guard>`. Each class once: a tree holds itself.
std::vector<Ending> endings_of(clang::ASTContext& context, clang::QualType type, bool by_pointer, bool held);

} // namespace director::scanning
