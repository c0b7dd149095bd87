// Header: compiler/clang/subcommands.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
//
// Reads what the functions of some translation units do with respect to a behaviour, and what they call. It has no
// rules: directorc decides what is a fault (compiler/facts/code.hpp explains the facts).
//
// Templates are read where they are instantiated. Functions are taken from the file itself, with all that they call as
// far as bodies are visible here; other files report theirs.
#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/bodies/book.hpp"
#include "compiler/clang/parse/parse.hpp"
#include "compiler/clang/parse/units.hpp"
#include "compiler/clang/subcommands.hpp"

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

namespace director::scanning {

namespace {

using namespace clang;

/// The types that `using Phase = soccer::GamePhase;` in the behaviour's namespace names.
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
  const Reading reading = parse(
      unit,
      [&](ASTContext& context) {
        Book book(context, unit.directory, unit.is_deep);
        find_classes(book);
        while (const FunctionDecl* function = book.next()) read_function(book, *function);
        out.add("functions", Json::list(std::move(book.functions)));
        out.add("classes", Json::list(std::move(book.classes)));
        if (!book.continued.empty()) out.add("continued", Json::texts({book.continued.begin(), book.continued.end()}));
        if (!book.runs.empty()) out.add("runs", Json::texts({book.runs.begin(), book.runs.end()}));
        if (book.has_templates) out.add("templates", Json::boolean(true));
        out.add("aliases", aliases_of(context, space));
        out.add("paths", book.places().files());
      },
      instantiate_bodies);
  report_reading(out, reading);
  return out;
}

} // namespace

Json report_facts(const Json& request) {
  const std::vector<Json>& wanted = request["units"].items();
  const std::string space = request["namespace"].as_text();
  std::vector<Json> units(wanted.size());
  // A tree takes up to a few hundred MB, so at most as many at once as there are processors.
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
