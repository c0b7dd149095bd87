#pragma once
// SPDX-License-Identifier: MIT
// Tests of a module alone: a body or a handler is called as the engine would call it, with a task, reasons and states
// of other groups set by the test, and its requests and values are read afterwards. No engine runs, nothing else is
// called, and any test framework can be used:
//
//   director::testing::Trial<rover::Drive::Braking> braking{rover::Course{.mm_per_s = 200}};
//   const auto answer = braking.reasons(Reason::pushed).run(chassis);
//   CHECK(answer.data<rover::Wheels>().left == 100);
//   CHECK(answer.wait() == 100ms);
//
// What the specification does not declare does not compile here either, except values of a declared state: a test may
// compute them. Errors of a test (data that were not requested) are thrown as std::logic_error; without exceptions they
// are printed, and the program is aborted. Only generated code and the modules' own sources have to be linked.

#include "runtime/core/api/behaviour.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace director::testing {

/// The state of a task or need in `uses`.
enum class Fares : std::uint8_t {
  none,    ///< not requested by this group
  queued,  ///< requested by this group, not granted
  running, ///< granted
  done,    ///< granted, and its answer was done
  failed,  ///< granted, and its answer was fail
};

/// Makes contexts, which otherwise only the engine makes.
struct Access {
  static Run run(Engine& engine, Index group, Index provider, Reasons reasons) {
    return {engine, engine.memory(), engine.tables().groups[group].edges.begin, group, provider, reasons};
  }
  static Handling handling(Engine& engine, Index group, Reasons reasons) { return {engine, group, reasons}; }
  static Time wait(const Run& run) { return run.wait_; }
  static std::uint16_t pack(const Run& run) { return run.pack_; }
};

namespace detail {

/// Reports an error of the test.
[[noreturn]] inline void fail(const char* mistake) {
#ifdef __cpp_exceptions
  throw std::logic_error(mistake);
#else
  std::fprintf(stderr, "%s\n", mistake);
  std::abort();
#endif
}

template <class Facts>
Facts facts_of(const Body<Facts>&);
template <class Facts>
Facts facts_of(const Handler<Facts>&);

template <class Context>
concept IsHandler = requires(const Context& context) {
  []<class Facts>(const Handler<Facts>&) {}(context);
};

template <class Context>
consteval bool is_start() {
  using Facts = decltype(facts_of(std::declval<const Context&>()));
  if constexpr (requires { typename Facts::Task::Start; }) return std::is_same_v<Context, typename Facts::Task::Start>;
  return false;
}

/// The named packs of a provider, or its flat `tasks` as the only one.
template <class Facts>
struct PacksOf {
  using Type = typename Facts::Packs;
};
template <class Facts>
requires Facts::flat struct PacksOf<Facts> {
  using Type = Packs<typename Facts::Tasks>;
};

/// Calls see.template operator()<Member>() for the entry of the task in each of the packs that have one.
template <class Task, class... All, class See>
constexpr void each_entry(Packs<All...>, See see) {
  const auto look = [&]<class Pack>(const Pack*) {
    if constexpr (Pack::template has<Task>) see.template operator()<typename Pack::template For<Task>>();
  };
  (look(static_cast<const All*>(nullptr)), ...);
}

/// The engine of a behaviour, never stepped: bodies read and write its memory.
template <class Whole>
struct Rig {
  Rig() : inbox(cells, words), engine(Whole::tables(), memory.data(), Bodies{}, inbox, Observer{&Rig::observe, this}) {}
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  static void observe(void* self, const Event& event) {
    if (event.kind == Event::Kind::refused) static_cast<Rig*>(self)->refused.push_back({event.state, event.value});
  }
  const State& state() const { return engine.memory(); }

  typename Whole::Data data;
  std::array<Inbox::Cell, Whole::inbox_cells> cells;
  std::array<OverflowSlot, OverflowSlotOf<Whole>::count> words;
  alignas(8) std::array<std::byte, State::bytes(Whole::shape)> memory;
  Inbox inbox;
  Engine engine;
  std::vector<Setting> refused;
};

} // namespace detail

