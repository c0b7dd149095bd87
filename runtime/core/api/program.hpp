#pragma once
// SPDX-License-Identifier: MIT
// The base of every generated Behaviour, which holds all its memory. `Facts` is the generated struct that says what the
// specification declares:
//   shape, tables()   sizes, known while compiling, and the tables
//   inbox_cells       how many records of inputs can wait
//   Data, places      the slots of task data; edge -> its place among those that lead to its task
//   States            Table of the state types; value -> Setting; the Domain of each state
//   Roots             Pack of `roots`
//   Triggers          Table of the declared triggers
//   Providers         Table of the contexts of all providers
//   Groups            Table of the task types of all groups
//   fingerprint()     a number that tells the behaviour from others; only who saves it asks
//   called_from_inside()  fails an assertion, where assertions count: a body, handler or observer called what only
//                     `post` may do

#include "runtime/core/api/behaviour_view.hpp"
#include "runtime/core/api/post.hpp"
#include "runtime/core/api/saved_data.hpp"

namespace director {

/// Not to be copied or moved: bodies and the inbox point into it.
template <class Facts>
class Program {
  static_assert(Facts::shape.edges + Facts::shape.groups < nil, "more rows than an Index can tell apart");

public:
  using Snapshot = director::Snapshot<Facts>; ///< what other threads may look at; filled by show()
  using Post = director::Post<Facts>;         ///< what acts on the behaviour from other threads

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // The words of Post, for the thread that calls step(). From inside a body, handler or observer an assertion fails;
  // without assertions they are refused (false).

  /// Requests root tasks, with their data and levels; several are one input. What is requested already is a new task.
  template <class Task, class... More>
  bool request(Task task, More... more) {
    return outside() && words().request(std::move(task), std::move(more)...);
  }
  /// The same for tasks that have no data, by their types.
  template <class Task, class... More>
  bool request() {
    return outside() && words().template request<Task, More...>();
  }
  /// Takes back the request for a root task.
  template <class Task>
  bool cancel() {
    return outside() && words().template cancel<Task>();
  }
  /// Takes back the requests for all root tasks, as one input.
  bool cancel_all() { return outside() && words().cancel_all(); }
  /// Sets external states; several are one input. False: a value is outside of its state's domain, or several find no
  /// place in the inbox.
  template <class Value, class... More>
  [[nodiscard]] bool set(Value value, More... more) {
    if constexpr (sizeof...(More) == 0 && Post::template external<Value>()) {
      const Setting setting = Facts::States::setting(value);
      if (Facts::States::domains[setting.state].has(setting.value) &&
          engine_.take_at_once(setting.state, setting.value))
        return true;
    }
    return outside() && words().set(value, more...);
  }
  /// Fires a trigger. False: the inbox is full.
  template <class Trigger>
  [[nodiscard]] bool fire() {
    return outside() && words().template fire<Trigger>();
  }
  /// Lets a provider run, or not any more. False: the inbox is full.
  template <class Provider>
  [[nodiscard]] bool enable(bool enabled) {
    return outside() && words().template enable<Provider>(enabled);
  }

  /// The same words for other threads and interrupts, and for bodies. As long as the behaviour lives, a copy may be
  /// kept.
  Post post() { return {inbox_, data_}; }

  // The words of BehaviourView, for the thread that calls step().

  /// Of the program's own request for this root task: running, queued or none.
  template <class Task>
  RunState state() const {
    return seen().template state<Task>();
  }
  /// Who holds this task's group.
  template <class Task>
  Holding holding() const {
    return seen().template holding<Task>();
  }
  /// Why this task does not run.
  template <class Task>
  Because why() const {
    return seen().template why<Task>();
  }
  /// How many inputs were lost so far.
  std::uint32_t lost() const { return engine_.lost(); }
  /// All that one may ask between steps, as one value.
  BehaviourView<Facts> seen() const { return BehaviourView<Facts>(view_of(engine_)); }

