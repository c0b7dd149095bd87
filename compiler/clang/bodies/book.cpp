// Header: compiler/clang/bodies/book.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/book.hpp"

#include "compiler/clang/ast/contexts.hpp"

#include <clang/AST/DeclTemplate.h>
#include <clang/Index/USRGeneration.h>
#include <llvm/Support/raw_ostream.h>

#include <filesystem>

namespace director::scanning {

using namespace clang;

namespace {

/// What Clang's USR of a declaration leaves out: places of lambdas and of local classes, of which a function may have
/// several alike, and template arguments that are objects, or made from these.
std::string left_out(const NamedDecl& decl) {
  const ASTContext& context = decl.getASTContext();
  std::string out;
  const auto add_place = [&](const CXXRecordDecl* record) {
    if (record == nullptr || (!record->isLambda() && record->isLocalClass() == nullptr)) return;
    const std::filesystem::path place = record->getLocation().printToString(context.getSourceManager());
    out += "@" + place.lexically_normal().string(); // the same by whatever name the file is included
  };
  const auto add_arguments = [&](const TemplateArgumentList& arguments) {
    llvm::raw_string_ostream text(out);
    for (const TemplateArgument& each : arguments.asArray()) {
      each.print(context.getPrintingPolicy(), text << "#", false);
      text.flush();
      if (each.getKind() == TemplateArgument::Type) add_place(each.getAsType()->getAsCXXRecordDecl());
    }
  };
  for (const Decl* at = &decl; at != nullptr;) {
    if (const auto* record = llvm::dyn_cast<CXXRecordDecl>(at)) add_place(record);
    if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(at))
      add_arguments(special->getTemplateArgs());
    const auto* function = llvm::dyn_cast<FunctionDecl>(at);
    if (function != nullptr && function->getTemplateSpecializationArgs() != nullptr)
      add_arguments(*function->getTemplateSpecializationArgs());
    const DeclContext* outer = at->getDeclContext();
    at = outer == nullptr ? nullptr : Decl::castFromDeclContext(outer);
  }
  return out;
}

} // namespace

std::string key_of(const NamedDecl& decl) {
  const SourceManager& sources = decl.getASTContext().getSourceManager();
  llvm::SmallString<128> key;
  if (clang::index::generateUSRForDecl(&decl, key) || key.empty())
    return decl.getLocation().printToString(sources) + left_out(decl);
  std::string out = key.str().str() + left_out(decl);
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