/// The results of a body or handler, valid until the next run of the same trial.
template <class Context>
class Answer {
  using Facts = decltype(detail::facts_of(std::declval<const Context&>()));
  using Whole = typename Facts::Behaviour;
  static constexpr bool handler = detail::IsHandler<Context>;

public:
  using Kind = Outcome::Kind; ///< the kind of the body's answer

  /// The kind of the body's answer: pack (a request), done, failed or keep; fault for a level that is not declared.
  Kind outcome() const requires(!handler) { return outcome_; }

  /// The name of the requested pack; empty if the provider has flat `tasks`, or did not request.
  std::string_view pack() const requires(!handler) {
    if (outcome_ != Kind::pack || pack_ >= Facts::pack_names.size()) return {};
    return *(Facts::pack_names.begin() + pack_);
  }

  /// The number of requested tasks, including those that are kept.
  std::size_t count() const requires(!handler) {
    const Range edges = rig_->engine.tables().groups[group].edges;
    std::size_t out = 0;
    for (Index e = edges.begin; e != edges.end; ++e) out += level_of(e) != nil ? 1U : 0U;
    return out;
  }

  /// Whether the task was requested.
  template <class Task>
  bool requests() const requires(!handler) {
    return level_of(edge<Task>()) != nil;
  }
  /// Whether it was requested at this level: `answer.requests(soccer::Kick::urgent)`.
  template <class Task>
  bool requests(LevelOf<Task> level) const requires(!handler) {
    const Index asked = level_of(edge<Task>());
    bool same = false;
    detail::each_entry<Task>(Entries{}, [&]<class Entry>() { same = same || Entry::row(level) == asked; });
    return same && asked != nil;
  }
  /// Whether it was requested with director::keep, and at that level before, so that it stays as it is.
  template <class Task>
  bool keeps() const requires(!handler) {
    return requests<Task>() && rig_->state().staged_request[place(edge<Task>())].keep;
  }
  /// The data of the request.
  template <class Task>
  const auto& data() const requires(!handler) {
    static_assert(has_data<Task>, "this task has no data");
    if (!requests<Task>()) detail::fail("this task was not requested");
    if (keeps<Task>()) detail::fail("this task was kept, with the data that it had");
    return rig_->data.template of<Task>().at(DataPlace::Slot::staging, 0);
  }

  /// Whether the state was set to this value.
  template <class Value>
  bool sets(Value value) const {
    const Setting setting = declared(value);
    return setting.value != unset && value_of(setting.state) == setting.value;
  }
  /// Whether the state was set, to any value.
  template <class Value>
  bool sets() const {
    static_assert(DeclaredState<Value, Facts>,
                  "`causing` and `sets` of this provider or handler do not name this state");
    return value_of(Whole::States::template row<Value>) != unset;
  }
  /// Whether try_set refused this value. With DIRECTOR_NO_OBSERVER this does not compile.
  template <class Value>
  bool refuses(Value value) const {
    static_assert(observable && sizeof(Value) != 0,
                  "a refused value is seen by an observer: compile this test and the runtime without "
                  "DIRECTOR_NO_OBSERVER");
    const Setting setting = declared(value);
    return std::any_of(rig_->refused.begin(), rig_->refused.end(), [&](const Setting& other) {
      return other.state == setting.state && other.value == setting.value;
    });
  }

  /// The time after which it requested another run, if it did.
  std::optional<std::chrono::microseconds> wait() const requires(!handler) {
    if (wait_ == 0) return std::nullopt;
    return std::chrono::microseconds(wait_);
  }

private:
  template <class>
  friend class Trial;
  using Entries = typename detail::PacksOf<Facts>::Type;
  static constexpr Index group = Whole::Groups::template row<typename Facts::Task>;

  explicit Answer(std::shared_ptr<detail::Rig<Whole>> rig) : rig_(std::move(rig)) {}

