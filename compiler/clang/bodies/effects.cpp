// Header: compiler/clang/bodies/effects.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/effects.hpp"

#include "compiler/clang/bodies/blocking.hpp"
#include "compiler/clang/bodies/callbacks.hpp"
#include "compiler/clang/bodies/endings.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::scanning {

namespace {

using namespace clang;

/// `soccer::Walk`, also with keep.
std::string task_of(QualType type) {
  const CXXRecordDecl* record = bare(type)->getAsCXXRecordDecl();
  if (const auto* special = llvm::dyn_cast_or_null<ClassTemplateSpecializationDecl>(record)) {
    if (is_directors(*special) && special->getTemplateArgs().size() == 1 &&
        special->getTemplateArgs()[0].getKind() == TemplateArgument::Type)
      return task_of(special->getTemplateArgs()[0].getAsType());
  }
  return record == nullptr ? std::string{} : name_of(*record);
}

/// One without `auto`: it is read where it is written.
bool is_plain_lambda(const Expr& value) {
  const CXXRecordDecl* record = bare(value.getType())->getAsCXXRecordDecl();
  return record != nullptr && record->isLambda() && !record->isGenericLambda();
}

bool returns_container(const FunctionDecl& callee) {
  const CXXRecordDecl* record = callee.getReturnType()->getAsCXXRecordDecl();
  return record != nullptr && is_container(name_of(*record)) && name_of(callee) != "std::exchange";
}

} // namespace

SourceLocation name_place(const CallExpr& expr) {
  const Expr* callee = expr.getCallee()->IgnoreParenImpCasts();
  SourceLocation out;
  if (const auto* member = llvm::dyn_cast<MemberExpr>(callee)) out = member->getMemberLoc();
  if (const auto* name = llvm::dyn_cast<DeclRefExpr>(callee)) out = name->getLocation();
  return out.isValid() ? out : expr.getBeginLoc(); // a conversion is called without its name
}

std::vector<QualType> types_given(llvm::ArrayRef<const Expr*> arguments) {
  std::vector<QualType> out;
  for (const Expr* each : arguments) {
    const Expr* written = each->IgnoreParenCasts();
    const auto* address = llvm::dyn_cast<UnaryOperator>(written);
    if (address != nullptr && address->getOpcode() == UO_AddrOf) written = address->getSubExpr()->IgnoreParens();
    const auto* name = llvm::dyn_cast<DeclRefExpr>(written);
    if (name != nullptr && llvm::isa<FunctionDecl>(name->getDecl())) continue; // its call is noted where it is named
    out.push_back(each->getType());
    out.push_back(each->IgnoreParenCasts()->getType());
  }
  return out;
}

bool Effects::add_word(const CallExpr& expr, const CXXMethodDecl& method, const Expr& object) {
  const std::string context = context_of(object.getType());
  if (context.empty() || !method.getDeclName().isIdentifier()) return false;
  const CXXRecordDecl* of = method.getParent();
  const bool is_pack = !is_directors(*of) && context == name_of(*of);
  if (!is_pack && !is_directors(*of)) return false; // a class of the user with a context's functions
  const std::string word = method.getName().str();
  Json fact = Json::object({{"context", Json::text(context)}});
  const SourceLocation at = name_place(expr);
  if (is_pack || word == "request") {
    fact.add("word", Json::text(is_pack ? "pack" : "request"));
    if (is_pack) fact.add("pack", Json::text(word));
    Json tasks = Json::list({});
    for (const Expr* argument : expr.arguments()) tasks.add(Json::text(task_of(argument->getType())));
    fact.add("tasks", std::move(tasks));
    fact.add("at", book_.places().of(at, at));
  } else if (word == "set" || word == "try_set") {
    if (expr.getNumArgs() == 0) return true;
    fact.add("word", Json::text("set"));
    fact.add("state", Json::text(values_.state_of(expr.getArg(0))));
    if (const auto values = values_.of(expr.getArg(0))) {
      Json all = Json::list({});
      for (const Values::Names& names : *values) all.add(Json::texts(names));
      fact.add("values", std::move(all));
    }
    fact.add("at", book_.places().of(at, expr.getEndLoc()));
  } else if (word == "done" || word == "fail" || word == "keep") {
    fact.add("word", Json::text(word));
    fact.add("at", book_.places().of(at, at));
  } else {
    return true;
  }
  does_.add(std::move(fact));
  return true;
}

void Effects::call(const FunctionDecl& callee, SourceLocation begin, SourceLocation end, bool carries, bool maybe,
                   bool is_virtual) {
  if (here.isValid()) begin = end = here;
  // Functions that the compiler generates have no such code.
  const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
  const bool is_lambda = method != nullptr && method->getParent()->isLambda();
  if (callee.getLocation().isInvalid() || (callee.isDefaulted() && !is_virtual) ||
      (callee.isImplicit() && !is_lambda && !is_virtual))
    return;
  // A lambda that becomes a function pointer: its body is recorded where it is written.
  if (is_lambda && (llvm::isa<CXXConversionDecl>(method) || method->isLambdaStaticInvoker())) return;
  Json fact = Json::object({{"to", Json::text(book_.want(callee))},
                            {"name", Json::text(name_of(callee))},
                            {"at", book_.places().of(begin, end)}});
  const FunctionDecl* body = nullptr;
  if (!callee.hasBody(body)) fact.add("declared", book_.places().of(callee.getLocation(), callee.getLocation()));
  if (carries) fact.add("carries", Json::boolean(true));
  if (maybe) fact.add("maybe", Json::boolean(true));
  if (is_virtual) fact.add("virtual", Json::boolean(true));
  calls_.add(std::move(fact));
}

