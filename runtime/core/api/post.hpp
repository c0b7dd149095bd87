#pragma once
// SPDX-License-Identifier: MIT
// The way into a behaviour from outside, typed: what programs, other threads and bodies may ask of it. `Facts`: see
// program.hpp.

#include "runtime/core/api/body.hpp"
#include "runtime/core/engine/engine.hpp"

namespace director {

/// Which overflow slot belongs to whom: first each root task has one, then each external state, then
/// cancel_all.
template <class Facts>
struct OverflowSlotOf {
  /// `state`: one that is external.
  static constexpr Index of_state(Index state) {
    auto slot = static_cast<Index>(Facts::Roots::size);
    for (Index before = 0; before < state; ++before) {
      if (Facts::States::domains[before].external) ++slot;
    }
    return slot;
  }
  /// That of cancel_all.
  static constexpr Index of_all = of_state(static_cast<Index>(Facts::States::domains.size()));
  static constexpr std::size_t count = of_all + std::size_t{1}; ///< how many there are
};

/// The way in. Any thread and any interrupt may use one, at any time, from anywhere. Each call is one input, taken by
/// the next step(). False: nothing was posted, since the inbox is full or a value is outside its state's domain. Root
/// tasks are requested and cancelled, and single states set, even so: for what finds no room each has a slot of its
/// own, where the last call counts, and which is taken after what the inbox held then. What the inbox refuses, and what
/// a slot held when a later call took it over, is counted (BehaviourView::lost), and the observer is told at the next
/// step.
template <class Facts>
class Post {
  using States = typename Facts::States;
  using Roots = typename Facts::Roots;

public:
  /// `engine`: only in the thread that calls step(), where an input for which nobody waits goes straight to it.
  Post(Inbox& inbox, typename Facts::Data& data, Engine* engine = nullptr)
      : inbox_(&inbox),
        data_(&data),
        engine_(engine) {}

  /// Root tasks, with their data; several come together. `request(soccer::Kick{command})` False: only for a level that
  /// the program does not declare in `roots`.
  template <class Task, class... More>
  bool request(Task task, More... more) const {
    static_assert(Roots::template takes<Task, More...>,
                  "only tasks that stand in `roots` can be requested from outside");
    std::array records{record(task), record(more)...};
    for (const Input& input : records) {
      if (input.level() == nil) return false;
    }
    if constexpr (sizeof...(More) > 0) {
      link(records);
    } else if constexpr (!has_data<Task>) {
      return put(records[0], records[0].thing);
    }
    Input* input = records.data();
    const bool room = (wait(task, *input) && ... && wait(more, *++input));
    if (room && (goes_first(records) || inbox_->post_in_turn(records))) return true;
    std::array words = records;
    inbox_->reserve(words);
    input = words.data();
    const Input* before = records.data();
    say(task, *before, *input);
    (say(more, *++before, *++input), ...);
    inbox_->publish(words);
    return true;
  }

  /// Root tasks without data, at their first level. `request<soccer::Striker>()`
  template <class Task, class... More>
  bool request() const {
    constexpr bool without_data = !has_data<Task> && (!has_data<More> && ...);
    static_assert(without_data, "a task with data is requested with them: `request(Task{data})`");
    if constexpr (without_data) {
      return request(Task{}, More{}...);
    } else {
      return false;
    }
  }

  /// The program does not want this root task any more. Never refused.
  template <class Task>
  bool cancel() const {
    static_assert(Roots::template has<Task>, "only tasks that stand in `roots` can be cancelled from outside");
    return cancel_row(Roots::template For<Task>::edge);
  }

  /// All root tasks are cancelled together: nothing starts between one and the next. Never refused.
  bool cancel_all() const { return put({.kind = Input::Kind::cancel, .thing = nil}, OverflowSlotOf<Facts>::of_all); }

  /// A state of this type is set from outside.
  template <class Value>
  static consteval bool external() {
    if constexpr (States::template has<Value>) return States::domains[States::template row<Value>].external;
    return false;
  }