  template <class Task>
  static constexpr Index edge() {
    static_assert(Entries::template has<Task>, "neither `tasks` nor a pack of this provider names this task");
    Index out = nil;
    detail::each_entry<Task>(Entries{}, [&]<class Entry>() { out = Entry::edge; });
    return out;
  }
  template <class Value>
  static Setting declared(Value value) {
    static_assert(DeclaredState<Value, Facts>,
                  "`causing` and `sets` of this provider or handler do not name this state");
    return Whole::States::setting(value);
  }
  std::size_t place(Index edge) const { return edge - rig_->engine.tables().groups[group].edges.begin; }
  /// The level at which it was requested, or nil.
  Index level_of(Index edge) const {
    return outcome_ == Kind::pack ? rig_->state().staged_request[place(edge)].level : nil;
  }
  std::int32_t value_of(Index state) const { return rig_->state().values[state].staged; }

  std::shared_ptr<detail::Rig<Whole>> rig_;
  Kind outcome_ = Kind::keep;
  std::uint16_t pack_ = 0;
  Time wait_ = 0;
};

/// `Context`: the context of the body or handler, `soccer::Walk::Halting`, `soccer::Walk::Stop`.
template <class Context>
class Trial {
  using Facts = decltype(detail::facts_of(std::declval<const Context&>()));
  using Whole = typename Facts::Behaviour;
  using Task = typename Facts::Task;
  using Data = typename TaskBase<Task>::data_type;
  static constexpr bool handler = detail::IsHandler<Context>;

public:
  /// Of a task without data.
  Trial() { static_assert(!has_data<Task>, "this task has data, which the Trial needs: Trial<...> trial{data}"); }
  // A copy would share what it is given.
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  /// A trial can be moved; the one that is left may only be destroyed, or assigned to.
  Trial(Trial&&) noexcept = default;
  /// The same.
  Trial& operator=(Trial&&) noexcept = default;
  ~Trial() = default;
  /// With the data of the task.
  template <class Given = Data>
  explicit Trial(Given data) {
    task(std::move(data));
  }

  // The input of the body. Calls may be chained, and hold until they are replaced.

  /// Sets other data of the task.
  template <class Given = Data>
  Trial& task(Given data) {
    static_assert(has_data<Task>, "this task has no data");
    if constexpr (has_data<Task>) {
      auto& slots = rig_->data.template of<Task>();
      slots.stage(Data(std::move(data)));
      slots.settle(0);
      slots.retain(0);
    }
    return *this;
  }

  /// Sets the reasons of the next call only; new_task by default.
  template <std::same_as<Reason>... Given>
  requires(!handler) Trial& reasons(Given... reasons) {
    reasons_ = static_cast<std::uint8_t>((reasons_ | ... | static_cast<std::uint8_t>(reasons)));
    return *this;
  }

  /// Fires this trigger, which is a reason as well; for the next call only.
  template <class Trigger>
  requires(!handler) Trial& triggered() {
    static_assert(Facts::Triggers::template has<Trigger>, "the provider's `triggers` do not name this trigger");
    const Tables& tables = rig_->engine.tables();
    const Range listens = tables.groups[group].listens;
    for (Index slot = listens.begin; slot != listens.end; ++slot) {
      if (tables.listened[slot] == Facts::Triggers::template row<Trigger>) rig_->state().fired[slot] = 1;
    }
    return reasons(Reason::trigger);
  }

  /// Sets the state of a group in its `uses`.
  template <class Used>
  requires(!handler) Trial& uses(Fares fares) {
    static_assert(Facts::Uses::template has<Used>, "this group does not stand in the provider's `uses`");
    constexpr Index edge = Facts::Uses::template row<Used>;
    // A need alone is held, not granted.
    if (edge == nil || rig_->engine.tables().edges[edge].levels.empty()) {
      if (fares != Fares::none) detail::fail("nothing of this group requests it: it is always none");
      return *this;
    }
    const State& state = rig_->state();
    const Tables& tables = rig_->engine.tables();
    const Index target = tables.edges[edge].target;
    const bool granted = fares != Fares::none && fares != Fares::queued;
    const Range levels = tables.edges[edge].levels;
    Index& level = state.request[edge].level;
    if (fares == Fares::none) level = nil;
    if (fares != Fares::none && level == nil) level = levels.begin;
    state.last[target].holder = granted ? edge : nil;
    state.last[target].flags = granted ? flag::granted : 0;
    state.run_queue[target].done = fares == Fares::done     ? result::done
                                   : fares == Fares::failed ? static_cast<std::uint8_t>(result::done | result::failed)
                                                            : std::uint8_t{0};
    return *this;
  }