void Effects::hide(std::string what, SourceLocation begin, SourceLocation end, bool carries, bool if_stored) {
  Json fact = Json::object({{"what", Json::text(what)}, {"at", book_.places().of(begin, end)}});
  if (if_stored) fact.add("if_stored", Json::boolean(true));
  if (carries) fact.add("carries", Json::boolean(true));
  hidden_.add(std::move(fact));
}

void Effects::block(const std::string& name, std::string_view why, SourceLocation at) {
  if (here.isValid()) at = here;
  if (why == "frees") why = "uses the heap";
  blocks_.add(Json::object({{"name", Json::text(name)}, {"why", Json::text(why)}, {"at", book_.places().of(at, at)}}));
}

void Effects::reach(const FunctionDecl& callee, SourceLocation at, bool is_given, bool destroys) {
  if (!book_.is_deep()) return;
  const Reached& all = book_.reach().of(callee, destroys);
  const std::string name = name_of(callee);
  if (!all.why.empty()) {
    block(name, all.why, at);
  } else if (!all.has_definition && !destroys && (grows_container(name, is_given) || returns_container(callee))) {
    block(name, "uses the heap", at);
  }
  for (const FunctionDecl* user : all.users) {
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(user);
    call(*user, at, at, false, false, method != nullptr && method->isVirtual());
  }
  for (const FunctionDecl* unknown : all.unknown)
    hide(unknown == &callee ? "`" + name + "`" : "`" + name_of(*unknown) + "`, which `" + name + "` calls", at, at,
         false);
}

void Effects::manage_memory(const FunctionDecl& function, SourceLocation at) {
  if (function.isReservedGlobalPlacementOperator()) return;
  if (function.getLocation().isValid() && !is_system(function)) return call(function, at, at, false, false, false);
  block(name_of(function), "uses the heap", at);
}

void Effects::destroy(QualType type, SourceLocation at, bool by_pointer) {
  const bool carries = book_.carriers().has(type);
  for (const Ending& each : endings_of(book_.context(), type, by_pointer, !book_.is_deep())) {
    switch (each.kind) {
    case Ending::Kind::own:
    case Ending::Kind::virtual_:
      call(*each.function, at, at, carries, false, each.kind == Ending::Kind::virtual_);
      break;
    case Ending::Kind::library: reach(*each.function, at, false, true); break;
    case Ending::Kind::unread: hide("a deleter that is a template", at, at, carries); break;
    }
  }
}

void Effects::hide_library(const FunctionDecl& callee, const std::vector<QualType>& given, SourceLocation at,
                           bool carries) {
  const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&callee);
  const std::string name = "`" + (maker == nullptr ? name_of(callee) : name_of(*maker->getParent())) + "`";
  const bool is_known = callee.isDefaulted() || callee.isImplicit() || !known_effect(callee).empty();
  const bool hides =
      is_standard(callee) ? may_call_back(callee, given) : !is_known && (carries || may_do_anything(callee));
  if (hides && carries) hide("what " + name + " does with it", at, at, true);
  if (hides && !carries) hide("what " + name + " calls", at, at, false, true);
}

void Effects::make_of_library(const CXXConstructorDecl& callee, SourceLocation at, const Given& given) {
  reach(callee, at, given.any);
  hide_library(callee, given.types, at, given.outside);
}

void Effects::call_library(const CallExpr& expr, const FunctionDecl& callee, SourceLocation at) {
  const std::string name = name_of(callee);
  const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
  reach(callee, at, method == nullptr || !method->isMoveAssignmentOperator());
  const bool is_function = name == "std::function::operator()" || name == "std::move_only_function::operator()";
  if (is_function) hide("a call of a `" + name.substr(0, name.rfind(':') - 1) + "`", at, at, false, true);
  static const std::set<std::string> passes_on{"std::forward",
                                               "std::move",
                                               "std::ref",
                                               "std::cref",
                                               "std::addressof",
                                               "std::as_const",
                                               "std::tie",
                                               "std::get",
                                               "std::get_if",
                                               "std::holds_alternative",
                                               "std::size",
                                               "std::ssize",
                                               "std::begin",
                                               "std::end",
                                               "std::data",
                                               "std::empty",
                                               "std::make_tuple",
                                               "std::make_pair",
                                               "std::forward_as_tuple",
                                               "std::tuple_cat",
                                               "std::operator==",
                                               "std::operator!="};
  const bool only_applies =
      (name == "std::apply" || name == "std::invoke") && expr.getNumArgs() > 0 && is_plain_lambda(*expr.getArg(0));
  if (passes_on.count(name) > 0 || only_applies) return;
  const auto carries = [&](const Expr* value) { return book_.carriers().has_outside_of_lambdas(*value); };
  if (std::any_of(expr.arg_begin(), expr.arg_end(), carries))
    return hide("what `" + name + "` does with it", at, at, true);
  if (is_function) return;
  const Expr* object = object_of(expr);
  std::vector<QualType> given = types_given({expr.getArgs(), expr.getNumArgs()});
  if (object != nullptr) given.push_back(object->getType());
  hide_library(callee, given, at, object != nullptr && carries(object));
}

void Effects::add_to(Json& fact) && {
  if (stores) fact.add("stores", Json::boolean(true));
  const auto add = [&](const char* name, Json& list) {
    if (!list.items().empty()) fact.add(name, std::move(list));
  };
  add("does", does_);
  add("calls", calls_);
  add("blocks", blocks_);
  add("hidden", hidden_);
}

} // namespace director::scanning
