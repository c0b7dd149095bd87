// Header: compiler/play/scenario/unreachable_cases.hpp. Test: compiler/checks/unreachable_case.md.
// SPDX-License-Identifier: MIT
#include "compiler/play/scenario/unreachable_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

using dsl::CaseSpec;

/// Whether `later` has the same guard, or `earlier` has none.
template <class Guard>
bool same_or_none(const std::optional<Guard>& earlier, const std::optional<Guard>& later) {
  return !earlier || (later && earlier->value == later->value);
}

/// Whether `earlier` applies whenever `later` would, and is the first.
bool hides(const CaseSpec& earlier, const CaseSpec& later) {
  using State = dsl::UseState;
  const auto is_there = [&](const dsl::UseGuardSpec& guard) {
    return std::any_of(later.uses.begin(), later.uses.end(), [&](const dsl::UseGuardSpec& each) {
      // What is done or has failed is running.
      const bool runs =
          guard.state.value == State::running && (each.state.value == State::done || each.state.value == State::failed);
      return each.group.value == guard.group.value && (each.state.value == guard.state.value || runs);
    });
  };
  const bool reason =
      same_or_none(earlier.reason, later.reason) || (earlier.reason->value == dsl::Reason::trigger && later.trigger);
  return reason && same_or_none(earlier.trigger, later.trigger) && same_or_none(earlier.data, later.data) &&
         same_or_none(earlier.run, later.run) && std::all_of(earlier.uses.begin(), earlier.uses.end(), is_there);
}

bool listens(const Model& model, ProviderId id, const std::string& trigger) {
  const std::vector<Use<TriggerId>>& all = model.providers[id].triggers;
  return std::any_of(all.begin(), all.end(),
                     [&](const Use<TriggerId>& use) { return model.triggers[use.id].name == trigger; });
}

/// Why none of the providers, which are of one group, ever runs so; empty: some may. A trigger is a reason for the
/// group: if its provider changes before the run, the other one sees what fired for the first.
std::string never(const CaseSpec& spec, const std::vector<ProviderId>& providers, const Model& model) {
  if (providers.empty()) return {}; // a handler
  const Group& group = model.groups[model.providers[providers.front()].group];
  const auto none = [](const std::vector<ProviderId>& of, const auto& may) {
    return std::none_of(of.begin(), of.end(), may);
  };
  if (spec.trigger && none(group.providers, [&](ProviderId id) { return listens(model, id, spec.trigger->value); }))
    return fmt::format("no provider of `{}` listens to `{}`", group.name.value, spec.trigger->value);
  if (spec.reason && spec.reason->value == dsl::Reason::trigger && none(group.providers, [&](ProviderId id) {
        return !model.providers[id].triggers.empty() || model.providers[id].every;
      }))
    return fmt::format("no provider of `{}` listens to a trigger or has `every`", group.name.value);
  if (spec.reason && spec.reason->value == dsl::Reason::pushed &&
      none(providers, [&](ProviderId id) { return !model.providers[id].causing.empty(); }))
    return "none of its providers has `causing`, so none is ever pushed";
  return {};
}

std::string name_of(const dsl::ScriptEntrySpec& entry) {
  return entry.part ? entry.group.value + "." + entry.part->value : entry.group.value;
}

} // namespace

void find_unreachable_cases(const dsl::ScriptEntrySpec& entry, const std::vector<ProviderId>& providers,
                            const Model& model, std::vector<dsl::Diagnostic>& findings) {
  const auto warn = [&](Span span, std::string message, std::vector<dsl::Note> notes, std::string help) {
    findings.push_back(
        {"unreachable_case", dsl::Level::warning, span, std::move(message), std::move(notes), std::move(help)});
  };
  const std::string name = name_of(entry);
  for (auto later = entry.cases.begin(); later != entry.cases.end(); ++later) {
    const auto earlier =
        std::find_if(entry.cases.begin(), later, [&](const CaseSpec& each) { return hides(each, *later); });
    if (earlier != later) {
      warn(later->span, fmt::format("this case of `{}` never applies: an earlier one does whenever it would", name),
           {{earlier->span, "this one"}}, "put what is special before what is general, or leave it out");
    } else if (const std::string why = never(*later, providers, model); !why.empty()) {
      warn(later->span, fmt::format("this case of `{}` never applies: {}", name, why), {}, "leave it out");
    }
  }
}

} // namespace director::compiler
