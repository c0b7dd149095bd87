// Header: tests/system/arm/target/player.hpp. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// A second player beside compiler/play, on constants and without heap: the two agree on every line, or the test fails.
#include "tests/system/arm/target/player.hpp"

#include "runtime/core/engine/engine.hpp"
#include "runtime/core/saved/saved_state.hpp"
#include "tests/system/arm/target/text.hpp"

#include <new>

namespace target {

namespace {

using director::Event;
using director::Outcome;
using director::Reason;
using director::Run;
using director::RunState;
using director::Time;

constexpr std::uint32_t budget = 10'000;

/// Allocates memory in order. Without memory it only counts.
class Arena {
public:
  explicit Arena(std::byte* memory) : memory_(memory) {}
  template <class T>
  T* take(std::size_t count) {
    used_ = (used_ + alignof(T) - 1) / alignof(T) * alignof(T);
    std::byte* place = memory_ == nullptr ? nullptr : memory_ + used_;
    used_ += count * sizeof(T);
    if (place == nullptr) return nullptr;
    for (std::size_t i = 0; i < count; ++i) ::new (static_cast<void*>(place + i * sizeof(T))) T{};
    return std::launder(reinterpret_cast<T*>(place));
  }
  std::size_t used() const { return used_; }

private:
  std::byte* memory_;
  std::size_t used_ = 0;
};

struct Memory {
  Memory(const Plan& plan, std::byte* at) {
    Arena arena(at);
    const director::Tables& t = plan.tables;
    state = arena.take<std::byte>(director::State::bytes(director::Shape::of(t)));
    state_bytes = arena.used();
    cells = arena.take<director::Inbox::Cell>(plan.inbox_cells);
    runs = arena.take<std::uint32_t>(t.providers.size());
    starts = arena.take<std::uint32_t>(t.groups.size());
    stops = arena.take<std::uint32_t>(t.groups.size());
    edge_data = arena.take<Index>(t.edges.size());
    staged_data = arena.take<Index>(t.edges.size());
    group_data = arena.take<Index>(t.groups.size());
    bytes = arena.used();
  }
  std::byte* state;
  director::Inbox::Cell* cells;
  std::uint32_t *runs, *starts, *stops; // how many there were
  Index *edge_data, *staged_data, *group_data;
  std::size_t state_bytes, bytes;
};

class Player {
public:
  /// `room`: for the saved state of the engine between two steps.
  Player(const Plan& plan, const Memory& memory, std::span<std::byte> room)
      : plan_(plan),
        t_(plan.tables),
        m_(memory),
        room_(room),
        inbox_({memory.cells, plan.inbox_cells}),
        engine_(t_, memory.state, bodies(), inbox_, {tell, this}) {
    engine_.set_budget(budget);
  }

  void play() {
    line_.add("== ").add(plan_.title).end();
    for (const Setting& each : plan_.given) engine_.preset(each.state, each.value);
    run_engine();
    for (const Step& step : plan_.steps) {
      for (Index i = step.shown.begin; i != step.shown.end; ++i) line_.add("> ").add(plan_.shown[i]).end();
      if (!(step.advance > 0 ? advance(step.advance) : take(step.inputs))) break;
      if (room_.size() >= director::saved_bytes(director::Shape::of(t_))) begin_again();
    }
    if (refused_) line_.add("refused").end();
  }

private:
  director::Bodies bodies() {
    for (std::size_t i = 0; i < t_.edges.size(); ++i) m_.edge_data[i] = m_.staged_data[i] = nil;
    for (std::size_t i = 0; i < t_.groups.size(); ++i) m_.group_data[i] = nil;
    director::Bodies out;
    out.self = this;
    out.run = [](void* self, Run& run) { return static_cast<Player*>(self)->run(run); };
    out.start = [](void* self, director::Handling& handling) {
      auto& me = *static_cast<Player*>(self);
      me.handle(handling, me.plan_.starts, me.m_.starts);
    };
    out.stop = [](void* self, director::Handling& handling) {
      auto& me = *static_cast<Player*>(self);
      me.handle(handling, me.plan_.stops, me.m_.stops);
    };
    out.data = [](void* self, director::Bodies::Data what, Index edge, Index handle) {
      static_cast<Player*>(self)->move_data(what, edge, handle);
    };
    return out;
  }

