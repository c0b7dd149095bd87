// Header: compiler/clang/bodies/callbacks.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/callbacks.hpp"

#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/ast/places.hpp"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace director::scanning {

namespace {

using namespace clang;

/// The classes of the user that some types name, also as arguments of the library's templates. A lambda is read where
/// it is written.
class Named {
public:
  void add(QualType type) {
    if (type.isNull()) return;
    type = bare(type);
    while (const ArrayType* array = type->getAsArrayTypeUnsafe()) type = bare(array->getElementType());
    if (!seen_.insert(type.getAsOpaquePtr()).second) return;
    if (type->isFunctionType() || type->isMemberPointerType()) pointers = true;
    const CXXRecordDecl* record = type->getAsCXXRecordDecl();
    if (record == nullptr || is_directors(*record) || record->isLambda()) return;
    if (name_of(*record) == "std::allocator") return; // a container is given one, which holds no object
    if (!context_of(type).empty()) {
      contexts = true;
      return;
    }
    static const std::set<std::string> tags{"std::in_place_t", "std::in_place_type_t", "std::in_place_index_t",
                                            "std::piecewise_construct_t"};
    if (tags.count(name_of(*record)) > 0) {
      in_place = true;
      return;
    }
    if (!is_standard(*record)) classes.insert(record->getCanonicalDecl());
    if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(record))
      add(special->getTemplateArgs().asArray());
  }
  void add(llvm::ArrayRef<TemplateArgument> arguments) {
    for (const TemplateArgument& each : arguments) {
      if (each.getKind() == TemplateArgument::Pack) add(each.pack_elements());
      if (each.getKind() == TemplateArgument::Type) add(each.getAsType());
    }
  }
  /// The templates of a function and of its class.
  void add(const FunctionDecl& function) {
    if (const TemplateArgumentList* arguments = function.getTemplateSpecializationArgs()) add(arguments->asArray());
    if (const auto* method = llvm::dyn_cast<CXXMethodDecl>(&function)) add_class(*method->getParent());
  }
  void add_class(const CXXRecordDecl& record) {
    if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(&record))
      add(special->getTemplateArgs().asArray());
  }

  std::set<const CXXRecordDecl*> classes;
  bool contexts = false;
  bool in_place = false; ///< what is given makes the object, whatever its type
  bool pointers = false; ///< to functions, also as the signature of a `std::function`

private:
  std::set<void*> seen_;
};

/// Which functions of a class may be called.
enum class Use {
  copies, ///< its copy and move constructors
  makes,  ///< its constructors
  any     ///< all but its destructor, which is followed where the object ends
};

bool counts(const CXXMethodDecl& method, Use use) {
  if (method.isDeleted() || !method.isUserProvided() || llvm::isa<CXXDestructorDecl>(method)) return false;
  const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&method);
  return use == Use::any || (maker != nullptr && (use == Use::makes || maker->isCopyOrMoveConstructor()));
}

/// Whether the class has such a function, or a base or member, with which one is made or copied too.
bool has_code(const CXXRecordDecl& record, Use use, std::set<const CXXRecordDecl*>& seen) {
  if (!record.hasDefinition() || is_standard(record) || is_directors(record)) return false;
  if (!seen.insert(record.getCanonicalDecl()).second) return false;
  const auto is_part = [&](QualType type) {
    while (const ArrayType* array = type->getAsArrayTypeUnsafe()) type = array->getElementType();
    const CXXRecordDecl* part = type->getAsCXXRecordDecl();
    return part != nullptr && has_code(*part, use, seen);
  };
  const CXXRecordDecl& whole = *record.getDefinition();
  return std::any_of(whole.decls_begin(), whole.decls_end(),
                     [&](const Decl* each) {
                       const auto* many = llvm::dyn_cast<FunctionTemplateDecl>(each);
                       const Decl* one = many == nullptr ? each : many->getTemplatedDecl();
                       const auto* method = llvm::dyn_cast<CXXMethodDecl>(one);
                       return method != nullptr && counts(*method, use);
                     }) ||
         std::any_of(whole.field_begin(), whole.field_end(),
                     [&](const FieldDecl* field) { return is_part(field->getType()); }) ||
         std::any_of(whole.bases_begin(), whole.bases_end(),
                     [&](const CXXBaseSpecifier& base) { return is_part(base.getType()); });
}

bool have_code(const std::set<const CXXRecordDecl*>& classes, Use use) {
  std::set<const CXXRecordDecl*> seen;
  return std::any_of(classes.begin(), classes.end(),
                     [&](const CXXRecordDecl* each) { return has_code(*each, use, seen); });
}

/// Those that keep what they are given, and run no more of it than what makes it.
bool only_holds(const std::string& name) {
  static const std::set<std::string> known{"std::any",      "std::array",
                                           "std::deque",    "std::forward_list",
                                           "std::function", "std::initializer_list",
                                           "std::list",     "std::move_only_function",
                                           "std::optional", "std::pair",
                                           "std::queue",    "std::stack",
                                           "std::tuple",    "std::variant",
                                           "std::vector"};
  return known.count(name) > 0;
}

/// Those that only know where the object is. What a smart pointer runs at last is followed there.
bool only_points(const std::string& name) {
  static const std::set<std::string> known{"std::allocator",  "std::reference_wrapper", "std::span",
                                           "std::unique_ptr", "std::weak_ptr",          "__gnu_cxx::__normal_iterator"};
  return known.count(name) > 0;
}

/// Functions of the library's objects that run nothing of what these hold but destructors.
bool only_looks(const CXXMethodDecl& method) {
  static const std::set<std::string_view> known{
      "at",      "back",     "begin",    "capacity", "cbegin",    "cend",      "clear",     "crbegin",
      "crend",   "data",     "empty",    "end",      "front",     "get",       "get_id",    "has_value",
      "index",   "joinable", "max_size", "mutex",    "owns_lock", "pop_back",  "pop_front", "rbegin",
      "release", "rend",     "reset",    "size",     "top",       "use_count", "value",     "valueless_by_exception"};
  if (llvm::isa<CXXConversionDecl>(method)) return true;
  if (method.getDeclName().isIdentifier()) return known.count(method.getName()) > 0;
  const OverloadedOperatorKind sign = method.getOverloadedOperator();
  return sign == OO_Arrow || sign == OO_Star || sign == OO_Subscript;
}

} // namespace

bool may_call_back(const FunctionDecl& callee, const std::vector<QualType>& given) {
  const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
  const std::string owner = method == nullptr ? std::string{} : name_of(*method->getParent());
  const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&callee);
  if (only_points(owner) || (maker == nullptr && method != nullptr && only_looks(*method))) return false;
  if (maker != nullptr && owner == "std::shared_ptr" && callee.getNumParams() < 2) return false; // without a deleter
  Named of_types;
  for (const QualType type : given) of_types.add(type);
  if (maker != nullptr && only_holds(owner)) {
    Named held;
    held.add_class(*maker->getParent());
    const bool is_made =
        of_types.in_place || (of_types.contexts && !held.contexts) ||
        !std::includes(of_types.classes.begin(), of_types.classes.end(), held.classes.begin(), held.classes.end());
    return have_code(held.classes, is_made ? Use::makes : Use::copies) || have_code(of_types.classes, Use::copies);
  }
  const bool pointers = of_types.pointers; // not those that only the callee's own types name
  of_types.add(callee);
  return pointers || have_code(of_types.classes, Use::any);
}

} // namespace director::scanning
