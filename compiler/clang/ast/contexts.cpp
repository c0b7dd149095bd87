// Header: compiler/clang/ast/contexts.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/ast/contexts.hpp"

#include "compiler/clang/ast/places.hpp"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>

#include <algorithm>
#include <set>

namespace director::scanning {

using namespace clang;

bool is_system(const Decl& decl) {
  return decl.getASTContext().getSourceManager().isInSystemHeader(decl.getLocation());
}

namespace {

/// The name of the outermost namespace around it; empty: there is none.
llvm::StringRef outermost(const Decl& decl) {
  llvm::StringRef out;
  for (const DeclContext* at = decl.getDeclContext(); at != nullptr; at = at->getParent()) {
    if (const auto* space = llvm::dyn_cast<NamespaceDecl>(at)) out = space->getName();
  }
  return out;
}

} // namespace

bool is_standard(const Decl& decl) {
  const llvm::StringRef space = outermost(decl);
  return (space == "std" || space == "__gnu_cxx" || space == "__cxxabiv1") && is_system(decl);
}

bool is_directors(const Decl& decl) { return outermost(decl) == "director"; }

QualType bare(QualType type) {
  type = type.getCanonicalType();
  while (type->isReferenceType() || type->isPointerType()) type = type->getPointeeType().getCanonicalType();
  return type.getUnqualifiedType();
}

namespace {

/// `soccer::Walk::Halting`, of Facts<soccer::Walk::Halting>.
std::string provider_of_facts(const ClassTemplateSpecializationDecl& context) {
  const TemplateArgumentList& arguments = context.getTemplateArgs();
  if (arguments.size() == 0 || arguments[0].getKind() != TemplateArgument::Type) return {};
  const auto* facts =
      llvm::dyn_cast_or_null<ClassTemplateSpecializationDecl>(arguments[0].getAsType()->getAsCXXRecordDecl());
  if (facts == nullptr || facts->getTemplateArgs().size() == 0) return {};
  const TemplateArgument& of = facts->getTemplateArgs()[0];
  if (of.getKind() != TemplateArgument::Type) return {};
  const CXXRecordDecl* record = of.getAsType()->getAsCXXRecordDecl();
  return record == nullptr ? std::string{} : name_of(*record);
}

/// The name of the provider's or handler's context that the class is; empty: it is none.
std::string context_of(const CXXRecordDecl* record) {
  if (record == nullptr) return {};
  if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(record)) {
    const llvm::StringRef name = special->getIdentifier() != nullptr ? special->getName() : "";
    if (is_directors(*record) && (name == "Context" || name == "Body" || name == "Handler"))
      return provider_of_facts(*special);
  }
  if (!record->hasDefinition()) return {};
  for (const CXXBaseSpecifier& base : record->bases()) {
    const std::string name = context_of(base.getType()->getAsCXXRecordDecl());
    if (!name.empty()) return name;
  }
  return {};
}

} // namespace

std::string context_of(QualType type) { return context_of(bare(type)->getAsCXXRecordDecl()); }

/// Searches a type for a context: through its members, its bases, and what its templates are made of. Types may contain
/// themselves by pointers, so each is searched once. If none is found, none is in any type on the way: the whole costs
/// as much as there are types, however often one is asked for.
class ContextSearch {
public:
  using Known = std::map<std::pair<void*, Carriers::Skipped>, bool>;
  ContextSearch(Carriers::Skipped skipped, const Known& known) : skipped_(skipped), known_(known) {}
  const std::set<void*>& seen() const { return seen_; }
  bool finds_in(QualType type) {
    if (type.isNull()) return false;
    type = bare(type);
    while (const ArrayType* array = type->getAsArrayTypeUnsafe()) type = bare(array->getElementType());
    if (const auto at = known_.find({type.getAsOpaquePtr(), skipped_}); at != known_.end()) return at->second;
    if (!seen_.insert(type.getAsOpaquePtr()).second) return false;
    if (const auto* function = type->getAs<FunctionProtoType>()) {
      if (skipped_ == Carriers::Skipped::code) return false;
      return std::any_of(function->param_type_begin(), function->param_type_end(),
                         [&](QualType each) { return finds_in(each); });
    }
    const CXXRecordDecl* record = type->getAsCXXRecordDecl();
    return record != nullptr && finds_in(*record);
  }

private:
  bool finds_in(const CXXRecordDecl& record) {
    if (!context_of(&record).empty()) return true;
    if (record.isLambda() && skipped_ != Carriers::Skipped::nothing) return false;
    const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(&record);
    if (special != nullptr && finds_in(special->getTemplateArgs().asArray())) return true;
    if (!record.hasDefinition() || is_standard(record) || is_directors(record)) return false;
    return std::any_of(record.field_begin(), record.field_end(),
                       [&](const FieldDecl* field) { return finds_in(field->getType()); }) ||
           std::any_of(record.bases_begin(), record.bases_end(),
                       [&](const CXXBaseSpecifier& base) { return finds_in(base.getType()); });
  }
  bool finds_in(llvm::ArrayRef<TemplateArgument> arguments) {
    return std::any_of(arguments.begin(), arguments.end(), [&](const TemplateArgument& each) {
      if (each.getKind() == TemplateArgument::Pack) return finds_in(each.pack_elements());
      return each.getKind() == TemplateArgument::Type && finds_in(each.getAsType());
    });
  }

