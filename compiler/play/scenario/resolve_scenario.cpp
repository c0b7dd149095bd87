// Header: compiler/play/scenario/resolve_scenario.hpp. Test: tests/compiler/play/scenario/resolve_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/scenario/resolve_scenario.hpp"

#include "compiler/play/scenario/resolve_case.hpp"
#include "compiler/play/scenario/unreachable_cases.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "dsl/source/file_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

using dsl::Diagnostic;
using InputKind = dsl::InputSpec::Kind;

class Resolving {
public:
  Resolving(const dsl::ScenarioSpec& spec, const Model& model)
      : spec_(spec),
        model_(model),
        names_(model, out_.findings) {}

  ResolvedScenario resolve() {
    Scenario& scenario = out_.scenario;
    if (spec_.title) scenario.title = spec_.title->value;
    scenario.bodies = IdTable<ProviderId, Body>(model_.providers.size());
    scenario.start_handlers = scenario.stop_handlers = IdTable<GroupId, Body>(model_.groups.size());
    for (const dsl::SettingSpec& given : spec_.given) {
      if (const auto setting = names_.setting(given)) scenario.given.push_back(*setting);
    }
    resolve_script();
    for (const dsl::StepSpec& step : spec_.steps) resolve_step(step);
    // A fault may be the reason why a case never applies.
    if (out_.findings.empty()) out_.findings = std::move(warnings_);
    dsl::sort_by_place(out_.findings);
    return std::move(out_);
  }

private:
  // Script

  void resolve_script() {
    // An entry for a provider replaces that of its group, in any order.
    for (const dsl::ScriptEntrySpec& entry : spec_.script) {
      const std::optional<GroupId> group = names_.group(entry.group);
      if (!group || !entry.part) continue;
      if (entry.part->value == "start" || entry.part->value == "stop") {
        resolve_handler(entry, *group);
      } else if (const auto provider = resolve_part(*group, *entry.part)) {
        scripted_.insert(*provider);
        resolve_cases(entry, {*provider});
      }
    }
    for (const dsl::ScriptEntrySpec& entry : spec_.script) {
      const std::optional<GroupId> group = model_.find_group(entry.group.value);
      if (group && !entry.part) resolve_group_entry(entry, *group);
    }
    for (const ProviderId id : model_.providers.ids()) {
      if (!scripted_.contains(id)) out_.scenario.bodies[id] = {unscripted(model_, id)};
    }
  }

  /// A provider; a handler would be possible too.
  std::optional<ProviderId> resolve_part(GroupId id, const Word& name) {
    const Group& group = model_.groups[id];
    if (!group.start && !group.stop) return names_.provider(id, name);
    std::vector<std::string> known;
    for (const ProviderId each : group.providers) {
      if (model_.providers[each].name == name.value) return each;
      known.push_back(model_.providers[each].name);
    }
    if (group.start) known.emplace_back("start");
    if (group.stop) known.emplace_back("stop");
    names_.undefined(name.span,
                     fmt::format("the group `{}` has no provider or handler called `{}`", group.name.value, name.value),
                     name.value, known);
    return std::nullopt;
  }

  void resolve_group_entry(const dsl::ScriptEntrySpec& entry, GroupId group) {
    std::vector<ProviderId> providers;
    for (const ProviderId id : model_.groups[group].providers) {
      if (!scripted_.contains(id)) providers.push_back(id);
    }
    if (providers.empty())
      warnings_.push_back({"unreachable_case",
                           dsl::Level::warning,
                           entry.group.span,
                           fmt::format("the entry for `{}` has no effect: each of its providers has an entry of its "
                                       "own",
                                       entry.group.value),
                           {},
                           "leave it out"});
    scripted_.insert(providers.begin(), providers.end());
    resolve_cases(entry, providers);
  }

  /// What no provider of the entry can do is a finding; what only some of them cannot is refused when they run it.
  void resolve_cases(const dsl::ScriptEntrySpec& entry, const std::vector<ProviderId>& providers) {
    for (const dsl::CaseSpec& spec : entry.cases) {
      std::vector<Diagnostic> first_faults;
      std::size_t faulty = 0;
      for (const ProviderId id : providers) {
        std::vector<Diagnostic> faults;
        Names names(model_, faults);
        Case resolved = resolve_case(spec, id, names);
        if (!faults.empty()) {
          resolved.refused = faults.front();
          if (faulty++ == 0) first_faults = std::move(faults);
        }
        out_.scenario.bodies[id].push_back(std::move(resolved));
      }
      if (faulty == providers.size() && faulty != 0)
        out_.findings.insert(out_.findings.end(), first_faults.begin(), first_faults.end());
    }
    if (!providers.empty()) find_unreachable_cases(entry, providers, model_, warnings_);
  }

