#pragma once
// SPDX-License-Identifier: MIT
// The base of every generated Behaviour, which owns all its memory. Members of `Facts`, a generated struct:
//   shape, tables()   sizes, known at compile time, and the tables
//   inbox_cells       how many records of inputs can wait
//   Data, places      the slots of task data; edge -> its place among those that lead to its task
//   States            Table of the state types; value -> Setting; the Domain of each state
//   Roots             Pack of `roots`
//   Triggers          Table of the declared triggers
//   Providers         Table of the contexts of all providers
//   Groups            Table of the task types of all groups
//   fingerprint()     a number that differs between behaviours; used only to save and load
//   called_from_inside()  fails an assertion, if these are compiled: a body, handler or observer called a function
//                     that only `post` offers it

#include "runtime/core/api/behaviour_view.hpp"
#include "runtime/core/api/post.hpp"
#include "runtime/core/api/saved_data.hpp"

namespace director {

/// Not to be copied or moved: bodies and the inbox point into it.
template <class Facts>
class Program {
  static_assert(Facts::shape.edges + Facts::shape.groups < nil && Facts::shape.timers() < nil,
                "more rows than an Index can tell apart: compile without DIRECTOR_SMALL_INDEX");

public:
  using Snapshot = director::Snapshot<Facts>; ///< what other threads may read; filled by show()
  using Post = director::Post<Facts>;         ///< posts inputs from other threads

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // The functions of Post, for the thread that calls step(). From inside a body, handler or observer an assertion
  // fails; without assertions the call is refused (false).

  /// Requests root tasks, with data and levels; several are one input. A task that is requested already is a new task.
  template <class Task, class... More>
  bool request(Task task, More... more) {
    return outside() && local_post().request(std::move(task), std::move(more)...);
  }
  /// The same by type, for tasks without data.
  template <class Task, class... More>
  bool request() {
    return outside() && local_post().template request<Task, More...>();
  }
  /// Withdraws the request for a root task.
  template <class Task>
  bool cancel() {
    return outside() && local_post().template cancel<Task>();
  }
  /// Withdraws the requests for all root tasks, as one input.
  bool cancel_all() { return outside() && local_post().cancel_all(); }
  /// Sets external states; several are one input. False: a value is outside of its domain, or no room for several.
  template <class Value, class... More>
  [[nodiscard]] bool set(Value value, More... more) {
    if constexpr (sizeof...(More) == 0 && Post::template external<Value>()) {
      const Setting setting = Facts::States::setting(value);
      if (Facts::States::domains[setting.state].has(setting.value) &&
          engine_.take_at_once(setting.state, setting.value))
        return true;
    }
    return outside() && local_post().set(value, more...);
  }
  /// Fires a trigger. False: the inbox is full.
  template <class Trigger>
  [[nodiscard]] bool fire() {
    return outside() && local_post().template fire<Trigger>();
  }
  /// Enables or disables a provider. False: the inbox is full.
  template <class Provider>
  [[nodiscard]] bool enable(bool enabled) {
    return outside() && local_post().template enable<Provider>(enabled);
  }

  /// The same functions for other threads, interrupts and bodies. A copy may be kept, and used until the behaviour's
  /// destructor begins.
  Post post() { return {inbox_, data_}; }

  // The functions of BehaviourView, for the thread that calls step().

  /// The state of the program's own request for this root task: running, queued or none.
  template <class Task>
  RunState state() const {
    return seen().template state<Task>();
  }
  /// The requester that holds this task's group, if any.
  template <class Task>
  Holding holding() const {
    return seen().template holding<Task>();
  }
  /// Why this task does not run.
  template <class Task>
  Because why() const {
    return seen().template why<Task>();
  }
  /// The number of inputs lost so far.
  std::uint32_t lost() const { return engine_.lost(); }
  /// All that can be read between steps, as one value.
  BehaviourView<Facts> seen() const { return BehaviourView<Facts>(view_of(engine_)); }

  /// Copies the state for other threads, between steps. False: a thread still reads the copy before the last one.
  bool show(Snapshot& snapshot) const { return snapshot.show(view_of(engine_)); }

  // The state of the behaviour as bytes: its decision state, and the data of its tasks. For simulators, debuggers, and
  // programs whose bodies keep no state: members of modules and the state of hardware are not saved. The data of every
  // task must be trivially copyable, else save and load do not compile. For the thread that calls step(), between
  // steps.

