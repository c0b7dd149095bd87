// Door: tests/bench/table_robot.hpp. Test: tests/bench/CMakeLists.txt.
#include "tests/bench/table_robot.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/model/resolve.hpp"
#include "dsl/read_behaviour.hpp"
#include "dsl/render.hpp"

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

TableRobot::TableRobot(Compiled compiled, std::size_t cells)
    : compiled_(std::move(compiled)),
      tables_(compiled_.lowered.view()),
      bodies_(tables_.providers.size()),
      run_table_(tables_.providers.size(),
                 [](void* self, Run& run) { return static_cast<TableRobot*>(self)->run(run); }),
      handler_table_(tables_.groups.size(), [](void*, Handling&) {}),
      cells_(cells),
      inbox_(cells_),
      memory_(tables_),
      engine_(tables_, memory_.state().data(), functions(), inbox_, {}, memory_.recall()) {
  engine_.set_budget(1'000'000'000);
  for (const compiler::ProviderId id : model().providers.ids()) {
    const std::vector<compiler::Pack>& packs = model().providers[id].packs;
    Act act;
    if (!packs.empty()) {
      for (const compiler::Task& task : packs.front().tasks) act.edges.push_back(static_cast<Index>(task.edge.value));
    }
    bodies_[id.value].acts = {act};
  }
}

std::vector<Act>& TableRobot::acts(const std::string& provider) {
  for (const compiler::ProviderId id : model().providers.ids()) {
    if (model().full_name(id) == provider) return acts(static_cast<Index>(id.value));
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

Input TableRobot::request(Index edge) const {
  return {.kind = Input::Kind::request, .thing = edge, .level = tables_.edges[edge].levels.begin};
}

void TableRobot::post(std::span<const Input> records) {
  if (!engine_.post(records)) throw std::logic_error("the inbox is full");
}

void TableRobot::step(Time now) {
  if (rows_.empty()) lay_out();
  if (engine_.step(now) != StepResult::quiescent) throw std::logic_error("it does not come to rest");
}

void TableRobot::lay_out() {
  first_row_.clear();
  edges_.clear();
  for (const Body& body : bodies_) {
    first_row_.push_back(static_cast<Index>(rows_.size()));
    for (const Act& act : body.acts) {
      const auto begin = static_cast<Index>(edges_.size());
      edges_.insert(edges_.end(), act.edges.begin(), act.edges.end());
      rows_.push_back({act.answer, static_cast<std::uint16_t>(body.acts.size()), act.state, act.value, begin,
                       static_cast<Index>(edges_.size())});
    }
  }
}

Bodies TableRobot::functions() {
  Bodies out;
  out.self = this;
  out.run = run_table_.data();
  out.start = out.stop = handler_table_.data();
  return out;
}

Outcome TableRobot::run(Run& run) {
  ++calls_;
  const Row* row = &rows_[first_row_[run.provider()]];
  if (row->count > 1) row += bodies_[run.provider()].runs++ / act_length % row->count;
  if (row->state != nil) run.set(row->state, row->value);
  switch (row->answer) {
  case Outcome::Kind::done: return run.done();
  case Outcome::Kind::failed: return run.fail();
  case Outcome::Kind::keep: return run.keep();
  case Outcome::Kind::fault: return run.fault();
  case Outcome::Kind::pack: break;
  }
  for (Index i = row->begin; i != row->end; ++i) run.request(edges_[i], tables_.edges[edges_[i]].levels.begin);
  return run.pack();
}

} // namespace bench
