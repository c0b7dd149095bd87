#pragma once
// SPDX-License-Identifier: MIT
// The typed contexts of provider bodies and of start and stop handlers: thin layers over Run and Handling. `Facts` is a
// generated struct with what the specification allows here; anything else does not compile. Members of Facts:
//   Behaviour               the Facts of the Behaviour: States, Data, places
//   sets                    array of Allowed: the values that `causing` and `sets` name
//   Task, Module            the task of its group, and the interface that has its body
//   Uses, Triggers          of providers: Table of the edges in `uses`, of the triggers
//   Tasks, flat             of providers: Pack of the flat `tasks`; whether there are no named packs
//   Packs, pack_names       of providers: the named packs, and their names

#include "runtime/core/api/pack.hpp"
#include "runtime/core/base/duration.hpp"

namespace director {

/// A value of a state, by number.
struct Setting {
  Index state = nil;
  std::int32_t value = unset;
};

/// The values of a state, low..high, and whether the program may set it.
struct Domain {
  std::int32_t low = 0, high = 0;
  bool external = false;
  constexpr bool has(std::int32_t value) const { return low <= value && value <= high; }
};

/// Values low..high of a state may be set.
struct Allowed {
  Index state = nil;
  std::int32_t low = 0, high = 0;
  constexpr bool has(Setting setting) const {
    return setting.state == state && low <= setting.value && setting.value <= high;
  }
};

/// Base of Facts with defaults for what a provider or handler does not declare.
struct NothingDeclared {
  [[gnu::visibility("hidden")]] static constexpr std::array<Allowed, 0> sets{};
  static constexpr bool flat = true;
  using Uses = Table<>;
  using Triggers = Table<>;
  using Tasks = Pack<>;
  using Packs = director::Packs<>;
  [[gnu::visibility("hidden")]] static constexpr std::array<const char*, 0> pack_names{};
};

/// The trigger that fires when a promise of this provider is broken:
/// `run.triggered<director::Broken<soccer::Walk::Halting>>()`.
template <class Provider>
struct Broken {};

/// What a body can read about a task or need in its `uses`.
class Used {
public:
  /// Made by generated code.
  Used(const Run& run, Index edge) : run_(run), edge_(edge) {}
  /// Running, queued, or none if this group does not request it.
  RunState state() const { return edge_ == nil ? RunState::none : run_.state(edge_); }
  bool done() const { return edge_ != nil && run_.done(edge_); } ///< its answer was done or fail; only while running
  bool failed() const { return edge_ != nil && run_.failed(edge_); } ///< its answer was fail; only while running

private:
  const Run& run_;
  Index edge_; ///< nil: no edge leads from this group to it
};

/// Never defined: a call of it at compile time is the error whose text names the mistake.
void this_value_is_not_declared_in_causing_or_sets();

template <class Facts>
constexpr bool may_set(Setting setting) {
  return any(Facts::sets, [&](const Allowed& allowed) { return allowed.has(setting); });
}

template <class Facts>
constexpr bool may_set_some(Index state) {
  return any(Facts::sets, [&](const Allowed& allowed) { return allowed.state == state; });
}

/// A state that `causing` or `sets` of this provider or handler names.
template <class Value, class Facts>
concept DeclaredState = Facts::Behaviour::States::template has<Value>&&
    may_set_some<Facts>(Facts::Behaviour::States::template row<Value>);

/// A constant value of a declared state, checked at compile time.
template <class Facts>
class DeclaredValue {
public:
  /// From a constant of the state's type; a value that is not declared does not compile.
  template <class Value>
  consteval DeclaredValue(Value value) {
    static_assert(DeclaredState<Value, Facts>,
                  "`causing` and `sets` of this provider or handler do not name this state");
    if constexpr (DeclaredState<Value, Facts>) setting_ = Facts::Behaviour::States::setting(value);
    if (!may_set<Facts>(setting_)) this_value_is_not_declared_in_causing_or_sets();
  }
  /// The same by number.
  Setting setting() const { return setting_; }

private:
  Setting setting_;
};

/// The common part of the contexts of providers and handlers. `Core`: Run or Handling.
template <class Facts, class Core>
class Context {
  using Data = typename Facts::Behaviour::Data;

public:
  /// Made by generated code.
  Context(Core& core, Data& data) : core_(core), data_(data) {}
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// The data of the task; of a handler, of the task that the group was given last.
  const auto& task() const {
    static_assert(has_data<typename Facts::Task>, "this task has no data");
    const DataPlace at = core_.data();
    const Index place = at.slot == DataPlace::Slot::group ? 0 : Facts::Behaviour::places[at.index];
    return data_.template of<typename Facts::Task>().at(at.slot, place);
  }

