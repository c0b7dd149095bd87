// Header: compiler/transitions/trial.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/trial.hpp"

#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "compiler/play/why/why.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::transitions {

namespace {

Rest rest_of(const View& view, const Model& model) {
  Rest out;
  for (const GroupId id : model.groups.ids()) {
    const auto row = static_cast<Index>(id.value);
    const Index holder = view.holder(row), active = view.assignment[row].active;
    Rest::Held held;
    if (holder != nil && !view.is_limbo(holder)) held.by = EdgeId{holder};
    if (active != nil) held.active = ProviderId{active};
    held.granted = view.granted(row);
    out.groups.push_back(held);
  }
  for (const EdgeId id : model.edges.ids()) {
    const auto row = static_cast<Index>(id.value);
    out.running.push_back(view.state(row) == RunState::running);
    out.requested.push_back(view.requested(row));
    out.blocked.push_back(view.state(row) == RunState::queued && view.queued(row).why == Why::blocked);
  }
  for (const StateId id : model.states.ids()) {
    const std::int32_t value = view.values[id.value].value;
    if (value != unset) out.values.emplace(id, value);
  }
  return out;
}

/// The expected requester runs another way, or its body has not come to it: names the active provider, if there are
/// several.
std::string why_not_requested(const View& view, const Model& model, GroupId requester, const Task& task) {
  const std::string& requested = model.groups[task.target].name.value;
  const Group& group = model.groups[requester];
  const Index active = view.assignment[requester.value].active;
  if (active == nil) return fmt::format("nothing requests {}", requested);
  const std::string in =
      group.providers.size() == 1 ? std::string{} : fmt::format(" in {}", model.providers[ProviderId{active}].name);
  return fmt::format("{} runs{} and does not request {}", group.name.value, in, requested);
}

/// For the first group of the chain that does not run for it.
void explain_refusal(const View& view, const Model& model, const Lowered& lowered, const Way& way, Trial& out) {
  const auto state = [&](const Task& task) { return view.state(static_cast<Index>(task.edge.value)); };
  const auto runs = [&](const Task& task) { return state(task) == RunState::running; };
  const Task* stuck = runs(*way.root) ? nullptr : way.root;
  std::optional<GroupId> requester;
  for (std::size_t i = 0; i < way.links.size() && stuck == nullptr; ++i) {
    if (runs(*way.links[i].next)) continue;
    stuck = way.links[i].next;
    requester = way.group(i);
  }
  if (stuck == nullptr) return;
  const std::vector<EdgeId>& requesters = model.groups[way.target].requesters;
  out.is_requested = std::any_of(requesters.begin(), requesters.end(),
                                 [&](EdgeId id) { return view.requested(static_cast<Index>(id.value)); });
  const bool waits = state(*stuck) != RunState::none;
  if (waits && view.granted(static_cast<Index>(stuck->target.value))) { // that one runs for another requester
    out.why = text_why(view, stuck->edge, model, lowered);
  } else if (requester && !waits && !out.is_requested) {
    out.why = why_not_requested(view, model, *requester, *stuck);
  } else {
    out.why = text_why(view, out.is_requested ? way.target : stuck->target, model, lowered);
  }
}

/// Those that ran in the last quarter of the events.
std::vector<GroupId> round_of(const std::vector<Event>& events) {
  std::vector<GroupId> out;
  for (std::size_t i = events.size() - events.size() / 4; i < events.size(); ++i) {
    if (events[i].kind == Event::Kind::run) out.emplace_back(GroupId{events[i].group});
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

} // namespace

bool Rest::is_under(const Model& model, GroupId group, EdgeId edge) const {
  std::optional<EdgeId> by = groups[group.value].by;
  for (std::size_t steps = 0; by && steps <= groups.size(); ++steps) {
    if (*by == edge) return true;
    const std::optional<GroupId> above = model.edges[*by].requester;
    by = above ? groups[above->value].by : std::nullopt;
  }
  return false;
}

bool Rest::is_for(const Model& model, GroupId group, GroupId above) const {
  std::optional<GroupId> at = group;
  for (std::size_t steps = 0; at && steps <= groups.size(); ++steps) {
    if (*at == above) return true;
    const std::optional<EdgeId> by = groups[at->value].by;
    at = by ? model.edges[*by].requester : std::nullopt;
  }
  return false;
}

std::vector<SetState> set_states_of(std::span<const Event> events) {
  std::vector<SetState> out;
  for (const Event& event : events) {
    if (event.kind == Event::Kind::assign && event.provider != nil)
      out.push_back({ProviderId{event.provider}, StateId{event.state}, event.value});
  }
  return out;
}

bool has_stopped(const Trial& trial, GroupId group) {
  return std::any_of(trial.events.begin(), trial.events.end(),
                     [&](const Event& event) { return event.kind == Event::Kind::stop && event.group == group.value; });
}

Trial play_trial(const std::string& text, const Model& model, const Lowered& lowered, std::uint32_t from,
                 const Way& way) {
  Trial out;
  const std::optional<Scenario> scenario = scenario_from(text, model);
  if (!scenario) return out;
  struct Listener {
    Trial& to;
    std::uint32_t from, step = 0;
  } listener{out, from};
  PlayOptions options;
  options.events = {[](void* self, const Event& event) {
                      auto& me = *static_cast<Listener*>(self);
                      if (event.kind == Event::Kind::run) ++me.to.runs[ProviderId{event.provider}];
                      if (me.step >= me.from) me.to.events.push_back(event);
                    },
                    &listener};
  options.end = [&](const Engine& engine) {
    const View view = view_of(engine);
    out.work = engine.work();
    out.rest = rest_of(view, model);
    explain_refusal(view, model, lowered, way, out);
  };
  const Played played = play(*scenario, model, lowered, options, [&](const Happening& happening) {
    if (happening.kind == Happening::Kind::input) listener.step = happening.step;
  });
  out.good = !played.refused && !played.budget_exhausted;
  out.endless = played.budget_exhausted;
  if (out.endless) out.round = round_of(out.events);
  return out;
}

} // namespace director::compiler::transitions