  /// Resets the engine, and continues from its saved state: the trace must not change.
  void begin_again() {
    constexpr std::uint64_t fingerprint = 1;
    const Time until = engine_.memory().counters->until;
    const director::SaveResult saved = director::save(engine_, room_, fingerprint);
    engine_.reset();
    const director::LoadResult loaded = director::load(engine_, room_, until, fingerprint);
    if (saved != director::SaveResult::saved) line_.add(director::to_text(saved)).end();
    if (loaded != director::LoadResult::loaded) line_.add(director::to_text(loaded)).end();
  }

  bool run_engine() {
    const director::StepResult result = engine_.step(now_);
    if (result == director::StepResult::budget_exhausted) line_.add("budget_exhausted").end();
    return result == director::StepResult::quiescent;
  }

  bool advance(Time by) {
    const Time until = by > director::never - now_ ? director::never - 1 : now_ + by;
    while (engine_.next_due() <= until) {
      now_ = engine_.next_due();
      if (!run_engine()) return false;
    }
    now_ = until;
    return true;
  }

  bool take(Range inputs) {
    for (Index first = inputs.begin; first != inputs.end;) {
      Index end = first;
      while (plan_.inputs[end++].more) {}
      inbox_.post(plan_.inputs.subspan(first, static_cast<std::size_t>(end - first)));
      first = end;
    }
    return run_engine();
  }

  void move_data(director::Bodies::Data what, Index edge, Index handle) {
    switch (what) {
    case director::Bodies::Data::accept: m_.staged_data[edge] = handle; break;
    case director::Bodies::Data::settle: m_.edge_data[edge] = m_.staged_data[edge]; break;
    case director::Bodies::Data::retain: m_.group_data[t_.edges[edge].target] = m_.edge_data[edge]; break;
    }
  }

  Index data_at(director::DataPlace place) const {
    switch (place.slot) {
    case director::DataPlace::Slot::edge: return m_.edge_data[place.index];
    case director::DataPlace::Slot::staging: return m_.staged_data[place.index];
    case director::DataPlace::Slot::group: break;
    }
    return m_.group_data[place.index];
  }

  static bool holds(const Guard& guard, const Run& run) {
    if (guard.edge == nil) return guard.use == Use::none;
    switch (guard.use) {
    case Use::running: return run.state(guard.edge) == RunState::running;
    case Use::queued: return run.state(guard.edge) == RunState::queued;
    case Use::none: return run.state(guard.edge) == RunState::none;
    case Use::done: return run.done(guard.edge) && !run.failed(guard.edge);
    case Use::failed: break;
    }
    return run.failed(guard.edge);
  }

  bool holds(const Case& each, const Run& run, std::uint32_t count) const {
    if (each.reason != 0 && (run.reasons().bits() & each.reason) == 0) return false;
    if (each.trigger != nil && !run.triggered(each.trigger)) return false;
    if (each.run != 0 && each.run != count) return false;
    if (!each.any_data && each.data != data_at(run.data())) return false;
    for (Index i = each.uses.begin; i != each.uses.end; ++i) {
      if (!holds(plan_.guards[i], run)) return false;
    }
    return true;
  }

  Outcome run(Run& run) {
    const std::uint32_t count = ++m_.runs[run.provider()];
    const Range cases = plan_.bodies[run.provider()];
    for (Index i = cases.begin; i != cases.end; ++i) {
      if (holds(plan_.cases[i], run, count)) return act(plan_.cases[i], run);
    }
    return run.keep();
  }

  Outcome act(const Case& found, Run& run) {
    if (found.answer == Case::Answer::refused) {
      refused_ = true;
      return run.fault();
    }
    for (Index i = found.set.begin; i != found.set.end; ++i) run.set(plan_.settings[i].state, plan_.settings[i].value);
    if (found.wait > 0) run.wait(found.wait);
    switch (found.answer) {
    case Case::Answer::done: return run.done();
    case Case::Answer::failed: return run.fail();
    case Case::Answer::keep: return run.keep();
    case Case::Answer::pack:
    case Case::Answer::refused: break;
    }
    for (Index i = found.pack.begin; i != found.pack.end; ++i) {
      const Asked& asked = plan_.asked[i];
      if (run.request(asked.edge, asked.level, asked.keep)) m_.staged_data[asked.edge] = asked.data;
    }
    return run.pack();
  }

