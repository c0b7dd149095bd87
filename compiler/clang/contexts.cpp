// Header: compiler/clang/contexts.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/contexts.hpp"

#include "compiler/clang/places.hpp"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>

namespace director::scanning {

using namespace clang;

bool is_system(const Decl& decl) {
  return decl.getASTContext().getSourceManager().isInSystemHeader(decl.getLocation());
}

bool is_directors(const Decl& decl) {
  const DeclContext* space = nullptr;
  for (const DeclContext* at = decl.getDeclContext(); at != nullptr; at = at->getParent()) {
    if (llvm::isa<NamespaceDecl>(at)) space = at;
  }
  return space != nullptr && llvm::cast<NamespaceDecl>(space)->getName() == "director";
}

QualType bare(QualType type) {
  type = type.getCanonicalType();
  while (type->isReferenceType() || type->isPointerType()) type = type->getPointeeType().getCanonicalType();
  return type.getUnqualifiedType();
}

namespace {

// Limit for nested members that are searched for a context: types of the user may contain themselves by pointers, and
// templates may nest without end.
constexpr int deepest_member = 4;

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

bool carries_context(QualType type, int depth) {
  if (depth == 0 || type.isNull()) return false;
  const QualType inner = bare(type);
  if (const auto* function = inner->getAs<FunctionProtoType>()) {
    for (const QualType each : function->param_types()) {
      if (carries_context(each, depth - 1)) return true;
    }
    return false;
  }
  const CXXRecordDecl* record = inner->getAsCXXRecordDecl();
  if (record == nullptr) return false;
  if (!context_of(record).empty()) return true;
  if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(record)) {
    for (const TemplateArgument& argument : special->getTemplateArgs().asArray()) {
      if (argument.getKind() == TemplateArgument::Type && carries_context(argument.getAsType(), depth - 1)) return true;
    }
  }
  if (!record->hasDefinition() || is_system(*record) || is_directors(*record)) return false;
  for (const FieldDecl* field : record->fields()) {
    if (carries_context(field->getType(), depth - 1)) return true;
  }
  return false;
}

} // namespace

std::string context_of(QualType type) { return context_of(bare(type)->getAsCXXRecordDecl()); }

bool carries_context(QualType type) { return carries_context(type, deepest_member); }

bool carries_context(const Expr& value) {
  return carries_context(value.getType()) || carries_context(value.IgnoreParenCasts()->getType());
}

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
