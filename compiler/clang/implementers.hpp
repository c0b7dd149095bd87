#pragma once
// SPDX-License-Identifier: MIT
// Which classes of the user implement the modules of a behaviour, and which functions of theirs are, or might be meant
// as, its bodies: names, places, and what has to be known to put another function beside them.

#include "compiler/clang/findings.hpp"
#include "compiler/clang/structure.hpp"

#include <clang/AST/ASTConsumer.h>

#include <memory>

namespace clang {
class CompilerInstance;
} // namespace clang

namespace director::scanning {

/// `interfaces`: the modules, by qualified names. `header`: the path of the generated one, in which nothing is the
/// user's. All must outlive it, `structure` is complete when the tree is.
std::unique_ptr<clang::ASTConsumer> find_implementers(Findings& out, const std::set<std::string>& interfaces,
                                                      const std::string& header, const Structure& structure,
                                                      clang::CompilerInstance& compiler);

} // namespace director::scanning
