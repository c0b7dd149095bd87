// Door: compiler/clang/subcommands.hpp. Test: tests/clang.
//
// What the functions of some translation units do that a behaviour is about, and whom they call. No rule is here: what
// of it is right or wrong, directorc decides (compiler/facts/code.hpp says what each fact means).
//
// A context, such as soccer::Walk::Halting, is known by its base director::Context<Facts<soccer::Walk::Halting>, ...>,
// whatever the function that has it calls it; so templates are looked at where they are instantiated. Functions are
// taken from the file itself, with all that they call as far as bodies are visible here; other files tell of theirs.
#include "compiler/clang/blocking.hpp"
#include "compiler/clang/parse.hpp"
#include "compiler/clang/places.hpp"
#include "compiler/clang/subcommands.hpp"
#include "compiler/clang/units.hpp"

#include <clang/AST/CXXInheritance.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Index/USRGeneration.h>
#include <clang/Lex/Lexer.h>

#include <atomic>
#include <set>
#include <thread>

namespace director::scanning {

namespace {

using namespace clang;

bool is_system(const Decl& decl) {
  return decl.getASTContext().getSourceManager().isInSystemHeader(decl.getLocation());
}

/// In namespace director, at any depth.
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

/// `soccer::Walk::Halting`, of Facts<soccer::Walk::Halting>.
std::string whose_facts(const ClassTemplateSpecializationDecl& context) {
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

/// The provider's or handler's context that this is, by name; empty: it is none.
std::string context_of(const CXXRecordDecl* record, int depth = 4) {
  if (record == nullptr || depth == 0) return {};
  if (const auto* special = llvm::dyn_cast<ClassTemplateSpecializationDecl>(record)) {
    const llvm::StringRef name = special->getIdentifier() != nullptr ? special->getName() : "";
    if (is_directors(*record) && (name == "Context" || name == "Body" || name == "Handler"))
      return whose_facts(*special);
  }
  if (!record->hasDefinition()) return {};
  for (const CXXBaseSpecifier& base : record->bases()) {
    const std::string name = context_of(base.getType()->getAsCXXRecordDecl(), depth - 1);
    if (!name.empty()) return name;
  }
  return {};
}

std::string context_of(QualType type) { return context_of(bare(type)->getAsCXXRecordDecl()); }

/// Whoever has such a value may have a context by it.
bool carries_context(QualType type, int depth = 4) {
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

enum class Role { none, provide, start, stop };

Role role_of(const NamedDecl& decl) {
  if (!decl.getDeclName().isIdentifier()) return Role::none;
  const llvm::StringRef name = decl.getName();
  return name == "provide" ? Role::provide : name == "start" ? Role::start : name == "stop" ? Role::stop : Role::none;
}

std::string parameter_context(const CXXMethodDecl& method) {
  return method.getNumParams() == 1 ? context_of(method.getParamDecl(0)->getType()) : std::string{};
}

/// A generated module: pure virtual functions that take contexts.
bool is_interface(const CXXRecordDecl& record) {
  if (!record.hasDefinition() || record.getNumBases() != 0) return false;
  for (const CXXMethodDecl* method : record.methods()) {
    if (method->isPureVirtual() && role_of(*method) != Role::none && !parameter_context(*method).empty()) return true;
  }
  return false;
}

const CXXRecordDecl* interface_of(const CXXRecordDecl& record, int depth = 6) {
  if (depth == 0 || !record.hasDefinition()) return nullptr;
  for (const CXXBaseSpecifier& base : record.bases()) {
    const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl();
    if (above == nullptr) continue;
    above = above->getDefinition();
    if (above == nullptr) continue;
    if (is_interface(*above)) return above;
    if (const CXXRecordDecl* found = interface_of(*above, depth - 1)) return found;
  }
  return nullptr;
}

/// The function of the interface that this one overrides.
const CXXMethodDecl* promised_by(const CXXMethodDecl& method) {
  for (const CXXMethodDecl* above : method.overridden_methods()) {
    if (above->getParent() != nullptr && is_interface(*above->getParent())) return above;
    if (const CXXMethodDecl* found = promised_by(*above)) return found;
  }
  return nullptr;
}

/// One name for one function in all files. What is hidden in a file is told apart by the file.
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

/// Values that an expression may have; nothing: it is computed.
class Values {
public:
  explicit Values(const ASTContext& context) : context_(context) {}

  std::optional<std::set<std::string>> of(const Expr* expr, int depth = 6) const {
    if (expr == nullptr || depth == 0 || expr->isValueDependent()) return {};
    expr = stripped(expr);
    if (const auto* choice = llvm::dyn_cast<ConditionalOperator>(expr)) {
      auto left = of(choice->getTrueExpr(), depth - 1);
      const auto right = of(choice->getFalseExpr(), depth - 1);
      if (!left || !right) return {};
      left->insert(right->begin(), right->end());
      return left;
    }
    if (const auto* list = llvm::dyn_cast<InitListExpr>(expr))
      return list->getNumInits() == 1 ? of(list->getInit(0), depth - 1) : std::nullopt;
    if (const auto* made = llvm::dyn_cast<CXXConstructExpr>(expr))
      return made->getNumArgs() >= 1 ? of(made->getArg(0), depth - 1) : std::nullopt;
    if (const auto* name = llvm::dyn_cast<DeclRefExpr>(expr)) {
      const auto* variable = llvm::dyn_cast<VarDecl>(name->getDecl());
      if (variable != nullptr && variable->getType().isConstQualified() && !variable->getType()->isReferenceType() &&
          variable->getInit() != nullptr && !llvm::isa<ParmVarDecl>(variable) &&
          !variable->getInit()->isValueDependent())
        return of(variable->getInit(), depth - 1);
    }
    Expr::EvalResult result;
    if (!expr->getType()->isIntegralOrEnumerationType() || !expr->EvaluateAsInt(result, context_)) return {};
    return std::set<std::string>{text(result.Val.getInt(), expr->getType())};
  }

  /// Whose values: the enum, or the struct that a number is put into.
  std::string state_of(const Expr* expr) const {
    expr = expr->IgnoreUnlessSpelledInSource();
    const QualType type = bare(stripped(expr)->getType());
    if (const TagDecl* tag = type->getAsTagDecl()) return name_of(*tag);
    return {};
  }

private:
  static const Expr* stripped(const Expr* expr) {
    for (;;) {
      const Expr* inner = expr->IgnoreParenImpCasts();
      if (const auto* full = llvm::dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
      if (const auto* temporary = llvm::dyn_cast<MaterializeTemporaryExpr>(inner)) inner = temporary->getSubExpr();
      if (const auto* bound = llvm::dyn_cast<CXXBindTemporaryExpr>(inner)) inner = bound->getSubExpr();
      if (const auto* cast = llvm::dyn_cast<CXXFunctionalCastExpr>(inner)) inner = cast->getSubExpr();
      if (const auto* substituted = llvm::dyn_cast<SubstNonTypeTemplateParmExpr>(inner))
        inner = substituted->getReplacement();
      if (const auto* made = llvm::dyn_cast<CXXConstructExpr>(inner)) {
        const bool wraps = made->getNumArgs() == 1 && is_directors(*made->getConstructor());
        if (wraps || (made->getNumArgs() == 1 && made->getConstructor()->isCopyOrMoveConstructor()))
          inner = made->getArg(0);
      }
      if (inner == expr) return expr;
      expr = inner;
    }
  }

  static std::string text(const llvm::APSInt& number, QualType type) {
    if (const auto* of = type.getCanonicalType()->getAs<EnumType>()) {
      for (const EnumConstantDecl* each : of->getDecl()->enumerators()) {
        if (llvm::APSInt::isSameValue(each->getInitVal(), number)) return each->getNameAsString();
      }
    }
    llvm::SmallString<24> digits;
    number.toString(digits, 10);
    return digits.str().str();
  }

  const ASTContext& context_;
};

/// Where facts come together; functions are looked at as they are met.
class Book {
public:
  Book(ASTContext& context, const std::string& directory) : context_(context), places_(context, directory) {}

  /// The key of the function, which is put down for a look if there is a body to see.
  std::string want(const FunctionDecl& function) {
    const FunctionDecl* body = nullptr;
    if (function.hasBody(body) && !body->isDependentContext() && !is_system(*body) && !is_directors(*body) &&
        wanted_.insert(body->getCanonicalDecl()).second)
      waiting_.push_back(body);
    return key_of(function);
  }
  const FunctionDecl* next() {
    if (waiting_.empty()) return nullptr;
    const FunctionDecl* function = waiting_.back();
    waiting_.pop_back();
    return function;
  }

  ASTContext& context() { return context_; }
  Places& places() { return places_; }
  std::vector<Json> functions, classes;

private:
  ASTContext& context_;
  Places places_;
  std::set<const Decl*> wanted_;
  std::vector<const FunctionDecl*> waiting_;
};

class BodyReader : public RecursiveASTVisitor<BodyReader> {
public:
  explicit BodyReader(Book& book) : book_(book), values_(book.context()) {}

  Json does = Json::list({}), calls = Json::list({}), blocks = Json::list({}), hidden = Json::list({});

  // What is written but never run.
  bool TraverseTypeLoc(TypeLoc) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr*) { return true; }
  bool TraverseCXXNoexceptExpr(CXXNoexceptExpr*) { return true; }
  bool TraverseCXXRecordDecl(CXXRecordDecl*) { return true; }

  bool TraverseIfStmt(IfStmt* branch) {
    bool holds = false;
    const Expr* condition = branch->getCond();
    if (condition == nullptr || condition->isValueDependent() ||
        !condition->EvaluateAsBooleanCondition(holds, book_.context()))
      return RecursiveASTVisitor::TraverseIfStmt(branch);
    TraverseStmt(branch->getInit());
    return TraverseStmt(holds ? branch->getThen() : branch->getElse());
  }

  bool TraverseLambdaExpr(LambdaExpr* lambda) {
    // Who has it may call it. One with `auto` has a body for each way in which it is called.
    if (!lambda->isGenericLambda()) {
      const FunctionDecl* body = lambda->getCallOperator();
      call(*body, lambda->getBeginLoc(), lambda->getBeginLoc(), true, given_to_std_.count(lambda) == 0, false);
    } else if (const FunctionTemplateDecl* many = lambda->getDependentCallOperator()) {
      for (const FunctionDecl* each : many->specializations())
        call(*each, lambda->getBeginLoc(), lambda->getBeginLoc(), true, given_to_std_.count(lambda) == 0, false);
    }
    for (Expr* capture : lambda->capture_inits()) {
      if (capture != nullptr) TraverseStmt(capture);
    }
    return true;
  }

  bool VisitCallExpr(CallExpr* expr) {
    callees_.insert(expr->getCallee()->IgnoreParenImpCasts());
    bool carries = false;
    for (const Expr* argument : expr->arguments()) carries = carries || carries_context(argument->getType());
    const Expr* object = nullptr;
    if (const auto* member = llvm::dyn_cast<CXXMemberCallExpr>(expr)) object = member->getImplicitObjectArgument();
    if (object != nullptr) carries = carries || carries_context(object->getType());
    const FunctionDecl* callee = expr->getDirectCallee();
    if (callee == nullptr) {
      if (!llvm::isa<CXXPseudoDestructorExpr>(expr->getCallee()->IgnoreParens()) && !expr->isTypeDependent())
        hide("a call through a pointer", expr->getBeginLoc(), expr->getEndLoc(), carries);
      return true;
    }
    if (callee->getLocation().isInvalid()) return true; // built in
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(callee);
    if (method != nullptr && object != nullptr && say_word(*expr, *method, *object)) return true;
    const SourceLocation at = name_place(*expr);
    if (is_directors(*callee)) return true;
    bool is_virtual = false;
    if (method != nullptr && method->isVirtual()) {
      const auto* member = llvm::dyn_cast<MemberExpr>(expr->getCallee()->IgnoreParens());
      is_virtual = member != nullptr && !member->hasQualifier() && object != nullptr &&
                   const_cast<CXXMethodDecl*>(method)->getDevirtualizedMethod(object, false) == nullptr;
    }
    if (is_system(*callee)) {
      system_call(*expr, *callee, at, carries);
      return true;
    }
    call(*callee, at, at, carries, false, is_virtual);
    return true;
  }

  bool VisitCXXConstructExpr(CXXConstructExpr* expr) {
    const CXXConstructorDecl* callee = expr->getConstructor();
    if (is_directors(*callee) || callee->isImplicit() || callee->isDefaulted()) return true;
    if (is_system(*callee)) {
      const bool copies_nothing = callee->isDefaultConstructor() || callee->isMoveConstructor();
      block(name_of(*callee), !copies_nothing, expr->getBeginLoc());
      return true;
    }
    bool carries = false;
    for (const Expr* argument : expr->arguments()) carries = carries || carries_context(argument->getType());
    call(*callee, expr->getBeginLoc(), expr->getBeginLoc(), carries, false, false);
    return true;
  }

  bool VisitCXXNewExpr(CXXNewExpr* expr) {
    if (expr->getNumPlacementArgs() == 0) block("operator new", true, expr->getBeginLoc());
    return true;
  }
  bool VisitCXXDeleteExpr(CXXDeleteExpr* expr) {
    block("operator delete", true, expr->getBeginLoc());
    return true;
  }

  /// A function that is named and not called here may be called by whoever gets it.
  bool VisitDeclRefExpr(DeclRefExpr* expr) {
    const auto* function = llvm::dyn_cast<FunctionDecl>(expr->getDecl());
    if (function == nullptr || callees_.count(expr) != 0 || is_system(*function) || is_directors(*function))
      return true;
    if (expr->isNonOdrUse() == NOUR_Unevaluated) return true;
    call(*function, expr->getLocation(), expr->getLocation(), false, true, false);
    return true;
  }

private:
  static SourceLocation name_place(const CallExpr& expr) {
    const Expr* callee = expr.getCallee()->IgnoreParenImpCasts();
    if (const auto* member = llvm::dyn_cast<MemberExpr>(callee)) return member->getMemberLoc();
    if (const auto* name = llvm::dyn_cast<DeclRefExpr>(callee)) return name->getLocation();
    return expr.getBeginLoc();
  }

  /// The words of a context. True: it is one of these, and there is nothing else to it.
  bool say_word(const CallExpr& expr, const CXXMethodDecl& method, const Expr& object) {
    const std::string context = context_of(object.getType());
    if (context.empty() || !method.getDeclName().isIdentifier()) return false;
    const CXXRecordDecl* of = method.getParent();
    const bool is_pack = !is_directors(*of) && context == name_of(*of);
    if (!is_pack && !is_directors(*of)) return false; // a class of the user that has a context's words
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
        Json list = Json::list({});
        for (const std::string& value : *values) list.add(Json::text(value));
        fact.add("values", std::move(list));
      }
      fact.add("at", book_.places().of(at, expr.getEndLoc()));
    } else if (word == "done" || word == "fail" || word == "keep") {
      fact.add("word", Json::text(word));
      fact.add("at", book_.places().of(at, at));
    } else {
      return true;
    }
    does.add(std::move(fact));
    return true;
  }

  /// `soccer::Walk`, also where it is to be kept.
  static std::string task_of(QualType type) {
    const CXXRecordDecl* record = bare(type)->getAsCXXRecordDecl();
    if (const auto* special = llvm::dyn_cast_or_null<ClassTemplateSpecializationDecl>(record)) {
      if (is_directors(*special) && special->getTemplateArgs().size() == 1 &&
          special->getTemplateArgs()[0].getKind() == TemplateArgument::Type)
        return task_of(special->getTemplateArgs()[0].getAsType());
    }
    return record == nullptr ? std::string{} : name_of(*record);
  }

  void system_call(const CallExpr& expr, const FunctionDecl& callee, SourceLocation at, bool carries) {
    const std::string name = name_of(callee);
    if (!block(name, true, at) && carries) {
      static const std::set<std::string> passes_on{"std::forward",   "std::move",     "std::ref", "std::cref",
                                                   "std::addressof", "std::as_const", "std::tie", "std::get"};
      bool only_lambdas = true; // what they do is known
      for (const Expr* argument : expr.arguments()) {
        const CXXRecordDecl* record = bare(argument->getType())->getAsCXXRecordDecl();
        const bool is_lambda = record != nullptr && record->isLambda();
        only_lambdas = only_lambdas && (is_lambda || !carries_context(argument->getType()));
      }
      if (passes_on.count(name) == 0 && !only_lambdas) hide("what `" + name + "` does with it", at, at, true);
    }
    if (!name.starts_with("std::") || name == "std::async" || name.starts_with("std::thread")) return;
    for (const Expr* argument : expr.arguments()) {
      if (const auto* lambda = llvm::dyn_cast<LambdaExpr>(argument->IgnoreUnlessSpelledInSource()))
        given_to_std_.insert(lambda);
    }
  }

  bool block(const std::string& name, bool with_arguments, SourceLocation at) {
    const std::string_view why = why_it_blocks(name, with_arguments);
    if (why.empty()) return false;
    blocks.add(Json::object({{"name", Json::text(name)}, {"why", Json::text(why)}, {"at", book_.places().of(at, at)}}));
    return true;
  }

  void call(const FunctionDecl& callee, SourceLocation begin, SourceLocation end, bool carries, bool maybe,
            bool is_virtual) {
    // What the compiler writes itself has nothing of this.
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
    const bool is_lambda = method != nullptr && method->getParent()->isLambda();
    if (callee.getLocation().isInvalid() || callee.isDefaulted() || (callee.isImplicit() && !is_lambda)) return;
    Json fact = Json::object({{"to", Json::text(book_.want(callee))},
                              {"name", Json::text(name_of(callee))},
                              {"at", book_.places().of(begin, end)}});
    const FunctionDecl* body = nullptr;
    if (!callee.hasBody(body)) fact.add("declared", book_.places().of(callee.getLocation(), callee.getLocation()));
    if (carries) fact.add("carries", Json::boolean(true));
    if (maybe) fact.add("maybe", Json::boolean(true));
    if (is_virtual) fact.add("virtual", Json::boolean(true));
    calls.add(std::move(fact));
  }

  void hide(std::string what, SourceLocation begin, SourceLocation end, bool carries) {
    Json fact = Json::object({{"what", Json::text(what)}, {"at", book_.places().of(begin, end)}});
    if (carries) fact.add("carries", Json::boolean(true));
    hidden.add(std::move(fact));
  }

  Book& book_;
  Values values_;
  std::set<const Expr*> callees_;
  std::set<const LambdaExpr*> given_to_std_;
};

void read_function(Book& book, const FunctionDecl& function) {
  BodyReader reader(book);
  if (const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&function)) {
    for (const CXXCtorInitializer* initial : maker->inits()) {
      if (initial->getInit() != nullptr) reader.TraverseStmt(initial->getInit());
    }
  }
  reader.TraverseStmt(function.getBody());
  const SourceLocation at = function.getLocation();
  Json out = Json::object({{"key", Json::text(key_of(function))},
                           {"name", Json::text(name_of(function))},
                           {"at", book.places().of(at, at)}});
  if (const auto* method = llvm::dyn_cast<CXXMethodDecl>(&function)) {
    Json above = Json::list({});
    for (const CXXMethodDecl* each : method->overridden_methods()) above.add(Json::text(key_of(*each)));
    if (!above.items().empty()) out.add("overrides", std::move(above));
    if (promised_by(*method) != nullptr) {
      out.add("context", Json::text(parameter_context(*method)));
      out.add("class", Json::text(name_of(*method->getParent())));
    }
  }
  const auto add = [&](const char* name, Json& list) {
    if (!list.items().empty()) out.add(name, std::move(list));
  };
  add("does", reader.does);
  add("calls", reader.calls);
  add("blocks", reader.blocks);
  add("hidden", reader.hidden);
  book.functions.push_back(std::move(out));
}

/// Classes that implement modules, and functions to begin at.
class Finder : public RecursiveASTVisitor<Finder> {
public:
  explicit Finder(Book& book) : book_(book) {}
  bool shouldVisitTemplateInstantiations() const { return true; }
  bool TraverseStmt(Stmt*) { return true; } // bodies are looked at when their turn comes

