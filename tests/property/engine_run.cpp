// Door: tests/property/engine_run.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/engine_run.hpp"

#include <stdexcept>

namespace director::property {

namespace {

constexpr std::size_t inbox_cells = 64; ///< more than the inputs of any step have records

director::Input record(director::Input::Kind kind, std::uint32_t thing) {
  director::Input out;
  out.kind = kind;
  out.thing = static_cast<Index>(thing);
  return out;
}

} // namespace

EngineRun::EngineRun(const Compiled& compiled, bool leap)
    : compiled_(compiled),
      tables_(compiled.lowered.view()),
      sink_([this](const compiler::Happening& each) { trace_.push_back(to_text(each)); }),
      bodies_(compiled.scenario, tables_),
      recorder_(compiled.model, compiled.lowered, false, sink_),
      cells_(inbox_cells),
      inbox_(cells_),
      memory_(tables_),
      engine_(tables_, memory_.state().data(), bodies_.table(), inbox_, recorder_.observer()),
      leap_(leap) {
  for (const compiler::Setting& given : compiled.scenario.given) {
    engine_.preset(static_cast<Index>(given.state.value), static_cast<std::int32_t>(given.value));
  }
  if (!leap) engine_.set_most_decided_whole(0); // few cases have components as large as these mostly are
  engine_.step(0);
  engine_.set_budget(1);
}

void EngineRun::begin_step(const compiler::ScenarioStep& step) {
  until_ = now_ + step.advance.value_or(0);
  if (leap_) now_ = until_;
  for (const compiler::ScenarioInput& input : step.inputs) post(input);
}

bool EngineRun::micro_step() {
  switch (engine_.step(now_)) {
  case StepResult::budget_exhausted: return true;
  case StepResult::quiescent: break;
  default: throw std::runtime_error("a step of the engine was refused, or a body failed");
  }
  if (engine_.next_due() > until_) {
    now_ = until_;
    return false;
  }
  now_ = engine_.next_due();
  return true;
}

void EngineRun::post(const compiler::ScenarioInput& input) {
  using Wanted = dsl::InputSpec::Kind;
  using Record = director::Input::Kind;
  std::vector<director::Input> records;
  switch (input.kind) {
  case Wanted::request:
    for (const compiler::Asked& asked : input.requests) {
      records.push_back(record(Record::request, asked.edge.value));
      const Range levels = tables_.edges[records.back().thing].levels;
      records.back().level = static_cast<Index>(levels.begin + asked.level);
      records.back().handle = bodies_.data().wait_for_input(asked.data);
    }
    break;
  case Wanted::set:
    for (const compiler::Setting& setting : input.set) {
      records.push_back(record(Record::set, setting.state.value));
      records.back().value = static_cast<std::int32_t>(setting.value);
    }
    break;
  case Wanted::cancel: records.push_back(record(Record::cancel, input.root.value)); break;
  case Wanted::trigger: records.push_back(record(Record::fire, input.trigger.value)); break;
  case Wanted::enable: records.push_back(record(Record::enable, input.provider.value)); break;
  case Wanted::disable: records.push_back(record(Record::disable, input.provider.value)); break;
  }
  for (std::size_t i = 0; i + 1 < records.size(); ++i) records[i].more = true;
  if (!(leap_ ? inbox_.post(records) : engine_.post(records)))
    throw std::runtime_error("the inbox of the test is too small");
}

Snapshot EngineRun::snapshot() const {
  const director::State& s = engine_.memory();
  Snapshot out;
  out.lines = trace_.size();
  for (Index g = 0; g < tables_.groups.size(); ++g) {
    Snapshot::Group& group = out.groups.emplace_back();
    if (engine_.holder(g) != nil) group.holder = oracle::EdgeId{engine_.holder(g)};
    if (engine_.active(g) != nil) group.active = oracle::ProviderId{engine_.active(g)};
    group.granted = engine_.granted(g);
    group.needed = (s.last[g].flags & flag::needed) != 0;
    group.in_force = engine_.in_force(g);
    if (const director::Push& push = s.last[g].push; push.edge != nil) {
      group.push = oracle::Push{oracle::EdgeId{push.edge}, oracle::ProviderId{push.provider},
                                compiled_.lowered.condition_ids[push.condition]};
    }
    const Reasons pending(s.run_queue[g].pending);
    for (const auto& [reason, there] : {std::pair{oracle::Reason::new_task, director::Reason::new_task},
                                        std::pair{oracle::Reason::pushed, director::Reason::pushed},
                                        std::pair{oracle::Reason::subtask_done, director::Reason::subtask_done},
                                        std::pair{oracle::Reason::wait, director::Reason::wait},
                                        std::pair{oracle::Reason::trigger, director::Reason::trigger}}) {
      if (pending.has(there)) group.pending.insert(reason);
    }
  }
  for (Index e = 0; e < tables_.edges.size(); ++e) {
    const Index level = s.request[e].level;
    out.requests.push_back(level == nil ? std::nullopt
                                        : std::optional<std::uint32_t>(level - tables_.edges[e].levels.begin));
  }
  for (Index v = 0; v < tables_.states.size(); ++v) {
    const std::int32_t value = engine_.value(v);
    out.values.push_back(value == unset ? std::nullopt : std::optional<std::int64_t>(value));
  }
  for (Index g = s.counters->queue_first; g != nil; g = s.run_queue[g].runs_before) out.queue.push_back(oracle::GroupId{g});
  return out;
}

} // namespace director::property
