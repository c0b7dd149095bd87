// Header: compiler/clang/book.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/book.hpp"

#include "compiler/clang/contexts.hpp"

#include <clang/Index/USRGeneration.h>

namespace director::scanning {

using namespace clang;

std::string key_of(const NamedDecl& decl) {
  const SourceManager& sources = decl.getASTContext().getSourceManager();
  llvm::SmallString<128> key;
  if (clang::index::generateUSRForDecl(&decl, key) || key.empty()) return decl.getLocation().printToString(sources);
  std::string out = key.str().str();
  if (decl.isExternallyVisible()) return out;
  if (const OptionalFileEntryRef file = sources.getFileEntryRefForID(sources.getMainFileID()))
    out += "@" + file->getName().str();
  return out;
}

std::string Book::want(const FunctionDecl& function) {
  const FunctionDecl* body = nullptr;
  if (function.hasBody(body) && !body->isDependentContext() && !is_system(*body) && !is_directors(*body) &&
      wanted_.insert(body->getCanonicalDecl()).second)
    waiting_.push_back(body);
  return key_of(function);
}

const FunctionDecl* Book::next() {
  if (waiting_.empty()) return nullptr;
  const FunctionDecl* function = waiting_.back();
  waiting_.pop_back();
  return function;
}

} // namespace director::scanning