  /// Why it is called; there may be several reasons.
  Reasons reasons() const { return core_.reasons(); }

  /// Sets a constant value of a state that the specification declares here; anything else does not compile. A helper
  /// takes the value as an argument of its template: `template <auto next> void finish(auto& run) { run.set(next); }`.
  /// The last call for a state counts. It takes effect when the body returns, together with its answer, and not at all
  /// if the body throws. What handlers set is one input, taken next, also if a handler throws afterwards.
  void set(DeclaredValue<Facts> value) { core_.set(value.setting().state, value.setting().value); }

  /// The same for a computed value. False: it is not declared here, nothing is set, and the observer is called.
  template <class Value>
  bool try_set(Value value) {
    static_assert(DeclaredState<Value, Facts>,
                  "`causing` and `sets` of this provider or handler do not name this state");
    const Setting setting = Facts::Behaviour::States::setting(value);
    const bool declared = may_set<Facts>(setting);
    if (declared) {
      core_.set(setting.state, setting.value);
    } else {
      core_.refuse(setting.state, setting.value);
    }
    return declared;
  }

protected:
  Core& core_; ///< the untyped context
  Data& data_; ///< the data of all tasks
};

/// Base of a start or stop handler's context.
template <class Facts>
class Handler : public Context<Facts, Handling> {
public:
  using Context<Facts, Handling>::Context;
};

/// Base of a provider's context; generated code adds a function for each named pack.
template <class Facts>
class Body : public Context<Facts, Run> {
public:
  using Context<Facts, Run>::Context;

  /// A task or need in `uses`: `run.uses<soccer::Walk>().state()`.
  template <class Task>
  Used uses() const {
    static_assert(Facts::Uses::template has<Task>, "this group does not stand in the provider's `uses`");
    return {this->core_, Facts::Uses::template row<Task>};
  }

  /// Whether this trigger fired since the last run.
  template <class Trigger>
  bool triggered() const {
    static_assert(Facts::Triggers::template has<Trigger>, "the provider's `triggers` do not name this trigger");
    return this->core_.triggered(Facts::Triggers::template row<Trigger>);
  }

  /// Requests a run after this time, `run.wait(50ms)`. The last call counts. The longest duration never ends.
  template <Duration T>
  void wait(T duration) {
    const Time time = microseconds(duration);
    this->core_.wait(time > 0 ? time : 1);
  }

  /// Requests any of the provider's flat `tasks`, or none, and withdraws all other requests.
  template <class... Given>
  Outcome request(Given... tasks) {
    static_assert(Facts::flat, "this provider has packs: request one of them by its name");
    static_assert(!Facts::flat || Facts::Tasks::template takes<Given...>,
                  "only tasks that stand in the provider's `tasks` can be requested");
    static_assert(Facts::Tasks::template once<Given...>, "a task is requested twice");
    if constexpr (Facts::flat && Facts::Tasks::template takes<Given...>) return ask<typename Facts::Tasks>(tasks...);
    return this->core_.fault();
  }

  /// The task is finished. Its requests stay as they are.
  Outcome done() { return this->core_.done(); }
  /// The task is finished without a result. Its requests stay as they are.
  Outcome fail() { return this->core_.fail(); }
  /// All requests stay as they are.
  Outcome keep() { return this->core_.keep(); }

protected:
  /// `number`: the place of the pack among the named packs.
  template <class Pack, std::uint16_t number = 0, class... Given>
  Outcome ask(Given&... tasks) {
    return director::ask<Pack>(this->core_, this->data_, number, tasks...);
  }
};

} // namespace director
