// Header: compiler/play/why/moment.hpp. Test: tests/compiler/play/why/moment_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/why/moment.hpp"

#include "compiler/play/why/why.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

using Mark = Moment::Mark;

std::optional<std::uint32_t> level_of(const View& view, Index edge) {
  if (!view.requested(edge)) return {};
  return static_cast<std::uint32_t>(view.request[edge].level - view.tables->edges[edge].levels.begin);
}

Mark mark_of_edge(const View& view, Index edge, Index target) {
  if (view.state(edge) == RunState::running) return Mark::running;
  if (view.requested(edge)) return Mark::queued;
  return view.holder(target) == edge ? Mark::held : Mark::inactive;
}

/// Without the names of the waiting tasks: `until Stability == standing, which Walk.halting could cause`.
std::string reason(const View& view, GroupId group, const Model& model, const Lowered& lowered) {
  const std::string text = text_why(view, group, model, lowered);
  const std::size_t at = text.find("): ");
  return at == std::string::npos ? text : text.substr(at + 3);
}

Moment::Standing standing_of(const View& view, GroupId group, const Model& model, const Lowered& lowered) {
  const auto row = static_cast<Index>(group.value);
  const GroupAssignment& now = view.assignment[row];
  Moment::Standing out;
  if (now.active != nil) out.active = ProviderId{now.active};
  bool requested = false;
  for (const EdgeId edge : model.groups[group].requesters)
    requested = requested || view.requested(static_cast<Index>(edge.value));
  if (view.granted(row)) {
    out.mark = now.in_force() ? Mark::pushed : Mark::running;
    if (out.mark == Mark::pushed) {
      const GroupId waits = model.edges[EdgeId{now.push.edge}].target;
      out.note = fmt::format("pushed to {} for {}", model.providers[*out.active].name, model.groups[waits].name.value);
    }
    return out;
  }
  if (requested) {
    out.mark = Mark::queued;
    out.note = reason(view, group, model, lowered);
    return out;
  }
  if (now.holder != nil) out.mark = Mark::held;
  return out;
}

std::string condition_text(const Model& model, const Lowered& lowered, Index condition) {
  return condition == nil ? std::string{} : model.conditions[lowered.condition_ids[condition]].text;
}

} // namespace

Moment moment_of(const View& view, const Model& model, const Lowered& lowered) {
  Moment out;
  for (const GroupId group : model.groups.ids()) {
    out.groups.push_back(standing_of(view, group, model, lowered));
    if (out.groups.back().mark != Mark::pushed) continue;
    const Push& push = view.assignment[group.value].push;
    const GroupId waits = model.edges[EdgeId{push.edge}].target;
    const ProviderId to{push.provider};
    const std::string condition = condition_text(model, lowered, push.condition);
    out.pushes.push_back({waits, group, to, condition,
                          fmt::format("{} has pushed {} to cause {}", model.groups[waits].name.value,
                                      model.distinct_name(to), condition)});
  }
  for (const EdgeId edge : model.edges.ids()) {
    const Index target = static_cast<Index>(model.edges[edge].target.value);
    out.edges.push_back(mark_of_edge(view, static_cast<Index>(edge.value), target));
    out.levels.push_back(level_of(view, static_cast<Index>(edge.value)));
  }
  for (const StateId id : model.states.ids()) {
    const State& state = model.states[id];
    const std::int32_t value = view.values[id.value].value;
    out.values.push_back(value == unset ? fmt::format("{} is unset", state.name.value)
                                        : fmt::format("{} == {}", state.name.value, state.value_text(value)));
  }
  return out;
}

} // namespace director::compiler
