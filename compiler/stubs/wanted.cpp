// Header: compiler/stubs/wanted.hpp. Test: tests/compiler/stubs/wanted_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/wanted.hpp"

#include "compiler/emit/cpp/parts.hpp"
#include "compiler/model/cpp_names.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::stubs {

namespace {

using Kind = WantedFunction::Kind;

/// `doc`, and its place.
std::string opening(const Deployment& from, std::string_view doc, const dsl::Span& span) {
  while (doc.ends_with('\n')) doc.remove_suffix(1);
  return fmt::format("{}{}({})", doc, doc.empty() ? "" : " ", place_text(from, span));
}

std::string pack_words(const Model& model, const Pack& pack) {
  const std::string tasks = pack.tasks.empty() ? "nothing" : tasks_text(model, pack.tasks);
  return fmt::format("- {}: {}{}{}", pack.name, tasks, pack.doc.empty() ? "" : "; ", pack.doc);
}

WantedFunction of_provider(const Deployment& from, ProviderId id) {
  const Model& model = from.model;
  const Provider& provider = model.providers[id];
  const std::string& doc = provider.direct ? model.groups[provider.group].doc : provider.doc;
  WantedFunction out{Kind::provide,
                     fmt::format("{}::{}", model.name_space, provider_name(model, id)),
                     {opening(from, doc, provider.span)}};
  for (std::string& line : words_of(model, provider)) out.words.push_back(std::move(line));
  if (!provider.has_packs) return out;
  for (const Pack& pack : provider.packs) out.words.push_back(pack_words(model, pack));
  return out;
}

WantedFunction of_handler(const Deployment& from, GroupId group, Kind kind, const Handler& handler) {
  const std::string_view context = kind == Kind::start ? "Start" : "Stop";
  WantedFunction out{kind,
                     fmt::format("{}::{}::{}", from.model.name_space, group_name(from.model, group), context),
                     {opening(from, {}, handler.span)}};
  const std::string sets = conditions_text(from.model, handler.sets);
  if (!sets.empty()) out.words.push_back("- sets: " + sets);
  return out;
}

/// A file must not have the name of the generated header, which it includes, or of the program's own main file.
std::string stem_of(const Model& model, const Module& module) {
  const bool taken = module.name == model.name || module.name == "main";
  return taken ? module.name + "_module" : module.name;
}

std::string outermost(const Model& model) { return model.name_space.substr(0, model.name_space.find(':')); }

/// A class outside of all namespaces must not have the name of one, or of a global name of the standard headers.
std::string class_of(const Model& model, ModuleId module) {
  const std::string name = module_type(model, module);
  return name == outermost(model) || dsl::is_cpp_global(name) ? name + "Module" : name;
}

} // namespace

std::string_view name_of(Kind kind) {
  return kind == Kind::provide ? "provide" : kind == Kind::start ? "start" : "stop";
}

Wanted wanted(const Deployment& deployment) {
  const Model& model = deployment.model;
  Wanted out{model.name, header_name(model.name), model.name_space, {}, {}};
  for (const ModuleId id : model.modules.ids()) {
    const Module& module = model.modules[id];
    WantedModule row{module.name,
                     fmt::format("{}::{}", model.name_space, module_type(model, id)),
                     class_of(model, id),
                     stem_of(model, module),
                     {}};
    for (const GroupId group_id : module.groups) {
      const Group& group = model.groups[group_id];
      if (group.start) row.functions.push_back(of_handler(deployment, group_id, Kind::start, *group.start));
      if (group.stop) row.functions.push_back(of_handler(deployment, group_id, Kind::stop, *group.stop));
      for (const ProviderId provider : group.providers) row.functions.push_back(of_provider(deployment, provider));
    }
    out.modules.push_back(std::move(row));
  }
  const auto modules = model.modules.ids();
  const bool hidden = std::any_of(modules.begin(), modules.end(),
                                  [&](ModuleId id) { return module_type(model, id) == outermost(model); });
  for (WantedModule& module : out.modules)
    for (WantedFunction& function : module.functions) function.from_outside = hidden;
  for (const Task& root : model.roots)
    out.roots.push_back({fmt::format("{}::{}", model.name_space, group_name(model, root.target)),
                         !model.groups[root.target].data.empty()});
  return out;
}

std::string to_text(const Wanted& wanted) {
  std::string out = fmt::format("{} in {}\n", wanted.behaviour, wanted.header);
  for (const WantedModule& module : wanted.modules) {
    out += fmt::format("{}: {}, class {}, files {}\n", module.name, module.interface, module.class_name, module.stem);
    for (const WantedFunction& function : module.functions) {
      out += fmt::format("  {} {}\n", name_of(function.kind), function.context);
      for (const std::string& line : function.words) out += fmt::format("    {}\n", line);
    }
  }
  return out;
}

} // namespace director::compiler::stubs
