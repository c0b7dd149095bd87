// Header: compiler/clang/ast/places.hpp. Test: tests/compiler/clang.
// SPDX-License-Identifier: MIT
#include "compiler/clang/ast/places.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/Lex/Lexer.h>

#include <filesystem>
#include <system_error>

namespace director::scanning {

Json Places::of(clang::SourceLocation begin, clang::SourceLocation end) {
  const clang::SourceManager& sources = context_.getSourceManager();
  const clang::SourceLocation from = sources.getFileLoc(begin);
  clang::SourceLocation to =
      clang::Lexer::getLocForEndOfToken(sources.getFileLoc(end), 0, sources, context_.getLangOpts());
  const auto [file, first] = sources.getDecomposedLoc(from);
  if (to.isInvalid() || sources.getFileID(to) != file || sources.getFileOffset(to) < first)
    to = clang::Lexer::getLocForEndOfToken(from, 0, sources, context_.getLangOpts());
  const std::int64_t last = to.isValid() ? sources.getFileOffset(to) : first;
  std::string path;
  if (const clang::OptionalFileEntryRef entry = sources.getFileEntryRefForID(file)) path = entry->getName().str();
  if (!path.starts_with('/')) path = directory_ + "/" + path;
  return Json::list({Json::number(row_of(path)), Json::number(first), Json::number(last)});
}

/// A file has one row, however its name is written in the includes that lead there.
std::int64_t Places::row_of(const std::string& path) {
  const auto [row, is_new] = rows_.emplace(path, static_cast<std::int64_t>(files_.size()));
  if (!is_new) return row->second;
  // Behind a linked folder, `..` may lead elsewhere.
  const std::string normal = std::filesystem::path(path).lexically_normal().string();
  std::error_code fault;
  if (normal != path && std::filesystem::equivalent(normal, path, fault)) return row->second = row_of(normal);
  files_.push_back(path);
  return row->second;
}

std::string name_of(const clang::NamedDecl& decl) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&decl);
  const bool is_lambda = method != nullptr && method->getParent()->isLambda();
  std::string name = is_lambda                                                     ? "(lambda)"
                     : decl.getDeclName().isIdentifier() && decl.getName().empty() ? ""
                                                                                   : decl.getNameAsString();
  for (const clang::DeclContext* at = decl.getDeclContext(); at != nullptr; at = at->getParent()) {
    const auto* outer = llvm::dyn_cast<clang::NamedDecl>(at);
    if (outer == nullptr || llvm::isa<clang::FunctionDecl>(outer)) continue;
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(outer);
    if (space != nullptr && (space->isInline() || space->isAnonymousNamespace())) continue;
    if (!outer->getDeclName().isIdentifier() || outer->getName().empty()) continue;
    name = outer->getNameAsString() + "::" + name;
  }
  return name;
}

} // namespace director::scanning
