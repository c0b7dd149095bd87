#pragma once
// SPDX-License-Identifier: MIT
// Typed inputs of a behaviour, for programs, other threads and bodies. `Facts`: see program.hpp.

#include "runtime/core/api/body.hpp"
#include "runtime/core/engine/engine.hpp"

namespace director {

/// The numbers of overflow slots: one for each root task, then one for each external state, then that of cancel_all.
template <class Facts>
struct OverflowSlotOf {
  /// `state`: an external one.
  static constexpr Index of_state(Index state) {
    auto slot = static_cast<Index>(Facts::Roots::size);
    for (Index before = 0; before < state; ++before) {
      if (Facts::States::domains[before].external) ++slot;
    }
    return slot;
  }
  /// The slot of cancel_all.
  static constexpr Index of_all = of_state(static_cast<Index>(Facts::States::domains.size()));
  static constexpr std::size_t count = of_all + std::size_t{1}; ///< the number of slots
};

/// Posts inputs. It may be used by any thread and any interrupt, at any time. Each call is one input, taken by the next
/// step(). False: nothing was posted, because the inbox is full or a value is outside its state's domain. Requests and
/// cancels of root tasks, and values of single states, are never refused: if the inbox is full, each goes to an
/// overflow slot of its own, where the last call counts, and is taken after what the inbox held then. Inputs that are
/// refused, or replaced in a slot, are counted (BehaviourView::lost) and reported at the next step.
template <class Facts>
class Post {
  using States = typename Facts::States;
  using Roots = typename Facts::Roots;

public:
  /// `engine`: only in the thread that calls step(); an input goes to it directly if no other waits.
  Post(Inbox& inbox, typename Facts::Data& data, Engine* engine = nullptr)
      : inbox_(&inbox),
        data_(&data),
        engine_(engine) {}

  /// Requests root tasks, with their data; several are one input. `request(soccer::Kick{command})` False: only for a
  /// level that the program does not declare in `roots`.
  template <class Task, class... More>
  bool request(Task task, More... more) const {
    static_assert(Roots::template takes<Task, More...>,
                  "only tasks that stand in `roots` can be requested from outside");
    std::array records{record(task), record(more)...};
    if (any(records, [](const Input& input) { return input.level() == nil; })) return false;
    if constexpr (sizeof...(More) > 0) {
      link(records);
    } else if constexpr (!has_data<Task>) {
      return put(records[0], records[0].thing);
    }
    Input* input = records.data();
    const bool room = (store_data(task, *input) && ... && store_data(more, *++input));
    if (room && (goes_first(records) || inbox_->post_in_turn(records))) return true;
    std::array reserved = records;
    inbox_->reserve(reserved);
    input = reserved.data();
    const Input* before = records.data();
    move_to_slot(task, *before, *input);
    (move_to_slot(more, *++before, *++input), ...);
    inbox_->publish(reserved);
    return true;
  }

  /// Refuses keep(), with a message that says why.
  template <class Asked, class... More>
  requires is_kept<Asked>
  bool request(Asked, More...) const {
    static_assert(sizeof(Asked) == 0, "keep() is for bodies: a request from outside is always a new one");
    return false;
  }

  /// Requests root tasks without data, at their first level. `request<soccer::Striker>()`
  template <class Task, class... More>
  bool request() const {
    constexpr bool are_roots = Roots::template takes<Task, More...>;
    constexpr bool without_data = !has_data<Task> && (!has_data<More> && ...);
    static_assert(are_roots, "only tasks that stand in `roots` can be requested from outside");
    static_assert(!are_roots || without_data, "a task with data is requested with them: `request(Task{data})`");
    if constexpr (are_roots && without_data) {
      return request(Task{}, More{}...);
    } else {
      return false;
    }
  }

  /// Withdraws the request for this root task. Never refused.
  template <class Task>
  bool cancel() const {
    static_assert(Roots::template has<Task>, "only tasks that stand in `roots` can be cancelled from outside");
    return cancel_row(Roots::template For<Task>::edge);
  }

