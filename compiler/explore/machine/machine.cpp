// Header: compiler/explore/machine/machine.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
//
// Choices that are left out because others have the same effect, so that nothing is lost:
// - a body that answers `failed` instead of `done`: only other bodies can see the difference, and these do anything;
// - a second `done` before a new task: it has no effect, like `continue`;
// - a body that requests no `wait`: one that requests a very long one does the same. So every group that runs
//   may be run at rest, at any time.
#include "compiler/explore/machine/machine.hpp"

#include <algorithm>
#include <bit>

namespace director::compiler {

namespace {

std::size_t inbox_size(const Ground& ground) {
  std::size_t most = 2;
  for (const RequestedPack& pack : ground.requests) most = std::max(most, pack.size());
  for (const Puts& puts : ground.sets) most = std::max(most, puts.size());
  return std::bit_ceil(most);
}

Input record(Input::Kind kind, Index thing) {
  Input out;
  out.kind = kind;
  out.thing = thing;
  return out;
}

} // namespace

Machine::Machine(const Ground& ground, Breadth breadth)
    : ground_(ground),
      breadth_(breadth),
      cells_(inbox_size(ground)),
      inbox_(cells_),
      memory_(ground.tables),
      engine_(ground.tables, memory_.state().data(), table(), inbox_),
      block_(director::State::decision_bytes(Shape::of(ground.tables))),
      hasher_(ground, engine_),
      foresight_(ground, engine_, hasher_),
      unrequested_(ground.tables.edges.size()) {
  engine_.set_budget(1);
  engine_.step(0);
  read(now_);
  packing_ = Packing(now_);
}

Bodies Machine::table() {
  Bodies out;
  out.self = this;
  out.run = [](void* self, Run& run) { return static_cast<Machine*>(self)->run(run); };
  out.start = [](void* self, Handling& handling) {
    static_cast<Machine*>(self)->handle(handling, Action::Kind::start);
  };
  out.stop = [](void* self, Handling& handling) { static_cast<Machine*>(self)->handle(handling, Action::Kind::stop); };
  return out;
}

/// Otherwise keep is the same as a new request.
bool Machine::keeps(const RequestedPack& pack) const {
  const director::State& s = engine_.memory();
  return std::any_of(pack.begin(), pack.end(),
                     [&](const RequestedLevel& request) { return s.request[request.edge].level == request.level; });
}

void Machine::find_answers() {
  answers_.clear();
  if (!runs_next()) return;
  Action action;
  action.group = engine_.memory().counters->queue_first;
  action.provider = engine_.active(action.group);
  const FreeBody& body = ground_.bodies[action.provider];
  const std::vector<RequestedPack>& packs = body.packs;
  const std::size_t tried = breadth_ == Breadth::usual ? 1 : is_lean() ? body.usual : packs.size();
  for (; action.pack < tried; ++action.pack) answers_.push_back(action);
  if (breadth_ == Breadth::usual) return;
  action.answer = Action::Answer::kept;
  for (action.pack = 0; !is_lean() && action.pack < packs.size(); ++action.pack) {
    if (keeps(packs[action.pack])) answers_.push_back(action);
  }
  action.pack = 0;
  action.answer = Action::Answer::keep;
  answers_.push_back(action);
  action.answer = Action::Answer::done;
  if (engine_.memory().run_queue[action.group].done == 0) answers_.push_back(action);
}

Outcome Machine::run(Run& run) {
  const FreeBody& body = ground_.bodies[run.provider()];
  answer_ = choices_->pick(answers_.size());
  Action& action = actions_.emplace_back(answers_[answer_]);
  action.puts = choices_->pick(body.puts.size());
  for (const Put& put : body.puts[action.puts]) run.set(put.state, put.value);
  if (action.answer == Action::Answer::keep) return run.keep();
  if (action.answer == Action::Answer::done) return run.done();
  for (const RequestedLevel& request : body.packs[action.pack]) {
    if (!unrequested_[request.edge]) run.request(request.edge, request.level, action.answer == Action::Answer::kept);
  }
  return run.pack();
}

void Machine::handle(Handling& handling, Action::Kind kind) {
  const std::vector<Puts>& puts = (kind == Action::Kind::start ? ground_.starting : ground_.stopping)[handling.group()];
  Action action;
  action.kind = kind;
  action.group = handling.group();
  action.puts = choices_->pick(puts.size());
  for (const Put& put : puts[action.puts]) handling.set(put.state, put.value);
  actions_.push_back(action);
}

void Machine::list(std::vector<Happens>& out) const {
  using Kind = Happens::Kind;
  out.clear();
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  if (phase_ != Phase::rest) out.push_back({Kind::go, 0});
  const bool lean = is_lean();
  if (!takes_inputs()) return;
  for (Index i = 0; i < ground_.requests.size(); ++i) {
    if (!lean || ground_.requests[i].size() == 1) out.push_back({Kind::request, i});
  }
  for (Index e = 0; e < t.root_edges; ++e) {
    if (s.request[e].level != nil) out.push_back({Kind::cancel, e});
  }
  for (Index i = 0; i < ground_.sets.size(); ++i) {
    const Puts& puts = ground_.sets[i];
    if (lean && puts.size() > 1) continue;
    if (std::all_of(puts.begin(), puts.end(), [&](const Put& put) { // otherwise a smaller input does the same
          const ValueClasses& classes = ground_.classes[put.state];
          return classes.of(engine_.value(put.state)) != classes.of(put.value);
        }))
      out.push_back({Kind::set, i});
  }
  const auto heard = [&](Index trigger) {
    const auto listeners = t.list(t.triggers[trigger].listeners);
    return std::any_of(listeners.begin(), listeners.end(),
                       [&](Index p) { return engine_.active(t.providers[p].group) == p; });
  };
  for (const Index trigger : ground_.triggers) {
    if (heard(trigger)) out.push_back({Kind::fire, trigger});
  }
  if (phase_ != Phase::rest) return;
  for (Index g = 0; g < t.groups.size(); ++g) {
    if (ground_.wake[g] != nil && engine_.active(g) != nil && engine_.granted(g)) out.push_back({Kind::wake, g});
  }
  for (Index i = 0; i < ground_.expiries.size(); ++i) {
    const std::int32_t value = engine_.value(ground_.expiries[i].state);
    if (value != unset && value != ground_.expiries[i].value) out.push_back({Kind::expire, i});
  }
  for (Index i = 0; i < ground_.broken.size(); ++i) {
    const Broken& broken = ground_.broken[i];
    const Index group = t.providers[broken.provider].group;
    if (engine_.active(group) == broken.provider && engine_.in_force(group) && heard(broken.trigger))
      out.push_back({Kind::breaks, i});
  }
}

/// Whether the engine's next micro-step without an input calls a body.
bool Machine::runs_next() const {
  const director::State& s = engine_.memory();
  const Index group = s.counters->queue_first;
  if (phase_ == Phase::rest || s.counters->staged_count != 0 || group == nil) return false;
  const auto pushed = static_cast<std::uint8_t>(Reason::pushed);
  return engine_.in_force(group) ? s.run_queue[group].pending != 0 : (s.run_queue[group].pending & ~pushed) != 0;
}

bool Machine::takes_inputs() const {
  if (phase_ == Phase::closed || engine_.memory().counters->staged_count != 0) return false;
  return phase_ == Phase::rest || !is_lean();
}

const Foresight& Machine::look_ahead() {
  foresight_.look(answers_, takes_inputs());
  return foresight_;
}

/// False: nothing happens, since all requests of the input are left out.
bool Machine::post(const Happens& happens) {
  using Kind = Happens::Kind;
  std::vector<Input>& records = records_;
  records.clear();
  const auto set = [&](const Put& put) {
    records.push_back(record(Input::Kind::set, put.state));
    records.back().value = put.value;
  };
  switch (happens.kind) {
  case Kind::go: return true;
  case Kind::request:
    for (const RequestedLevel& request : ground_.requests[happens.row]) {
      if (unrequested_[request.edge]) continue;
      records.push_back(record(Input::Kind::request, request.edge));
      records.back().set_level(request.level);
    }
    break;
  case Kind::cancel: records.push_back(record(Input::Kind::cancel, happens.row)); break;
  case Kind::set:
    for (const Put& put : ground_.sets[happens.row]) set(put);
    break;
  case Kind::fire: records.push_back(record(Input::Kind::fire, happens.row)); break;
  case Kind::wake: records.push_back(record(Input::Kind::fire, ground_.wake[happens.row])); break;
  case Kind::expire: set(ground_.expiries[happens.row]); break;
  case Kind::breaks: records.push_back(record(Input::Kind::fire, ground_.broken[happens.row].trigger)); break;
  }
  for (std::size_t i = 0; i + 1 < records.size(); ++i) records[i].more = true;
  if (!records.empty()) inbox_.post(records);
  return !records.empty();
}

void Machine::take(const Happens& happens, ChoiceSequence& choices) {
  using Kind = Happens::Kind;
  choices_ = &choices;
  taken_ = happens;
  actions_.clear();
  const bool handlers = engine_.memory().counters->staged_count != 0;
  if (!post(happens)) return;
  const bool rests = engine_.step(0) == StepResult::quiescent;
  const bool outside = happens.kind == Kind::request || happens.kind == Kind::cancel || happens.kind == Kind::set ||
                       happens.kind == Kind::fire;
  const bool opens = happens.kind == Kind::go ? phase_ == Phase::open && handlers : outside;
  phase_ = rests ? Phase::rest : opens ? Phase::open : Phase::closed;
}

void Machine::repeat(const Machine& other, std::span<const Index> edges) {
  loaded_ = other.loaded_;
  loaded_phase_ = other.loaded_phase_;
  answers_ = other.answers_;
  again();
  unrequested_.assign(ground_.tables.edges.size(), false);
  for (const Index edge : edges) {
    unrequested_[edge] = true;
    engine_.memory().request[edge].level = nil;
  }
  ChoiceSequence same;
  if (!other.actions_.empty() && other.actions_.front().kind == Action::Kind::run) // before all handlers
    same.begin({other.answer_, other.actions_.front().puts});
  take(other.taken_, same);
  std::fill(unrequested_.begin(), unrequested_.end(), false);
}

} // namespace director::compiler