  bool VisitFunctionDecl(FunctionDecl* function) {
    if (!function->isThisDeclarationADefinition() || function->isDependentContext()) return true;
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(function);
    const bool is_body = method != nullptr && promised_by(*method) != nullptr;
    const SourceManager& sources = book_.context().getSourceManager();
    if (is_body || sources.isInMainFile(sources.getFileLoc(function->getLocation()))) book_.want(*function);
    return true;
  }

  bool VisitCXXRecordDecl(CXXRecordDecl* record) {
    if (!record->isThisDeclarationADefinition() || record->isDependentContext() || record->getNumBases() == 0)
      return true;
    const CXXRecordDecl* module = interface_of(*record);
    if (module == nullptr || is_directors(*record)) return true;
    Json bases = Json::list({}), missing = Json::list({}), stray = Json::list({});
    for (const CXXBaseSpecifier& base : record->bases()) {
      if (const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl()) bases.add(Json::text(key_of(*above)));
    }
    CXXFinalOverriderMap overriders;
    record->getFinalOverriders(overriders);
    for (const auto& [method, by_subobject] : overriders) {
      for (const auto& [subobject, last] : by_subobject) {
        const CXXMethodDecl* final_one = last.front().Method;
        if (final_one->isPureVirtual() && role_of(*final_one) != Role::none && is_interface(*final_one->getParent()))
          missing.add(Json::text(parameter_context(*final_one)));
      }
    }
    for (const CXXMethodDecl* method : record->methods()) {
      if (role_of(*method) == Role::none || method->size_overridden_methods() != 0) continue;
      const std::string context = parameter_context(*method);
      const bool is_lost = context.empty() && method->getNumParams() == 1 &&
                           (method->isInvalidDecl() || method->getParamDecl(0)->isInvalidDecl());
      if (context.empty() && !is_lost) continue;
      Json each = Json::object({{"at", book_.places().of(method->getLocation(), method->getLocation())}});
      if (is_lost) {
        each.add("wrote", Json::text(written(*method->getParamDecl(0))));
      } else {
        each.add("context", Json::text(context));
      }
      stray.add(std::move(each));
    }
    book_.classes.push_back(Json::object({{"key", Json::text(key_of(*record))},
                                          {"name", Json::text(name_of(*record))},
                                          {"module", Json::text(name_of(*module))},
                                          {"at", book_.places().of(record->getLocation(), record->getLocation())},
                                          {"bases", std::move(bases)},
                                          {"missing", std::move(missing)},
                                          {"stray", std::move(stray)}}));
    return true;
  }

private:
  std::string written(const ParmVarDecl& parameter) const {
    const CharSourceRange range = CharSourceRange::getTokenRange(parameter.getSourceRange());
    return Lexer::getSourceText(range, book_.context().getSourceManager(), book_.context().getLangOpts()).str();
  }