  Carriers::Skipped skipped_;
  const Known& known_;
  std::set<void*> seen_;
};

bool Carriers::has(QualType type, Skipped skipped) {
  if (const auto at = known_.find({type.getAsOpaquePtr(), skipped}); at != known_.end()) return at->second;
  ContextSearch search(skipped, known_);
  const bool found = search.finds_in(type);
  if (!found) {
    for (void* each : search.seen()) known_.emplace(std::pair(each, skipped), false);
  }
  known_.emplace(std::pair(type.getAsOpaquePtr(), skipped), found);
  return found;
}
bool Carriers::has(const Expr& value, Skipped skipped) {
  return has(value.getType(), skipped) || has(value.IgnoreParenCasts()->getType(), skipped);
}

bool Carriers::has(QualType type) { return has(type, Skipped::nothing); }
bool Carriers::has(const Expr& value) { return has(value, Skipped::nothing); }
bool Carriers::holds(QualType type) { return has(type, Skipped::code); }
bool Carriers::holds(const Expr& value) { return has(value, Skipped::code); }
bool Carriers::has_outside_of_lambdas(const Expr& value) { return has(value, Skipped::lambdas); }

bool is_called_like_body(const NamedDecl& decl) {
  if (!decl.getDeclName().isIdentifier()) return false;
  const llvm::StringRef name = decl.getName();
  return name == "provide" || name == "start" || name == "stop";
}

std::string parameter_context(const CXXMethodDecl& method) {
  return method.getNumParams() == 1 ? context_of(method.getParamDecl(0)->getType()) : std::string{};
}

bool is_interface(const CXXRecordDecl& record) {
  if (!record.hasDefinition() || record.getNumBases() != 0) return false;
  for (const CXXMethodDecl* method : record.methods()) {
    if (method->isPureVirtual() && is_called_like_body(*method) && !parameter_context(*method).empty()) return true;
  }
  return false;
}

const CXXRecordDecl* interface_of(const CXXRecordDecl& record) {
  if (!record.hasDefinition()) return nullptr;
  for (const CXXBaseSpecifier& base : record.bases()) {
    const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl();
    if (above == nullptr) continue;
    above = above->getDefinition();
    if (above == nullptr) continue;
    if (is_interface(*above)) return above;
    if (const CXXRecordDecl* found = interface_of(*above)) return found;
  }
  return nullptr;
}

const CXXMethodDecl* declared_for(const CXXRecordDecl& record, llvm::StringRef name, const std::string& context) {
  if (!record.hasDefinition()) return nullptr;
  for (const CXXBaseSpecifier& base : record.bases()) {
    const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl();
    if (above == nullptr || !above->hasDefinition()) continue;
    above = above->getDefinition();
    if (is_interface(*above)) {
      for (const CXXMethodDecl* method : above->methods()) {
        if (is_called_like_body(*method) && (name.empty() || method->getName() == name) &&
            parameter_context(*method) == context)
          return method;
      }
    }
    if (const CXXMethodDecl* found = declared_for(*above, name, context)) return found;
  }
  return nullptr;
}

const CXXMethodDecl* promised_by(const CXXMethodDecl& method) {
  for (const CXXMethodDecl* above : method.overridden_methods()) {
    if (above->getParent() != nullptr && is_interface(*above->getParent())) return above;
    if (const CXXMethodDecl* found = promised_by(*above)) return found;
  }
  return nullptr;
}

} // namespace director::scanning
