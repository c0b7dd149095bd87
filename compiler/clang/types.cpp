// Header: compiler/clang/subcommands.hpp. Test: tests/compiler/clang.
// SPDX-License-Identifier: MIT
//
// Looks up names of types by writing them into a C++ file behind the headers, one alias a line: Clang then shows what
// each is, or, in the line of the alias, why there is no such type.
#include "compiler/clang/ast/places.hpp"
#include "compiler/clang/parse/parse.hpp"
#include "compiler/clang/parse/units.hpp"
#include "compiler/clang/subcommands.hpp"
#include "dsl/lexical/cpp_type.hpp"
#include "dsl/lexical/names.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <optional>

namespace director::scanning {

namespace {

constexpr const char* alias = "director_alias_";
constexpr const char* macro = "director_macro_"; ///< an alias that exists if the name is a macro

/// The number at the end of a name with this beginning.
std::optional<std::size_t> row_of(llvm::StringRef name, llvm::StringRef begin, std::size_t count) {
  std::size_t row = 0;
  if (!name.consume_front(begin) || name.getAsInteger(10, row) || row >= count) return {};
  return row;
}

struct Source {
  std::string text;
  unsigned first_line = 0; ///< of the aliases
  unsigned first_use = 0;  ///< the line from which faults do not count
};

Source write_source(const Json& request) {
  Source out;
  unsigned line = 1;
  for (const Json& header : request["headers"].items()) {
    out.text += dsl::include_line(header.as_text()) + "\n";
    ++line;
  }
  // The generated header includes the runtime, and what that includes.
  const std::string runtime = "\"runtime/core/behaviour.hpp\"";
  out.text += "#if __has_include(" + runtime + ")\n#include " + runtime + "\n#endif\n";
  line += 3;
  out.text += "namespace " + request["namespace"].as_text() + " {\n";
  out.first_line = line + 1;
  std::size_t number = 0;
  for (const Json& name : request["names"].items())
    out.text += "using " + (alias + std::to_string(number++)) + " = " + name.as_text() + ";\n";
  for (std::size_t i = 0; i < number; ++i) {
    const std::string& name = request["names"].items()[i].as_text();
    const std::size_t colon = name.rfind(':');
    const std::string last = colon == std::string::npos ? name : name.substr(colon + 1);
    if (dsl::is_identifier(last))
      out.text += "#ifdef " + last + "\nusing " + (macro + std::to_string(i)) + " = int;\n#endif\n";
  }
  // An enum within a template has values only after it is used, also where an alias names it. Faults of these lines do
  // not count.
  out.first_use = 1 + static_cast<unsigned>(std::count(out.text.begin(), out.text.end(), '\n'));
  for (std::size_t i = 0; i < number; ++i)
    out.text += "namespace director_uses { using enum " + (alias + std::to_string(i)) + "; }\n";
  out.text += "}\n";
  return out;
}

Json describe(const clang::EnumDecl& decl, Places& places) {
  Json enumerators = Json::list({});
  for (const clang::EnumConstantDecl* each : decl.enumerators()) {
    llvm::SmallString<24> digits;
    each->getInitVal().toString(digits, 10);
    enumerators.add(Json::object({{"name", Json::text(each->getNameAsString())},
                                  {"value", Json::text(digits.str().str())},
                                  {"at", places.of(each->getLocation(), each->getLocation())}}));
  }
  return Json::object(
      {{"at", places.of(decl.getLocation(), decl.getLocation())}, {"enumerators", std::move(enumerators)}});
}

/// Also what a template would be that has not been instantiated yet. Of one that is only defined for some arguments,
/// such as std::function, it is unknown here whether these are among them.
bool is_complete(clang::QualType type) {
  if (!type->isIncompleteType()) return true;
  if (const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl()) {
    if (const clang::CXXRecordDecl* member = record->getInstantiatedFromMemberClass()) return member->hasDefinition();
  }
  const auto* special = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsTagDecl());
  if (special == nullptr || special->isExplicitSpecialization()) return false;
  llvm::SmallVector<clang::ClassTemplatePartialSpecializationDecl*, 4> some;
  special->getSpecializedTemplate()->getPartialSpecializations(some);
  return !some.empty() || special->getSpecializedTemplate()->getTemplatedDecl()->hasDefinition();
}

/// `a reference`, if it is a type that is not stored by value; otherwise empty. What runtime/core/api/task.hpp refuses,
/// as far as it is part of the type itself.
std::string form_of(clang::QualType type) {
  if (type->isReferenceType()) return "a reference";
  if (type->isArrayType()) return "an array";
  if (type->isFunctionType()) return "a function type";
  if (type->isVoidType()) return "`void`";
  if (type.isConstQualified()) return "`const`";
  if (type.isVolatileQualified()) return "`volatile`";
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record != nullptr && record->hasDefinition() && record->isAbstract() ? "an abstract class" : "";
}

} // namespace

Json report_types(const Json& request) {
  Unit unit = unit_of(request["unit"]);
  const Source source = write_source(request);
  unit.text = source.text;
  unit.corrects_names = true;
  const std::size_t count = request["names"].items().size();
  std::vector<Json> types(count);
  std::vector<bool> is_macro(count);
  Json places_of_files;
  Reading reading = parse(unit, [&](clang::ASTContext& context) {
    Places places(context, unit.directory);
    const auto look = [&](const clang::Decl* decl, const auto& self) -> void {
      if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(decl)) {
        for (const clang::Decl* inner : space->decls()) self(inner, self);
        return;
      }
      const auto* found = llvm::dyn_cast<clang::TypeAliasDecl>(decl);
      if (found == nullptr || found->isInvalidDecl()) return;
      if (const auto row = row_of(found->getName(), macro, count)) is_macro[*row] = true;
      const auto row = row_of(found->getName(), alias, count);
      if (!row) return;
      const clang::QualType type = found->getUnderlyingType().getCanonicalType();
      const clang::TagDecl* tag = type->getAsTagDecl();
      const auto* named = llvm::dyn_cast_or_null<clang::EnumDecl>(tag);
      // With its size an enum is complete before its values are known.
      const bool complete = is_complete(type) && (named == nullptr || named->getDefinition() != nullptr);
      Json answer = Json::object({{"complete", Json::boolean(complete)}});
      if (const std::string form = form_of(type); !form.empty()) answer.add("form", Json::text(form));
      if (tag != nullptr) {
        if (named != nullptr) answer.add("enum", describe(complete ? *named->getDefinition() : *named, places));
        answer.add("at", places.of(tag->getLocation(), tag->getLocation()));
      }
      types[*row] = std::move(answer);
    };
    for (const clang::Decl* decl : context.getTraversalScope()) look(decl, look);
    places_of_files = places.files();
  });
  std::erase_if(reading.errors,
                [&](const Fault& each) { return each.file == unit.file && each.line >= source.first_use; });
  Json list = Json::list({});
  for (std::size_t row = 0; row < count; ++row) {
    const auto fault = std::find_if(reading.errors.begin(), reading.errors.end(), [&](const Fault& each) {
      return each.file == unit.file && each.line == source.first_line + row;
    });
    if (fault != reading.errors.end()) {
      list.add(Json::object(
          {{"wrong", Json::text(is_macro[row] ? "it is a macro, which stands for no type" : fault->message)}}));
    } else {
      list.add(std::move(types[row]));
    }
  }
  Json out = Json::object({});
  out.add("types", std::move(list));
  out.add("paths", std::move(places_of_files));
  report_reading(out, reading);
  return out;
}

} // namespace director::scanning
