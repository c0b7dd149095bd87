// Header: compiler/clang/bodies/endings.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/endings.hpp"

#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/ast/places.hpp"

#include <clang/AST/DeclTemplate.h>

#include <set>
#include <string>

namespace director::scanning {

namespace {

using namespace clang;

class EndingsFinder {
public:
  EndingsFinder(ASTContext& context, bool held) : context_(context), held_(held) {}

  std::vector<Ending> find(QualType type, bool by_pointer) {
    if (type->isReferenceType() || type->isDependentType()) return {};
    const CXXRecordDecl* record = record_of(type);
    if (by_pointer) add_below(record);
    add(record);
    return std::move(out_);
  }

private:
  const CXXRecordDecl* record_of(QualType type) const {
    return context_.getBaseElementType(type)->getAsCXXRecordDecl();
  }

  /// The destructors of the classes below, if its own is virtual.
  void add_below(const CXXRecordDecl* record) {
    if (record == nullptr || !record->hasDefinition() || is_system(*record) || is_directors(*record)) return;
    const CXXDestructorDecl* own = record->getDestructor();
    if (own != nullptr && own->isVirtual() && !record->isEffectivelyFinal())
      out_.push_back({Ending::Kind::virtual_, own});
  }

  void add(const CXXRecordDecl* record) {
    if (record == nullptr || !record->hasDefinition() || record->hasTrivialDestructor()) return;
    if (is_directors(*record) || !seen_.insert(record).second) return;
    const CXXDestructorDecl* own = record->getDestructor();
    if (is_system(*record)) {
      if (own != nullptr) out_.push_back({Ending::Kind::library, own});
      if (held_) add_held(*record);
      return;
    }
    if (own != nullptr && own->isUserProvided()) out_.push_back({Ending::Kind::own, own});
    for (const FieldDecl* field : record->fields()) add(record_of(field->getType()));
    for (const CXXBaseSpecifier& base : record->bases()) add(base.getType()->getAsCXXRecordDecl());
  }

  void add_held(const CXXRecordDecl& record) {
    const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(&record);
    if (special == nullptr) return;
    const std::string name = name_of(record);
    static const std::set<std::string> destroys_nothing{"std::weak_ptr",    "std::allocator",   "std::lock_guard",
                                                        "std::unique_lock", "std::scoped_lock", "std::shared_lock"};
    if (destroys_nothing.count(name) == 0) add_held(name, special->getTemplateArgs().asArray());
  }

  void add_held(const std::string& holder, llvm::ArrayRef<TemplateArgument> arguments) {
    const bool is_unique = holder == "std::unique_ptr";
    for (const TemplateArgument& each : arguments) {
      if (each.getKind() == TemplateArgument::Pack) add_held(holder, each.pack_elements());
      if (each.getKind() != TemplateArgument::Type) continue;
      const CXXRecordDecl* held = record_of(each.getAsType());
      const bool is_first = &each == arguments.begin();
      if (is_first && (is_unique || holder == "std::shared_ptr")) add_below(held);
      add(held);
      if (!is_first && is_unique) add_deleter(each.getAsType().getNonReferenceType()->getAsCXXRecordDecl());
    }
  }

  void add_deleter(const CXXRecordDecl* deleter) {
    if (deleter == nullptr || !deleter->hasDefinition() || is_system(*deleter)) return;
    const auto is_call = [](const FunctionDecl& each) { return each.getOverloadedOperator() == OO_Call; };
    for (const Decl* each : deleter->decls()) {
      const auto* method = llvm::dyn_cast<CXXMethodDecl>(each);
      const auto* many = llvm::dyn_cast<FunctionTemplateDecl>(each);
      if (method != nullptr && is_call(*method)) out_.push_back({Ending::Kind::own, method});
      if (many != nullptr && is_call(*many->getTemplatedDecl())) out_.push_back({Ending::Kind::unread, nullptr});
    }
    for (const CXXBaseSpecifier& base : deleter->bases()) add_deleter(base.getType()->getAsCXXRecordDecl());
  }

  ASTContext& context_;
  bool held_;
  std::vector<Ending> out_;
  std::set<const CXXRecordDecl*> seen_;
};

} // namespace

std::vector<Ending> endings_of(ASTContext& context, QualType type, bool by_pointer, bool held) {
  return EndingsFinder(context, held).find(type, by_pointer);
}

} // namespace director::scanning
