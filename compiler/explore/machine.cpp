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

Outcome Machine::run(Run& run) {
  const FreeBody& body = ground_.bodies[run.provider()];
  const director::State& s = engine_.memory();
  const auto keeps = [&](const Asks& asks) { // else it is the same as new
    return std::any_of(asks.begin(), asks.end(), [&](const Ask& ask) { return s.request[ask.edge] == ask.level; });
  };
  const auto kept = breadth_ == Breadth::lean
                        ? std::size_t{0}
                        : static_cast<std::size_t>(std::count_if(body.packs.begin(), body.packs.end(), keeps));
  const std::size_t packs = body.packs.size(), others = s.done[run.group()] == 0 ? 2 : 1;
  Deed deed;
  deed.group = run.group();
  deed.provider = run.provider();
  std::size_t answer = tape_->pick(packs + kept + others);
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
  if (queued != 0) std::memcpy(static_cast<void*>(engine_.memory().queued), from.data() + words(block_), queued);
}

void Machine::start() {
  write(first_);
  phase_ = Phase::rest;
}

/// What differs from the first state: a bit for each word, and those words. Each word is written whether it differs or
/// not, since a branch that nobody can foresee costs more.
void Machine::pack(Packed& out) const {
  read(now_);
  const std::size_t count = first_.size(), maps = (count + 63) / 64;
  differs_.resize(maps + count);
  std::size_t end = maps;
  for (std::size_t map = 0; map < maps; ++map) {
    const std::size_t begin = map * 64, size = std::min<std::size_t>(64, count - begin);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t word = now_[begin + i], differs = word != first_[begin + i] ? 1 : 0;
      differs_[end] = word;
      end += differs;
      bits |= differs << i;
    }
    differs_[map] = bits;
  }
  out.words.assign(differs_.begin(), differs_.begin() + static_cast<std::ptrdiff_t>(end));
  out.phase = phase_;
}

void Machine::unpack(const Packed& packed) {
  const std::size_t count = first_.size();
  std::size_t at = (count + 63) / 64;
  loaded_ = first_;
  for (std::size_t i = 0; i < count; ++i) {
    if ((packed.words[i / 64] >> (i % 64) & 1) != 0) loaded_[i] = packed.words[at++];
  }
  loaded_phase_ = packed.phase;
  again();
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

void Machine::post(const Happens& happens) {
  using Kind = Happens::Kind;
  std::vector<Input> records;
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