  /// Values of external states, all at once. `set(soccer::Stability::fallen, soccer::Charge{80})` Of one state it is
  /// never refused, but for a value outside of its domain. Several are never split: they are refused if the inbox has
  /// no room for all.
  template <class Value, class... More>
  [[nodiscard]] bool set(Value value, More... more) const {
    static_assert((external<Value>() && ... && external<More>()),
                  "only states that are `external` can be set from outside");
    std::array records{record(States::setting(value)), record(States::setting(more))...};
    bool inside = true;
    for (const Input& input : records) inside = inside && States::domains[input.thing].has(input.value);
    if constexpr (sizeof...(More) > 0) {
      link(records);
      return inside && send(records);
    } else {
      constexpr Index slot = OverflowSlotOf<Facts>::of_state(States::template row<Value>);
      return inside && put(records[0], slot);
    }
  }

  /// Fires a trigger. False: the inbox is full.
  template <class Trigger>
  [[nodiscard]] bool fire() const {
    static_assert(Facts::Triggers::template has<Trigger>, "this is not a trigger of the behaviour");
    return send(std::array{Input{.kind = Input::Kind::fire, .thing = Facts::Triggers::template row<Trigger>}});
  }

  /// A provider that is not enabled does not run. `enable<soccer::Walk::Halting>(false)`
  template <class Provider>
  [[nodiscard]] bool enable(bool enabled) const {
    static_assert(Facts::Providers::template has<Provider>, "this is not a provider of the behaviour");
    return send(std::array{Input{.kind = enabled ? Input::Kind::enable : Input::Kind::disable,
                                 .thing = Facts::Providers::template row<Provider>}});
  }

  // By number, for whoever meets names only while the program runs, such as a bridge to other processes.

  /// Root tasks that carry no data. False: there is no such edge, the task carries data, or the level is not the
  /// edge's.
  [[nodiscard]] bool request_row(Index edge, Index level) const {
    if (!Roots::bare_at(edge)) return false;
    const Range levels = Facts::tables().edges[edge].levels;
    return levels.begin <= level && level < levels.end &&
           put({.kind = Input::Kind::request, .thing = edge, .value = static_cast<std::int32_t>(level)}, edge);
  }
  /// False: root has no such edge.
  bool cancel_row(Index edge) const {
    return edge < Roots::size && put({.kind = Input::Kind::cancel, .thing = edge}, edge);
  }
  /// False also for a state that is not external.
  [[nodiscard]] bool set_row(Index state, std::int32_t value) const {
    if (state >= States::domains.size() || !States::domains[state].external) return false;
    return States::domains[state].has(value) && put(record({state, value}), OverflowSlotOf<Facts>::of_state(state));
  }

private:
  /// True: the engine has it, as nothing waits that it would overtake.
  bool goes_first(std::span<const Input> records) const {
    return records.size() == 1 && engine_ != nullptr && engine_->take_first(records[0]);
  }
  bool send(std::span<const Input> records) const { return goes_first(records) || inbox_->post(records); }
  bool put(const Input& record, Index slot) const { return goes_first({&record, 1}) || inbox_->put(record, slot); }

  static Input record(Setting setting) {
    return {.kind = Input::Kind::set, .thing = setting.state, .value = setting.value};
  }

  /// Without a level (nil) if the task has not the one that was named.
  template <class Task>
  static Input record(const Task& task) {
    using Root = typename Roots::template For<Task>;
    const TaskBase<Task>& base = task;
    return {
        .kind = Input::Kind::request, .thing = Root::edge, .value = static_cast<std::int32_t>(Root::row(base.level))};
  }

  /// Puts the data where they wait for the inbox to be taken. False: no place is left, and they stay where they are.
  template <class Task>
  bool wait([[maybe_unused]] Task& task, [[maybe_unused]] Input& input) const {
    if constexpr (has_data<Task>) {
      TaskBase<Task>& base = task;
      input.handle = data_->template waiting<Task>().put(std::move(base.data));
      return input.handle != nil;
    }
    return true;
  }

  /// Moves the data, from where they are by now, to the place of the overflow slot that was reserved.
  template <class Task>
  void say([[maybe_unused]] Task& task, [[maybe_unused]] const Input& before,
           [[maybe_unused]] const Input& word) const {
    if constexpr (has_data<Task>) {
      auto& waiting = data_->template waiting<Task>();
      TaskBase<Task>& base = task;
      if (word.handle != nil)
        waiting.put_at(word.handle, std::move(before.handle == nil ? base.data : waiting.value(before.handle)));
      if (before.handle != nil) waiting.free(before.handle);
    }
  }

  Inbox* inbox_;
  typename Facts::Data* data_;
  Engine* engine_;
};

} // namespace director