  /// Lets other threads see what holds now. Between steps; false: somebody is still looking at the moment before the
  /// last, and there is room for two.
  bool show(Snapshot& snapshot) const { return snapshot.show(view_of(engine_)); }

  // The state of the behaviour as bytes: all that it decides by, and the data of its tasks. For simulators, debuggers,
  // and programs whose bodies keep nothing of their own: members of modules and what hardware does are not saved. The
  // data of every task must be trivially copyable, else save and load do not compile. For the thread that calls step(),
  // between steps.

  /// Bytes that save() writes.
  static constexpr std::size_t saved_bytes() { return saved::bytes_of_behaviour<Facts>; }

  /// Into the first saved_bytes() of these bytes. Not if anything waits in the inbox: to_text(result) says what to do.
  [[nodiscard]] SaveResult save(std::span<std::byte> to) {
    return outside() ? saved::save<Facts>(engine_, data_, to) : SaveResult::refused;
  }

  /// Goes on from a state that was saved by the same behaviour, in this program or another. All timers are moved, so
  /// that what was due in 3 s is due 3 s after `now`, the time (as step() has it) that the state is to stand at. Nobody
  /// is called: no start handler of what is live then, no stop handler of what was live before. What waits in the inbox
  /// stays there for the next step. Unless the result is `loaded`, nothing has changed.
  template <Duration Now>
  [[nodiscard]] LoadResult load(std::span<const std::byte> from, Now now) {
    return outside() ? saved::load<Facts>(engine_, data_, from, microseconds_begun(now)) : LoadResult::refused;
  }

  /// Micro-steps that one step() may take before it answers budget_exhausted.
  void set_budget(std::uint32_t micro_steps) { engine_.set_budget(micro_steps); }

  /// Work that one step() may do before it answers budget_exhausted: groups placed, tasks decided, choices tried.
  /// Looked at between micro-steps, so the last one may go beyond by what one micro-step takes at most. 0: any.
  void set_work_budget(std::uint64_t work) { engine_.set_work_budget(work); }

  /// For whoever looks deeper: what holds between steps, by number (the generated `names` tell what a number is
  /// called).
  const Engine& engine() const { return engine_; }

protected:
  /// By generated code.
  explicit Program(const Bodies& bodies)
      : inbox_(cells_, words_),
        engine_(Facts::tables(), State::in(memory_.data(), layout), bodies, inbox_) {}
  ~Program() = default;

  /// A step to this time; generated code has the typed one.
  StepResult step_to(Time now) { return checked(engine_.step(now)); }
  /// A step without another time.
  StepResult step_on() { return checked(engine_.step()); }
  /// The slots of all tasks' data.
  typename Facts::Data& data() { return data_; }
  /// Who is told from now on. Defined where it is called: without an observer nothing that tells is linked.
  void observe(Observer observer) { engine_.observe(observer); }
  /// What an observer threw was kept: the step ends.
  void observer_threw() { engine_.end_with_fault(); }

private:
  Post words() { return {inbox_, data_, &engine_}; }

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
  std::array<OverflowSlot, OverflowSlotOf<Facts>::count> words_;
  static constexpr std::size_t memory_bytes = State::bytes(Facts::shape);
  static constexpr auto layout = [] {
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

/// What the generated code's Bodies::data does for one group's task. Slots::of and waiting of `Data` are its bases.
template <class Task, bool root>
void move_data(auto& data, Bodies::Data what, Index place, Index handle) noexcept {
  auto& slots = data.template of<Task>();
  if (what == Bodies::Data::settle) return slots.settle(place);
  if (what == Bodies::Data::retain) return slots.retain(place);
  if constexpr (root) {
    auto& waiting = data.template waiting<Task>();
    slots.stage(place, std::move(waiting.value(handle)));
    waiting.free(handle);
  }
}

} // namespace director
