// Header: compiler/play/scripted_bodies.hpp. Test: tests/compiler/play/play_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/scripted_bodies.hpp"

#include <algorithm>

namespace director::compiler {

director::Reason engine_reason(dsl::Reason reason) {
  switch (reason) {
  case dsl::Reason::new_task: return director::Reason::new_task;
  case dsl::Reason::pushed: return director::Reason::pushed;
  case dsl::Reason::subtask_done: return director::Reason::subtask_done;
  case dsl::Reason::wait: return director::Reason::wait;
  case dsl::Reason::trigger: break;
  }
  return director::Reason::trigger;
}

ScriptedBodies::ScriptedBodies(const Scenario& scenario, const Tables& tables, const Onlooker* onlooker)
    : scenario_(scenario),
      tables_(tables),
      onlooker_(onlooker),
      data_(tables.groups.size(), tables.edges.size()),
      runs_(tables.providers.size()),
      starts_(tables.groups.size()),
      stops_(tables.groups.size()) {}

Bodies ScriptedBodies::table() {
  Bodies bodies;
  bodies.self = this;
  bodies.run = [](void* self, Run& run) { return static_cast<ScriptedBodies*>(self)->run(run); };
  bodies.start = [](void* self, Handling& handling) {
    auto& me = *static_cast<ScriptedBodies*>(self);
    me.handle(handling, me.scenario_.start_handlers, me.starts_);
  };
  bodies.stop = [](void* self, Handling& handling) {
    auto& me = *static_cast<ScriptedBodies*>(self);
    me.handle(handling, me.scenario_.stop_handlers, me.stops_);
  };
  bodies.data = [](void* self, Bodies::Data what, Index edge, Index handle) {
    auto& me = *static_cast<ScriptedBodies*>(self);
    me.data_.move(what, edge, handle, me.tables_.edges[edge].target);
  };
  return bodies;
}

bool ScriptedBodies::has_data(const Case& each, DataPlace place) const {
  return !each.data || each.data == data_.at(place);
}

bool ScriptedBodies::holds(const UseGuard& guard, const Run& run) const {
  if (!guard.edge) return guard.state == dsl::UseState::none;
  const auto edge = static_cast<Index>(guard.edge->value);
  switch (guard.state) {
  case dsl::UseState::running: return run.state(edge) == RunState::running;
  case dsl::UseState::queued: return run.state(edge) == RunState::queued;
  case dsl::UseState::none: return run.state(edge) == RunState::none;
  case dsl::UseState::done: return run.done(edge) && !run.failed(edge);
  case dsl::UseState::failed: break;
  }
  return run.failed(edge);
}

bool ScriptedBodies::holds(const Case& each, const Run& run, std::int64_t count) const {
  if (each.reason && !run.reasons().has(engine_reason(*each.reason))) return false;
  if (each.trigger && !run.triggered(static_cast<Index>(each.trigger->value))) return false;
  if (each.run && *each.run != count) return false;
  return has_data(each, run.data()) &&
         std::all_of(each.uses.begin(), each.uses.end(), [&](const UseGuard& guard) { return holds(guard, run); });
}

/// The cases from the first one that is not for an earlier call: a recorded script has one for each call.
std::span<const Case> ScriptedBodies::cases_of_next_call(const Body& body, Calls& calls) {
  ++calls.count;
  while (calls.passed < body.size() && body[calls.passed].run && *body[calls.passed].run < calls.count) ++calls.passed;
  return std::span(body).subspan(calls.passed);
}

Outcome ScriptedBodies::run(Run& run) {
  Calls& calls = runs_[run.provider()];
  const std::span<const Case> cases = cases_of_next_call(scenario_.bodies[ProviderId{run.provider()}], calls);
  const auto found =
      std::find_if(cases.begin(), cases.end(), [&](const Case& each) { return holds(each, run, calls.count); });
  if (onlooker_ != nullptr) onlooker_->ran(ProviderId{run.provider()}, found == cases.end() ? nullptr : &*found);
  if (found == cases.end()) return run.keep();
  if (found->refused) {
    if (!refused_) refused_ = found->refused;
    return run.fault();
  }
  for (const Setting& setting : found->set) {
    run.set(static_cast<Index>(setting.state.value), static_cast<std::int32_t>(setting.value));
  }
  if (found->wait > 0) run.wait(found->wait);
  switch (found->answer) {
  case Case::Answer::done: return run.done();
  case Case::Answer::failed: return run.fail();
  case Case::Answer::keep: return run.keep();
  case Case::Answer::pack: break;
  }
  for (const RequestedTask& task : found->pack) {
    const auto edge = static_cast<Index>(task.edge.value);
    const auto level = static_cast<Index>(tables_.edges[edge].levels.begin + task.level);
    if (run.request(edge, level, task.keep)) data_.stage(edge, task.data);
  }
  return run.pack(static_cast<std::uint16_t>(found->named_pack.value_or(0)));
}

void ScriptedBodies::handle(Handling& handling, const IdTable<GroupId, Body>& bodies, std::vector<Calls>& calls) {
  Calls& own = calls[handling.group()];
  for (const Case& each : cases_of_next_call(bodies[GroupId{handling.group()}], own)) {
    if ((each.run && *each.run != own.count) || !has_data(each, handling.data())) continue;
    for (const Setting& setting : each.set) {
      handling.set(static_cast<Index>(setting.state.value), static_cast<std::int32_t>(setting.value));
    }
    return;
  }
}

} // namespace director::compiler
