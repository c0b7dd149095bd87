// Header: tests/bench/table_robot.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/table_robot.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/source/render.hpp"

#include <algorithm>
#include <stdexcept>

namespace bench {

using namespace director;

namespace {

Compiled compile(const std::string& path, dsl::FileAccess& files) {
  dsl::Sources sources;
  const dsl::ReadResult read = dsl::read_behaviour(path, files, sources);
  if (dsl::has_errors(read.diagnostics)) throw std::logic_error(dsl::render(read.diagnostics, sources));
  compiler::Resolved resolved = compiler::resolve(read.spec, sources);
  if (dsl::has_errors(resolved.findings)) throw std::logic_error(dsl::render(resolved.findings, sources));
  compiler::Lowered lowered = compiler::lower(resolved.model);
  return {std::move(resolved.model), std::move(lowered)};
}

template <class Table, class Name>
Index row_of(const Table& table, const std::string& wanted, Name name) {
  const auto at = std::find_if(table.begin(), table.end(), [&](const auto& each) { return name(each) == wanted; });
  if (at == table.end()) throw std::logic_error("there is no " + wanted);
  return static_cast<Index>(at - table.begin());
}

} // namespace

Compiled compile_text(const std::string& text) {
  dsl::MemoryFiles files;
  files.add("grown.yaml", text);
  return compile("grown.yaml", files);
}

Compiled compile_file(const std::string& path) {
  dsl::DiskFiles files;
  return compile(path, files);
}

TableRobot::TableRobot(Compiled compiled, std::size_t cells, Play play, Observer observer)
    : compiled_(std::move(compiled)),
      tables_(compiled_.lowered.view()),
      play_(play),
      runs_(tables_.providers.size()),
      cells_(cells),
      inbox_(cells_),
      memory_(tables_),
      engine_(tables_, memory_.state().data(), functions(), inbox_, observer) {
  engine_.set_budget(1'000'000'000);
  for (const compiler::ProviderId id : model().providers.ids()) {
    first_act_.push_back(static_cast<Index>(acts_.size()));
    add_acts(model().providers[id]);
  }
  first_act_.push_back(static_cast<Index>(acts_.size()));
}

void TableRobot::add_acts(const compiler::Provider& provider) {
  const std::size_t first = acts_.size();
  for (const compiler::Pack& pack : provider.packs) {
    Act& act = acts_.emplace_back();
    act.begin = static_cast<Index>(edges_.size());
    for (const compiler::Task& task : pack.tasks) {
      const auto edge = static_cast<Index>(task.edge.value);
      edges_.push_back({edge, tables_.edges[edge].levels.begin});
    }
    act.count = static_cast<std::uint16_t>(pack.tasks.size());
    if (play_ == Play::same) return;
  }
  if (provider.packs.empty()) acts_.emplace_back();
  if (play_ == Play::same) return;
  std::size_t next = first;
  for (const auto* uses : {&provider.causing, &provider.sets}) {
    for (const compiler::ConditionUse& use : *uses) {
      const compiler::Condition& condition = model().conditions[use.id];
      if (condition.operands.empty()) continue;
      if (next == acts_.size()) acts_.push_back(acts_[first]);
      acts_[next].state = static_cast<Index>(condition.state.value);
      acts_[next++].value = static_cast<std::int32_t>(condition.operands.front());
    }
  }
}

Act& TableRobot::act(const std::string& provider) {
  for (const compiler::ProviderId id : model().providers.ids()) {
    if (model().full_name(id) == provider) return acts_[first_act_[id.value]];
  }
  throw std::logic_error("there is no " + provider);
}

Index TableRobot::root(const std::string& group) const {
  return row_of(model().roots, group,
                [&](const compiler::Task& task) { return model().groups[task.target].name.value; });
}

Index TableRobot::state(const std::string& name) const {
  return row_of(model().states, name, [](const compiler::State& state) { return state.name.value; });
}

std::int32_t TableRobot::value(Index state, const std::string& word) const {
  const auto& values = model().states[compiler::StateId{state}].values;
  return static_cast<std::int32_t>(row_of(values, word, [](const std::string& value) { return value; }));
}

Index TableRobot::trigger(const std::string& name) const {
  return row_of(model().triggers, name, [](const compiler::Trigger& trigger) { return trigger.name; });
}

Input TableRobot::request(Index edge, Index level) const {
  return {.kind = Input::Kind::request,
          .thing = edge,
          .value = static_cast<std::int32_t>(tables_.edges[edge].levels.begin + level)};
}

void TableRobot::post(std::span<const Input> records) {
  if (!engine_.post(records)) throw std::logic_error("the inbox is full");
}

void TableRobot::step(Time now) {
  if (engine_.step(now) != StepResult::quiescent) throw std::logic_error("it does not come to rest");
}

bool TableRobot::micro_step(Time now) {
  engine_.set_budget(1);
  return engine_.step(now) != StepResult::quiescent;
}

Bodies TableRobot::functions() {
  Bodies out;
  out.self = this;
  out.run = [](void* self, Run& run) { return static_cast<TableRobot*>(self)->run(run); };
  out.start = out.stop = [](void*, Handling&) {};
  return out;
}

/// The act of this run.
const Act& TableRobot::act_of(Index provider, bool other) {
  if (play_ == Play::same) return acts_[provider];
  const Index first = first_act_[provider];
  const std::size_t count = first_act_[provider + 1] - first;
  if (play_ == Play::changing) return acts_[first + (count > 1 ? runs_[provider]++ / act_length % count : 0)];
  return acts_[first + (other ? random_.below(count) : 0)];
}

Outcome TableRobot::run(Run& run) {
  ++calls_;
  const bool random = play_ == Play::at_random, other = random && random_.percent(10);
  const Act& act = act_of(run.provider(), other);
  if (act.state != nil && (!random || other || random_.percent(25))) run.set(act.state, act.value);
  if (other && random_.percent(25)) return run.done();
  if (other && random_.percent(12)) return run.keep();
  switch (act.answer) {
  case Outcome::Kind::done: return run.done();
  case Outcome::Kind::failed: return run.fail();
  case Outcome::Kind::keep: return run.keep();
  case Outcome::Kind::fault: return run.fault();
  case Outcome::Kind::pack: break;
  }
  for (const Asked& asked : std::span(edges_).subspan(act.begin, act.count)) run.request(asked.edge, asked.level);
  return run.pack();
}

} // namespace bench