  /// The number of bytes that save() writes.
  static constexpr std::size_t saved_bytes() { return saved::bytes_of_behaviour<Facts>; }

  /// Writes the first saved_bytes() of these bytes, unless an input waits: to_text(result) says what to do.
  [[nodiscard]] SaveResult save(std::span<std::byte> to) {
    return outside() ? saved::save<Facts>(engine_, data_, to) : SaveResult::refused;
  }

  /// Continues from a state that was saved by the same behaviour, in this program or another. Timers are moved to
  /// `now`, the time (as for step()) of the state: what was due in 3 s is due 3 s after `now`. No handler is called,
  /// neither start handlers for what is live then nor stop handlers for what was live before. Inputs in the inbox stay
  /// for the next step. Unless the result is `loaded`, nothing has changed.
  template <Duration Now>
  [[nodiscard]] LoadResult load(std::span<const std::byte> from, Now now) {
    return outside() ? saved::load<Facts>(engine_, data_, from, microseconds_begun(now)) : LoadResult::refused;
  }

  /// Limits the micro-steps of one step(), which then returns budget_exhausted. 0: no limit.
  void set_budget(std::uint32_t micro_steps) { engine_.set_budget(micro_steps); }

  /// Limits the work of one step(), which then returns budget_exhausted: groups placed, tasks decided, choices tried,
  /// groups visited (eight are a unit). It is tested between micro-steps, so that the last one may exceed it by the
  /// work of one micro-step. 0: no limit.
  void set_work_budget(std::uint64_t work) { engine_.set_work_budget(work); }

  /// What holds between steps, by number (the generated `names` are the names of these numbers).
  const Engine& engine() const { return engine_; }

protected:
  /// Made by generated code.
  explicit Program(const Bodies& bodies)
      : inbox_(cells_, overflow_slots_),
        engine_(Facts::tables(), State::in(memory_.data(), layout), bodies, inbox_) {}
  ~Program() = default;

  /// Takes a step to this time; the typed function is in generated code.
  StepResult step_to(Time now) { return checked(engine_.step(now)); }
  /// Takes a step without advancing the time.
  StepResult step_on() { return checked(engine_.step()); }
  /// The slots of all tasks' data.
  typename Facts::Data& data() { return data_; }
  /// Sets the observer. Defined in the header: without an observer, no code that calls it is linked.
  template <bool reports>
  void observe(Observer observer) {
    static_assert(reports,
                  "an observer is told nothing: compile the program and the runtime without DIRECTOR_NO_OBSERVER");
    engine_.observe(observer);
  }
  /// Ends the step, after an observer threw; generated code keeps the exception.
  void observer_threw() { engine_.end_with_fault(); }

private:
  Post local_post() { return {inbox_, data_, &engine_}; }

  static StepResult checked(StepResult result) {
    if (result == StepResult::refused) Facts::called_from_inside();
    return result;
  }
  bool outside() const {
    if (engine_.inside()) Facts::called_from_inside();
    return !engine_.inside();
  }

  typename Facts::Data data_;
  std::array<Inbox::Cell, Facts::inbox_cells> cells_;
  std::array<OverflowSlot, OverflowSlotOf<Facts>::count> overflow_slots_;
  static constexpr std::size_t memory_bytes = State::bytes(Facts::shape);
  // Hidden, as two shared libraries may each have a version of one behaviour: g++ gives such data one address in a
  // process.
  [[gnu::visibility("hidden")]] static constexpr auto layout = [] {
    constexpr State::Layout wide = State::layout(Facts::shape);
    using Offset = std::conditional_t<(memory_bytes >> 16 == 0), std::uint16_t, std::uint32_t>;
    std::array<Offset, State::arrays + 1> out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<Offset>(wide.begin[i]);
    return out;
  }();
  alignas(State::alignment) std::array<std::byte, memory_bytes> memory_;
  Inbox inbox_;
  Engine engine_;
};

/// Bodies::data of generated code for the task of one group. Slots::of and waiting are in the bases of `Data`.
template <class Task, bool root>
void move_data(auto& data, Bodies::Data what, Index place, Index handle) noexcept {
  auto& slots = data.template of<Task>();
  if (what == Bodies::Data::settle) return slots.settle(place);
  if (what == Bodies::Data::retain) return slots.retain(place);
  if constexpr (root) {
    auto& waiting = data.template waiting<Task>();
    slots.stage(std::move(waiting.value(handle)));
    waiting.free(handle);
  }
}

} // namespace director