  /// Sets that it requested this task in an earlier run, at this level (by default the first), so that director::keep
  /// can keep it.
  template <class Asked>
  requires(!handler) Trial& requested(LevelOf<Asked> level = {}) {
    constexpr Index edge = Answer<Context>::template edge<Asked>();
    Index row = nil;
    detail::each_entry<Asked>(typename Answer<Context>::Entries{}, [&]<class Entry>() {
      if (row == nil) row = Entry::row(level);
    });
    if (row == nil) detail::fail("this provider does not request the task at that level");
    rig_->state().request[edge].level = row;
    return *this;
  }

  /// Calls the body or handler. Exceptions pass through. Its request is the earlier one for the next run.
  Answer<Context> run(typename Facts::Module& module) {
    forget();
    Answer<Context> answer(rig_);
    if constexpr (handler) {
      Handling handling = Access::handling(rig_->engine, group, Reasons{static_cast<std::uint8_t>(why)});
      Context context{handling, rig_->data};
      if constexpr (detail::is_start<Context>()) {
        module.start(context);
      } else {
        module.stop(context);
      }
    } else {
      const Heard heard{*rig_}; // also if the body throws
      const std::uint8_t reasons = reasons_ == 0 ? static_cast<std::uint8_t>(Reason::new_task) : reasons_;
      reasons_ = 0;
      Run run = Access::run(rig_->engine, group, Whole::Providers::template row<Context>, Reasons{reasons});
      Context context{run, rig_->data};
      answer.outcome_ = module.provide(context).kind();
      answer.wait_ = Access::wait(run);
      answer.pack_ = Access::pack(run);
      if (answer.outcome_ == Outcome::Kind::pack) commit();
    }
    return answer;
  }

private:
  static constexpr Index group = Whole::Groups::template row<Task>;
  static constexpr Reason why = detail::is_start<Context>() ? Reason::started : Reason::stopped;

  /// Forgets the triggers at its end: they fired for one run.
  struct Heard {
    explicit Heard(detail::Rig<Whole>& of) : rig(of) {}
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;
    ~Heard() {
      const Range listens = rig.engine.tables().groups[group].listens;
      for (Index slot = listens.begin; slot != listens.end; ++slot) rig.state().fired[slot] = 0;
    }
    detail::Rig<Whole>& rig;
  };

  /// Makes the requests of the run the current ones, and no others.
  void commit() {
    const State& state = rig_->state();
    const Tables& tables = rig_->engine.tables();
    const Range edges = tables.groups[group].edges;
    for (Index e = edges.begin; e != edges.end; ++e) {
      state.request[e].level = state.staged_request[e - edges.begin].level;
      GroupAssignment& target = state.last[tables.edges[e].target];
      if (state.request[e].level == nil && target.holder == e) target = {};
    }
  }

  /// Clears the results of the last run.
  void forget() {
    const State& state = rig_->state();
    const Tables& tables = rig_->engine.tables();
    const Range edges = tables.groups[group].edges;
    for (Index at = 0; at < edges.size(); ++at) state.staged_request[at] = {};
    for (Index s = 0; s < tables.states.size(); ++s) state.values[s].staged = unset;
    state.counters->staged_count = 0;
    rig_->refused.clear();
  }

  std::shared_ptr<detail::Rig<Whole>> rig_ = std::make_shared<detail::Rig<Whole>>();
  std::uint8_t reasons_ = 0;
};

} // namespace director::testing
