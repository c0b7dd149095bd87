#pragma once
// SPDX-License-Identifier: MIT
// Whether a function of the standard library, whose body is not read, may run code of the user's: constructors,
// operators and other functions of the classes that its types name, or what a pointer or a `std::function` leads to.

#include <clang/AST/Decl.h>
#include <clang/AST/Type.h>

#include <vector>

namespace director::scanning {

/// `given`: the types of the arguments and of the object, without those whose code is read where they are written.
bool may_call_back(const clang::FunctionDecl& callee, const std::vector<clang::QualType>& given);

} // namespace director::scanning