  void handle(director::Handling& handling, std::span<const Range> bodies, std::uint32_t* counts) {
    const std::uint32_t count = ++counts[handling.group()];
    const Range cases = bodies[handling.group()];
    for (Index i = cases.begin; i != cases.end; ++i) {
      const Case& each = plan_.cases[i];
      if ((each.run != 0 && each.run != count) || (!each.any_data && each.data != data_at(handling.data()))) continue;
      for (Index s = each.set.begin; s != each.set.end; ++s)
        handling.set(plan_.settings[s].state, plan_.settings[s].value);
      return;
    }
  }

  static void tell(void* self, const Event& event) { static_cast<Player*>(self)->tell(event); }

  void tell(const Event& event) {
    const Names& n = plan_.names;
    using Kind = Event::Kind;
    switch (event.kind) {
    case Kind::run:
      line_.add("run ");
      add_provider(event, false);
      add_reasons(event.reasons);
      break;
    case Kind::broken:
      line_.add("broken ");
      add_provider(event, false);
      break;
    case Kind::start: line_.add("start ").add(n.group(event.group)); break;
    case Kind::stop: line_.add("stop ").add(n.group(event.group)); break;
    case Kind::done: line_.add("done ").add(n.group(event.group)); break;
    case Kind::failed: line_.add("failed ").add(n.group(event.group)); break;
    case Kind::release: line_.add("release ").add(n.group(event.group)); break;
    case Kind::push:
      line_.add("push ");
      add_provider(event, true);
      line_.add(" for ").add(n.edge(event.edge));
      break;
    case Kind::queue:
      line_.add("queue ").add(n.edge(event.edge)).add(": ");
      add_why(event);
      break;
    case Kind::set: add_setting(event); break;
    case Kind::input:
    case Kind::grant:
    case Kind::lose:
    case Kind::refused:
    case Kind::fault:
    case Kind::exhausted:
    case Kind::ask:
    case Kind::keep:
    case Kind::withdraw:
    case Kind::wait:
    case Kind::lost:
    case Kind::answer:
    case Kind::assign:
    case Kind::begin:
    case Kind::given: return;
    }
    line_.end();
  }

  void add_provider(const Event& event, bool always) {
    const char* name = plan_.names.provider(event.provider);
    line_.add(plan_.names.group(event.group));
    const char* usual = "default";
    std::size_t i = 0;
    while (name[i] == usual[i] && name[i] != '\0') ++i;
    if (always || name[i] != usual[i]) line_.add(".").add(name);
  }

  void add_reasons(director::Reasons reasons) {
    struct Named {
      Reason reason;
      const char* name;
    };
    static constexpr Named all[]{{Reason::new_task, "new_task"},
                                 {Reason::pushed, "pushed"},
                                 {Reason::subtask_done, "subtask_done"},
                                 {Reason::wait, "wait"},
                                 {Reason::trigger, "trigger"}};
    const char* before = " ";
    for (const Named& each : all) {
      if (!reasons.has(each.reason)) continue;
      line_.add(before).add(each.name);
      before = "+";
    }
  }

  void add_why(const Event& event) {
    switch (event.why) {
    case director::Why::waiting:
      line_.add("waiting");
      if (event.condition != nil) line_.add(" for ").add(plan_.names.condition(event.condition));
      return;
    case director::Why::blocked: line_.add("blocked"); return;
    case director::Why::outdated: line_.add("outdated"); return;
    case director::Why::deferred: line_.add("deferred"); return;
    case director::Why::none: break;
    }
    line_.add("none");
  }

  void add_setting(const Event& event) {
    const char* state = plan_.names.state(event.state);
    if (event.value == director::unset) {
      line_.add("unset ").add(state);
      return;
    }
    line_.add("set ").add(state).add(" ");
    const char* value = plan_.names.value(event.state, event.value);
    if (*value == '\0') {
      line_.add(event.value);
    } else {
      line_.add(value);
    }
  }

  const Plan& plan_;
  const director::Tables& t_;
  const Memory& m_;
  const std::span<std::byte> room_;
  director::Inbox inbox_;
  director::Engine engine_;
  Line line_;
  Time now_ = 0;
  bool refused_ = false;
};

} // namespace

Used play(const Plan& plan, std::span<std::byte> memory) {
  const Memory needed(plan, nullptr);
  const std::size_t state = director::saved_bytes(director::Shape::of(plan.tables));
  Used used{needed.state_bytes, needed.bytes, false};
  if (used.memory > memory.size()) return used;
  const std::span<std::byte> rest = memory.subspan(used.memory);
  used.saved = state <= rest.size();
  const Memory taken(plan, memory.data());
  Player(plan, taken, rest).play();
  return used;
}

} // namespace target