  void resolve_handler(const dsl::ScriptEntrySpec& entry, GroupId id) {
    const Group& group = model_.groups[id];
    const std::string& which = entry.part->value;
    const std::optional<Handler>& handler = which == "start" ? group.start : group.stop;
    if (!handler) {
      names_.error("undefined_name", entry.part->span,
                   fmt::format("the group `{}` has no {} handler", group.name.value, which),
                   fmt::format("`{}: true` at the group declares one", which));
      return;
    }
    Body& body = (which == "start" ? out_.scenario.start_handlers : out_.scenario.stop_handlers)[id];
    for (const dsl::CaseSpec& spec : entry.cases) {
      body.push_back(resolve_handler_case(spec, id, which, *handler, names_));
    }
    find_unreachable_cases(entry, {}, model_, warnings_);
  }

  // Steps

  void resolve_step(const dsl::StepSpec& spec) {
    ScenarioStep step;
    step.span = spec.span;
    step.expect = spec.expect;
    if (spec.advance) {
      step.advance = spec.advance->value.microseconds();
      step.shown.push_back("advance " + dsl::to_text(spec.advance->value));
    }
    for (const dsl::InputSpec& input : spec.inputs) {
      step.shown.push_back(input.shown);
      step.inputs.push_back(resolve_input(input));
    }
    out_.scenario.steps.push_back(std::move(step));
  }

  ScenarioInput resolve_input(const dsl::InputSpec& spec) {
    ScenarioInput input;
    input.kind = spec.kind.value;
    switch (spec.kind.value) {
    case InputKind::request:
      for (const dsl::RequestSpec& entry : spec.requests) {
        if (auto request = names_.request(model_.roots, "`roots` has", entry))
          input.requests.push_back(std::move(*request));
      }
      break;
    case InputKind::cancel:
      if (const Task* task = names_.task(model_.roots, "`roots` has", spec.name)) input.root = task->edge;
      break;
    case InputKind::set:
      for (const dsl::SettingSpec& each : spec.set) resolve_external(each, input);
      break;
    case InputKind::trigger:
      if (const auto promise = find_promise(model_, spec.name.value)) {
        names_.error("undefined_name", spec.name.span,
                     fmt::format("a step cannot fire `{}`: only the engine does", spec.name.value),
                     fmt::format("let the script of `{}` not set what it promises, and `advance` beyond its `within`",
                                 model_.full_name(*promise)));
      } else if (const auto trigger = names_.trigger(spec.name, true)) {
        input.trigger = *trigger;
      }
      break;
    case InputKind::enable:
    case InputKind::disable:
      if (const auto group = names_.group(spec.name)) {
        if (const auto provider = names_.provider(*group, spec.provider)) input.provider = *provider;
      }
      break;
    }
    return input;
  }

  void resolve_external(const dsl::SettingSpec& spec, ScenarioInput& input) {
    const std::optional<Setting> setting = names_.setting(spec);
    if (!setting) return;
    input.set.push_back(*setting);
    const State& state = model_.states[setting->state];
    if (state.external) return;
    Diagnostic& finding =
        names_.error("undeclared_state_write", spec.state.span,
                     fmt::format("a step sets only external states, and `{}` is not one", state.name.value),
                     "`given` sets any state at the start; a script's `set` what a provider declares");
    finding.notes.push_back({state.name.span, "it is declared here, without `external: true`"});
  }

  const dsl::ScenarioSpec& spec_;
  const Model& model_;
  ResolvedScenario out_;
  std::vector<Diagnostic> warnings_;
  Names names_;
  std::set<ProviderId> scripted_;
};

} // namespace

ResolvedScenario resolve_scenario(const dsl::ScenarioSpec& spec, const Model& model) {
  return Resolving(spec, model).resolve();
}

std::optional<Scenario> scenario_from(const std::string& text, const Model& model) {
  const char* const path = "written.scenario.yaml";
  dsl::MemoryFiles files;
  files.add(path, text);
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, files, sources);
  if (dsl::has_errors(read.diagnostics)) return std::nullopt;
  ResolvedScenario resolved = resolve_scenario(read.scenario, model);
  if (dsl::has_errors(resolved.findings)) return std::nullopt;
  return std::move(resolved.scenario);
}

} // namespace director::compiler
