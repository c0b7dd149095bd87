// Door: compiler/explore/machine.hpp. Test: tests/compiler/explore/search_test.cpp.
//
// Which choices are left out because others do as well, so that nothing is lost:
// - a body that answers `failed` instead of `done`: only other bodies can see the difference, and these do anything;
// - a second `done` before a new task: it has no effect, as `continue` has none;
// - a body that does not ask for a `wait`: one that asks for a very long one does the same. So every group that runs
//   may be woken at rest, whenever one likes.
#include "compiler/explore/machine.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace director::compiler {

namespace {

std::size_t inbox_size(const Ground& ground) {
  std::size_t most = 2;
  for (const Asks& asks : ground.requests) most = std::max(most, asks.size());
  for (const Puts& puts : ground.sets) most = std::max(most, puts.size());
  return std::bit_ceil(most);
}

std::size_t words(std::size_t bytes) { return (bytes + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t); }

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
      memory_(words(director::State::bytes(Shape::of(ground.tables)))),
      engine_(ground.tables, reinterpret_cast<std::byte*>(memory_.data()), table(), inbox_),
      block_(director::State::decision_bytes(Shape::of(ground.tables))) {
  engine_.set_budget(1);
  engine_.step(0);
  read(first_);
  find_marks();
}

Bodies Machine::table() {
  runs_.assign(ground_.tables.providers.size(),
               [](void* self, Run& run) { return static_cast<Machine*>(self)->run(run); });
  starts_.assign(ground_.tables.groups.size(), [](void* self, Handling& handling) {
    static_cast<Machine*>(self)->handle(handling, Deed::Kind::start);
  });
  stops_.assign(ground_.tables.groups.size(), [](void* self, Handling& handling) {
    static_cast<Machine*>(self)->handle(handling, Deed::Kind::stop);
  });
  Bodies out;
  out.self = this;
  out.run = runs_.data();
  out.start = starts_.data();
  out.stop = stops_.data();
  return out;
}

/// Else to keep it is the same as to ask for it anew.
bool Machine::keeps(const Asks& asks) const {
  const director::State& s = engine_.memory();
  return std::any_of(asks.begin(), asks.end(), [&](const Ask& ask) { return s.request[ask.edge] == ask.level; });
}

Machine::Answers Machine::answers(Index group, Index provider) const {
  const std::vector<Asks>& packs = ground_.bodies[provider].packs;
  Answers out;
  out.packs = packs.size();
  if (breadth_ != Breadth::lean) {
    out.kept = static_cast<std::size_t>(
        std::count_if(packs.begin(), packs.end(), [&](const Asks& asks) { return keeps(asks); }));
  }
  out.others = engine_.memory().done[group] == 0 ? 2 : 1;
  return out;
}

Outcome Machine::run(Run& run) {
  const FreeBody& body = ground_.bodies[run.provider()];
  const Answers all = answers(run.group(), run.provider());
  const std::size_t packs = all.packs, kept = all.kept;
  Deed deed;
  deed.group = run.group();
  deed.provider = run.provider();
  std::size_t answer = tape_->pick(all.count());
  deed.puts = tape_->pick(body.puts.size());
  for (const Put& put : body.puts[deed.puts]) run.set(put.state, put.value);
  if (answer >= packs + kept) {
    deed.answer = answer == packs + kept ? Deed::Answer::keep : Deed::Answer::done;
    deeds_.push_back(deed);
    return deed.answer == Deed::Answer::keep ? run.keep() : run.done();
  }
  if (answer >= packs) {
    deed.answer = Deed::Answer::kept;
    for (answer -= packs;; ++deed.pack) {
      if (keeps(body.packs[deed.pack]) && answer-- == 0) break;
    }
  } else {
    deed.pack = answer;
  }
  for (const Ask& ask : body.packs[deed.pack]) run.request(ask.edge, ask.level, deed.answer == Deed::Answer::kept);
  deeds_.push_back(deed);
  return run.pack();
}

void Machine::handle(Handling& handling, Deed::Kind kind) {
  const std::vector<Puts>& puts = (kind == Deed::Kind::start ? ground_.starting : ground_.stopping)[handling.group()];
  Deed deed;
  deed.kind = kind;
  deed.group = handling.group();
  deed.puts = tape_->pick(puts.size());
  for (const Put& put : puts[deed.puts]) handling.set(put.state, put.value);
  deeds_.push_back(deed);
}

/// The decision state, and behind it why requests are queued: no decision depends on that, but assertions do, and the
/// engine writes it only where it decides anew.
void Machine::read(std::vector<std::uint64_t>& out) const {
  const std::size_t queued = ground_.tables.edges.size() * sizeof(Queued);
  out.resize(words(block_) + words(queued));
  out.back() = 0;
  std::memcpy(out.data(), memory_.data(), block_);
  if (queued != 0) std::memcpy(out.data() + words(block_), engine_.memory().queued, queued);
}

void Machine::write(const std::vector<std::uint64_t>& from) {
  const std::size_t queued = ground_.tables.edges.size() * sizeof(Queued);
  std::memcpy(memory_.data(), from.data(), block_);
  const director::State& s = engine_.memory();
  if (queued != 0) std::memcpy(static_cast<void*>(s.queued), from.data() + words(block_), queued);
  // Between micro-steps what the last pass decided stands in `now` as well, and an act that gives reasons in a
  // component that was not decided again reads it there.
  if (ground_.tables.components.size() > 1) std::copy_n(s.last.group, ground_.tables.groups.size(), s.now.group);
}

void Machine::start() {
  write(first_);
  phase_ = Phase::rest;
}

/// What differs from the first state: a bit for each word, and those words. Eight words that are all the same, as most
/// are, are passed over; of others each is written whether it differs or not, since a branch that nobody can foresee
/// costs more.
void Machine::pack(Packed& out) const {
  read(now_);
  const std::size_t count = first_.size(), maps = (count + 63) / 64;
  differs_.resize(maps + count);
  std::fill_n(differs_.begin(), maps, 0);
  std::size_t end = maps;
  for (std::size_t begin = 0; begin < count; begin += 8) {
    const std::size_t size = std::min<std::size_t>(8, count - begin);
    if (size == 8 && std::memcmp(&now_[begin], &first_[begin], 8 * sizeof(std::uint64_t)) == 0) continue;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t word = now_[begin + i], differs = word != first_[begin + i] ? 1 : 0;
      differs_[end] = word;
      end += differs;
      bits |= differs << i;
    }
    differs_[begin / 64] |= bits << (begin % 64);
  }
  out.words.assign(differs_.begin(), differs_.begin() + static_cast<std::ptrdiff_t>(end));
  out.phase = phase_;
}