  Book& book_;
};

/// What `using Phase = soccer::GamePhase;` in the behaviour's namespace stands for.
Json aliases_of(const ASTContext& context, const std::string& space) {
  Json out = Json::object({});
  std::set<std::string> seen;
  const auto look = [&](const DeclContext* at, const auto& self) -> void {
    for (const Decl* decl : at->decls()) {
      const auto* inner = llvm::dyn_cast<NamespaceDecl>(decl);
      if (inner != nullptr && (space + "::").starts_with(name_of(*inner) + "::")) self(inner, self);
      const auto* alias = llvm::dyn_cast<TypedefNameDecl>(decl);
      if (alias == nullptr || is_system(*alias)) continue;
      const TagDecl* tag = alias->getUnderlyingType().getCanonicalType()->getAsTagDecl();
      const std::string name = name_of(*alias);
      if (tag != nullptr && name.starts_with(space + "::") && seen.insert(name).second)
        out.add(name, Json::text(name_of(*tag)));
    }
  };
  look(context.getTranslationUnitDecl(), look);
  return out;
}

Json read_unit(const Unit& unit, const std::string& space) {
  Json out = Json::object({});
  const Reading reading = parse(unit, [&](ASTContext& context) {
    Book book(context, unit.directory);
    Finder finder(book);
    finder.TraverseAST(context);
    while (const FunctionDecl* function = book.next()) read_function(book, *function);
    out.add("functions", Json::list(std::move(book.functions)));
    out.add("classes", Json::list(std::move(book.classes)));
    out.add("aliases", aliases_of(context, space));
    out.add("paths", book.places().files());
  });
  tell_reading(out, reading);
  return out;
}

} // namespace

Json tell_facts(const Json& request) {
  const std::vector<Json>& wanted = request["units"].items();
  const std::string space = request["namespace"].as_text();
  std::vector<Json> units(wanted.size());
  // A tree takes up to a few hundred MB, so no more at once than there are processors.
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < wanted.size(); i = next++) units[i] = read_unit(unit_of(wanted[i]), space);
  };
  std::vector<std::thread> helpers;
  const std::size_t count = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), wanted.size());
  for (std::size_t i = 1; i < count; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  return Json::object({{"units", Json::list(std::move(units))}});
}

} // namespace director::scanning