  /// Withdraws the requests for all root tasks in one input: nothing starts in between. Never refused.
  bool cancel_all() const { return put({.kind = Input::Kind::cancel, .thing = nil}, OverflowSlotOf<Facts>::of_all); }

  /// Whether the state of this type is external.
  template <class Value>
  static consteval bool external() {
    if constexpr (States::template has<Value>) return States::domains[States::template row<Value>].external;
    return false;
  }

  /// Sets external states in one input. `set(soccer::Stability::fallen, soccer::Charge{80})` A single state is refused
  /// only for a value outside of its domain. Several are refused together if the inbox has no room for all.
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

  /// Enables or disables a provider. `enable<soccer::Walk::Halting>(false)` False: the inbox is full.
  template <class Provider>
  [[nodiscard]] bool enable(bool enabled) const {
    static_assert(Facts::Providers::template has<Provider>, "this is not a provider of the behaviour");
    return send(std::array{Input{.kind = enabled ? Input::Kind::enable : Input::Kind::disable,
                                 .thing = Facts::Providers::template row<Provider>}});
  }

  // By number, for programs that know names only at run time, such as a bridge to other processes.

  /// Requests a root task without data. False: the edge does not exist or has no such level, or the task has data.
  [[nodiscard]] bool request_row(Index edge, Index level) const {
    if (!Roots::bare_at(edge)) return false;
    const Range levels = Facts::tables().edges[edge].levels;
    return levels.begin <= level && level < levels.end &&
           put({.kind = Input::Kind::request, .thing = edge, .value = static_cast<std::int32_t>(level)}, edge);
  }
  /// Withdraws a request of root. False: root has no such edge.
  bool cancel_row(Index edge) const {
    return edge < Roots::size && put({.kind = Input::Kind::cancel, .thing = edge}, edge);
  }
  /// Sets an external state. False: the state is not external, or the value is outside of its domain.
  [[nodiscard]] bool set_row(Index state, std::int32_t value) const {
    if (state >= States::domains.size() || !States::domains[state].external) return false;
    return States::domains[state].has(value) && put(record({state, value}), OverflowSlotOf<Facts>::of_state(state));
  }

private:
  /// Gives the input to the engine directly, if no other input waits that it would overtake. True: it did.
  bool goes_first(std::span<const Input> records) const {
    return records.size() == 1 && engine_ != nullptr && engine_->take_first(records[0]);
  }
  bool send(std::span<const Input> records) const { return goes_first(records) || inbox_->post(records); }
  bool put(const Input& record, Index slot) const { return goes_first({&record, 1}) || inbox_->put(record, slot); }

  static Input record(Setting setting) {
    return {.kind = Input::Kind::set, .thing = setting.state, .value = setting.value};
  }

  /// The level is nil if the entry does not have the named one.
  template <class Task>
  static Input record(const Task& task) {
    using Root = typename Roots::template For<Task>;
    const TaskBase<Task>& base = task;
    return {
        .kind = Input::Kind::request, .thing = Root::edge, .value = static_cast<std::int32_t>(Root::row(base.level))};
  }

  /// Stores the data until the inbox is taken. False: no place is left, and they stay where they are.
  template <class Task>
  bool store_data([[maybe_unused]] Task& task, [[maybe_unused]] Input& input) const {
    if constexpr (has_data<Task>) {
      TaskBase<Task>& base = task;
      input.handle = data_->template waiting<Task>().put(std::move(base.data));
      return input.handle != nil;
    }
    return true;
  }

  /// Moves the data to the place of the overflow slot that was reserved.
  template <class Task>
  void move_to_slot([[maybe_unused]] Task& task, [[maybe_unused]] const Input& before,
                    [[maybe_unused]] const Input& reserved) const {
    if constexpr (has_data<Task>) {
      auto& waiting = data_->template waiting<Task>();
      TaskBase<Task>& base = task;
      if (reserved.handle != nil)
        waiting.put_at(reserved.handle, std::move(before.handle == nil ? base.data : waiting.value(before.handle)));
      if (before.handle != nil) waiting.free(before.handle);
    }
  }

  Inbox* inbox_;
  typename Facts::Data* data_;
  Engine* engine_;
};

} // namespace director
