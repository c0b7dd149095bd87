#pragma once
// SPDX-License-Identifier: MIT
// Finds the user's classes that implement the modules of a behaviour, and their functions that are bodies, or may be
// meant as such: names, places, and what is needed to add another function beside them.

#include "compiler/clang/findings.hpp"
#include "compiler/clang/parse/structure.hpp"

#include <clang/AST/ASTConsumer.h>

#include <memory>

namespace clang {
class CompilerInstance;
} // namespace clang

namespace director::scanning {

/// `interfaces`: the modules, by qualified names. `header`: the path of the generated one, which has nothing of the
/// user's. All must outlive it; `structure` is complete when the tree is.
std::unique_ptr<clang::ASTConsumer> find_implementers(Findings& out, const std::set<std::string>& interfaces,
                                                      const std::string& header, const Structure& structure,
                                                      clang::CompilerInstance& compiler);

} // namespace director::scanning