void Machine::unpack(const Packed& packed) {
  const std::size_t count = first_.size();
  std::size_t at = (count + 63) / 64;
  loaded_ = first_;
  for (std::size_t begin = 0; begin < count; begin += 64) {
    for (std::uint64_t bits = packed.words[begin / 64]; bits != 0; bits &= bits - 1)
      loaded_[begin + static_cast<std::size_t>(std::countr_zero(bits))] = packed.words[at++];
  }
  loaded_phase_ = packed.phase;
  again();
  const std::int32_t* values = engine_.memory().values;
  loaded_values_.assign(values, values + ground_.tables.states.size());
}

void Machine::again() {
  write(loaded_);
  phase_ = loaded_phase_;
}

void Machine::list(std::vector<Happens>& out) const {
  using Kind = Happens::Kind;
  out.clear();
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  if (phase_ != Phase::rest) out.push_back({Kind::go, 0});
  const bool lean = breadth_ == Breadth::lean;
  if (phase_ == Phase::closed || s.counters->handlers_set != 0 || (lean && phase_ == Phase::open)) return;
  for (Index i = 0; i < ground_.requests.size(); ++i) {
    if (!lean || ground_.requests[i].size() == 1) out.push_back({Kind::request, i});
  }
  for (Index e = 0; e < t.root_edges; ++e) {
    if (s.request[e] != nil) out.push_back({Kind::cancel, e});
  }
  for (Index i = 0; i < ground_.sets.size(); ++i) {
    const Puts& puts = ground_.sets[i];
    if (lean && puts.size() > 1) continue;
    if (std::all_of(puts.begin(), puts.end(), [&](const Put& put) { // else a smaller input does the same
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
    if (engine_.value(ground_.expiries[i].state) != ground_.expiries[i].value) out.push_back({Kind::expire, i});
  }
  for (Index i = 0; i < ground_.broken.size(); ++i) {
    const Broken& broken = ground_.broken[i];
    const Index group = t.providers[broken.provider].group;
    if (engine_.active(group) == broken.provider && engine_.in_force(group) && heard(broken.trigger))
      out.push_back({Kind::breaks, i});
  }
}

/// The engine's next micro-step without an input calls a body.
bool Machine::runs_next() const {
  const director::State& s = engine_.memory();
  const Index group = s.counters->queue_first;
  if (phase_ == Phase::rest || s.counters->handlers_set || group == nil) return false;
  const auto pushed = static_cast<std::uint8_t>(Reason::pushed);
  return engine_.in_force(group) ? s.pending[group] != 0 : (s.pending[group] & ~pushed) != 0;
}

Choices Machine::choices(const Happens& happens) const {
  if (happens.kind == Happens::Kind::set) return {false, 1, {&ground_.sets[happens.row], 1}};
  if (happens.kind != Happens::Kind::go || !runs_next()) return {};
  const Index group = engine_.memory().counters->queue_first, provider = engine_.active(group);
  return {true, answers(group, provider).count(), ground_.bodies[provider].puts};
}

void Machine::post(const Happens& happens) {
  using Kind = Happens::Kind;
  std::vector<Input>& records = records_;
  records.clear();
  const auto set = [&](const Put& put) {
    records.push_back(record(Input::Kind::set, put.state));
    records.back().value = put.value;
  };
  switch (happens.kind) {
  case Kind::go: return;
  case Kind::request:
    for (const Ask& ask : ground_.requests[happens.row]) {
      records.push_back(record(Input::Kind::request, ask.edge));
      records.back().level = ask.level;
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
  inbox_.post(records);
}

void Machine::take(const Happens& happens, Tape& tape) {
  using Kind = Happens::Kind;
  tape_ = &tape;
  deeds_.clear();
  const bool handlers = engine_.memory().counters->handlers_set != 0;
  post(happens);
  const bool rests = engine_.step(0) == StepResult::quiescent;
  const bool outside = happens.kind == Kind::request || happens.kind == Kind::cancel || happens.kind == Kind::set ||
                       happens.kind == Kind::fire;
  const bool opens = happens.kind == Kind::go ? phase_ == Phase::open && handlers : outside;
  phase_ = rests ? Phase::rest : opens ? Phase::open : Phase::closed;
}

} // namespace director::compiler
