// Header: tests/property/engine_run.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/engine_run.hpp"

#include "compiler/play/input_records.hpp"

#include <stdexcept>

namespace director::property {

namespace {

constexpr std::size_t inbox_cells = 64;  ///< more than the records of the inputs of any step
constexpr std::uint64_t fingerprint = 1; ///< of all behaviours: each test has only one

} // namespace

EngineRun::EngineRun(const Compiled& compiled, bool leap)
    : compiled_(compiled),
      tables_(compiled.lowered.view()),
      sink_([this](const compiler::Happening& each) { trace_.push_back(to_text(each)); }),
      bodies_(compiled.scenario, tables_),
      recorder_(compiled.model, compiled.lowered, false, sink_),
      leap_(leap) {
  recorder_.share({[](void* self, const Event& event) {
                     EngineRun& run = *static_cast<EngineRun*>(self);
                     run.events_.push_back(tests::numbers_of(event, run.shift_));
                   },
                   this});
  robot_ = robot();
  for (const compiler::Setting& given : compiled.scenario.given) {
    robot_->engine.preset(static_cast<Index>(given.state.value), static_cast<std::int32_t>(given.value));
  }
  robot_->engine.step(0);
  robot_->engine.set_budget(1);
}

EngineRun::Robot::Robot(const Tables& tables, const Bodies& bodies, const Observer& observer)
    : cells(inbox_cells),
      inbox(cells),
      memory(tables),
      engine(tables, memory.state().data(), bodies, inbox, observer) {}

std::unique_ptr<EngineRun::Robot> EngineRun::robot() {
  auto out = std::make_unique<Robot>(tables_, bodies_.table(), recorder_.observer());
  if (!leap_) out->engine.set_most_decided_whole(0); // few cases have components as large as these
  return out;
}

SaveResult EngineRun::cut(Time later, std::vector<std::byte>& bytes) {
  bytes.resize(saved_bytes(Shape::of(tables_)));
  const SaveResult saved = save(robot_->engine, bytes, fingerprint);
  if (saved != SaveResult::saved) return saved;
  std::unique_ptr<Robot> next = robot();
  const Time until = robot_->engine.memory().counters->until;
  const LoadResult loaded = director::load(next->engine, bytes, until + later, fingerprint);
  if (loaded != LoadResult::loaded) throw std::runtime_error(to_text(loaded));
  next->engine.set_budget(1);
  robot_ = std::move(next);
  shift_ += later;
  return saved;
}

LoadResult EngineRun::load(std::span<const std::byte> bytes) {
  std::unique_ptr<Robot> next = robot();
  const LoadResult loaded = director::load(next->engine, bytes, robot_->engine.memory().counters->until, fingerprint);
  if (loaded != LoadResult::loaded) return loaded;
  next->engine.set_budget(1);
  robot_ = std::move(next);
  return loaded;
}

void EngineRun::begin_step(const compiler::ScenarioStep& step) {
  until_ = now_ + step.advance.value_or(0);
  if (leap_) now_ = until_;
  for (const compiler::ScenarioInput& input : step.inputs) post(input);
}

bool EngineRun::micro_step() {
  switch (robot_->engine.step(now_ + shift_)) {
  case StepResult::budget_exhausted: return true;
  case StepResult::quiescent: break;
  default: throw std::runtime_error("a step of the engine was refused, or a body failed");
  }
  const Time due = robot_->engine.next_due();
  if (due == never || due - shift_ > until_) {
    now_ = until_;
    return false;
  }
  now_ = due - shift_;
  return true;
}

void EngineRun::post(const compiler::ScenarioInput& input) {
  const std::vector<Input> records = compiler::input_records(input, tables_, bodies_.data());
  if (!(leap_ ? robot_->inbox.post(records) : robot_->engine.post(records)))
    throw std::runtime_error("the inbox of the test is too small");
}

Snapshot EngineRun::snapshot() const {
  const director::State& s = engine().memory();
  Snapshot out;
  out.lines = trace_.size();
  for (Index g = 0; g < tables_.groups.size(); ++g) {
    Snapshot::Group& group = out.groups.emplace_back();
    if (engine().holder(g) != nil) group.holder = oracle::EdgeId{engine().holder(g)};
    if (engine().active(g) != nil) group.active = oracle::ProviderId{engine().active(g)};
    group.granted = engine().granted(g);
    group.needed = (s.last[g].flags & flag::needed) != 0;
    group.in_force = engine().in_force(g);
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
    const std::int32_t value = engine().value(v);
    out.values.push_back(value == unset ? std::nullopt : std::optional<std::int64_t>(value));
  }
  for (Index g = s.counters->queue_first; g != nil; g = s.run_queue[g].runs_before)
    out.queue.push_back(oracle::GroupId{g});
  for (Index c = 0; c < tables_.components.size(); ++c) {
    for (Index i = 0; i < s.order_count[c]; ++i)
      out.order.push_back(oracle::GroupId{s.order[tables_.components[c].order + i]});
  }
  return out;
}

} // namespace director::property
