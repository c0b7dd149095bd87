#pragma once
// What a program sees of a behaviour from outside: the base of every generated Behaviour, which holds all its memory,
// and the words by which the outside acts on it. `Facts` is the generated struct that says what the specification
// declares:
//   shape, tables()   sizes, known while compiling, and the tables
//   inbox_cells       how many records of inputs can wait
//   Data, places      the slots of task data; edge -> its place among those that lead to its task
//   States            Table of the state types; value -> Setting; the Domain of each state
//   Roots             Pack of `roots`
//   Triggers          Table of the declared triggers
//   Providers         Table of the contexts of all providers
//   Groups            Table of the task types of all groups
//   called_from_inside()  fails an assertion, where assertions count: a body or handler called what only `post` may do

#include "runtime/core/body.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/core/snapshot.hpp"
#include "runtime/core/why.hpp"

#include <array>
#include <type_traits>

namespace director {

/// The way in. Any thread and any interrupt may use one, at any time, from anywhere. Each call is one input, taken by
/// the next step(). False: nothing was posted, since the inbox is full or a value is outside its state's domain. Root
/// tasks are requested and cancelled even so: for those that find no room each has a slot of its own, where the last
/// call counts, and which is taken after what the inbox held then.
template <class Facts>
class Post {
  using States = typename Facts::States;
  using Roots = typename Facts::Roots;

public:
  Post(Inbox& inbox, typename Facts::Data& data) : inbox_(&inbox), data_(&data) {}

  /// Root tasks, with their data; several come together. `request(soccer::Kick{command})` False: only for a level that
  /// the program does not declare in `roots`.
  template <class Task, class... More>
  bool request(Task task, More... more) const {
    static_assert(Roots::template takes<Task, More...>,
                  "only tasks that stand in `roots` can be requested from outside");
    std::array records{record(task), record(more)...};
    for (const Input& input : records) {
      if (input.level == nil) return false;
    }
    link(records);
    Input* input = records.data();
    const bool room = (wait(task, *input) && ... && wait(more, *++input));
    if (room && inbox_->post_in_turn(records)) return true;
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
    return request(Task{}, More{}...);
  }

  /// The program does not want this root task any more. Never refused.
  template <class Task>
  bool cancel() const {
    static_assert(Roots::template has<Task>, "only tasks that stand in `roots` can be cancelled from outside");
    Input input{.kind = Input::Kind::cancel, .thing = Roots::template For<Task>::edge};
    return inbox_->insist({&input, 1});
  }

  /// Values of external states, all at once. `set(soccer::Stability::fallen, soccer::Charge{80})`
  template <class Value, class... More>
  bool set(Value value, More... more) const {
    static_assert((external<Value>() && ... && external<More>()),
                  "only states that are `external` can be set from outside");
    std::array records{record(States::setting(value)), record(States::setting(more))...};
    bool inside = true;
    for (const Input& input : records) inside = inside && States::domains[input.thing].has(input.value);
    link(records);
    return inside && inbox_->post(records);
  }

  template <class Trigger>
  bool fire() const {
    static_assert(Facts::Triggers::template has<Trigger>, "this is not a trigger of the behaviour");
    const Input input{.kind = Input::Kind::fire, .thing = Facts::Triggers::template row<Trigger>};
    return inbox_->post({&input, 1});
  }

  /// A provider that is not enabled does not run. `enable<soccer::Walk::Halting>(false)`
  template <class Provider>
  bool enable(bool enabled) const {
    static_assert(Facts::Providers::template has<Provider>, "this is not a provider of the behaviour");
    const Input input{.kind = enabled ? Input::Kind::enable : Input::Kind::disable,
                      .thing = Facts::Providers::template row<Provider>};
    return inbox_->post({&input, 1});
  }

  // By number, for whoever meets names only while the program runs, such as a bridge to other processes.

  /// Root tasks that carry no data. False: there is no such edge, the task carries data, or the level is not the
  /// edge's.
  bool request_row(Index edge, Index level) const {
    if (!Roots::bare_at(edge) || !has_level(edge, level)) return false;
    Input input{.kind = Input::Kind::request, .thing = edge, .level = level};
    return inbox_->insist({&input, 1});
  }
  bool cancel_row(Index edge) const {
    if (edge >= Roots::size) return false;
    Input input{.kind = Input::Kind::cancel, .thing = edge};
    return inbox_->insist({&input, 1});
  }
  /// False also for a state that is not external.
  bool set_row(Index state, std::int32_t value) const {
    if (state >= States::domains.size() || !States::domains[state].external) return false;
    const Input input{.kind = Input::Kind::set, .thing = state, .value = value};
    return States::domains[state].has(value) && inbox_->post({&input, 1});
  }

private:
  static bool has_level(Index edge, Index level) {
    const Range levels = Facts::tables().edges[edge].levels;
    return levels.begin <= level && level < levels.end;
  }

  template <std::size_t count>
  static void link(std::array<Input, count>& records) {
    for (std::size_t i = 0; i + 1 < count; ++i) records[i].more = true;
  }

  template <class Value>
  static consteval bool external() {
    if constexpr (States::template has<Value>) return States::domains[States::template row<Value>].external;
    return false;
  }

  static Input record(Setting setting) {
    return {.kind = Input::Kind::set, .thing = setting.state, .value = setting.value};
  }

  /// Without a level (nil) if the task has not the one that was named.
  template <class Task>
  static Input record(const Task& task) {
    using Root = typename Roots::template For<Task>;
    const TaskBase<Task>& base = task;
    return {.kind = Input::Kind::request, .thing = Root::edge, .level = Root::row(base.level)};
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

  /// Puts the data, from where they are by now, where they belong to the last word.
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
};

/// What one may ask between steps.
template <class Facts>
class Seen {
public:
  explicit Seen(const View& view) : view_(view) {}

  /// Of the program's own request for this root task: running, queued or none.
  template <class Task>
  RunState state() const {
    static_assert(Facts::Roots::template has<Task>, "only tasks that stand in `roots` are requested from outside");
    return view_.state(Facts::Roots::template For<Task>::edge);
  }

  /// Who holds this task's group.
  template <class Task>
  Holding holding() const {
    return view_.holding(row<Task>);
  }

  /// Why this task does not run. The generated `names::why` puts the answer into words.
  template <class Task>
  Because why() const {
    return director::why(view_, row<Task>);
  }

  /// By number.
  const View& view() const { return view_; }

private:
  template <class Task>
  static constexpr Index row = [] {
    static_assert(Facts::Groups::template has<Task>, "this is not a task of the behaviour");
    return Facts::Groups::template row<Task>;
  }();

  View view_;
};

/// What other threads see of a behaviour: what held when it was last told to show itself, `behaviour.show(snapshot)`.
/// Any number of threads may look, at any time; nobody waits. Holds two copies of what can be seen.
template <class Facts>
class Snapshot {
public:
  Snapshot() = default;
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  /// A look at the newest moment that was shown, which lasts as long as this object. Short ones are best: from the next
  /// moment that is shown on it is one at the older copy, which cannot take the moment after that while it lasts.
  class Look {
  public:
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
    ~Look() {
      if (room_ != nil) of_.rooms_.leave(room_);
    }
    explicit operator bool() const { return room_ != nil; } ///< false: nothing was shown yet
    Seen<Facts> operator*() const { return Seen<Facts>(of_.views_[room_]); }

  private:
    friend Snapshot;
    explicit Look(const Snapshot& of) : of_(of), room_(of.rooms_.enter()) {}
    const Snapshot& of_;
    Index room_;
  };
  Look look() const { return Look(*this); }

  /// From the thread that calls step(). False: there is still a look at the older copy; nothing changes.
  bool show(const View& view) {
    const Index room = rooms_.begin();
    if (room == nil) return false;
    views_[room] = view.copy(memory_[room].data());
    rooms_.finish(room);
    return true;
  }

private:
  struct alignas(8) Room : std::array<std::byte, View::bytes(Facts::shape)> {};
  mutable TwoRooms rooms_;
  std::array<View, 2> views_;
  std::array<Room, 2> memory_;
};

template <class Facts>
class Program {
  static_assert(Facts::shape.edges + Facts::shape.groups < nil, "more rows than an Index can tell apart");

public:
  using Snapshot = director::Snapshot<Facts>;
  using Post = director::Post<Facts>;

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // The words of Post, for the thread that calls step(). From inside a body or handler an assertion fails; without
  // assertions they are refused (false).
  template <class Task, class... More>
  bool request(Task task, More... more) {
    return outside() && post().request(std::move(task), std::move(more)...);
  }
  template <class Task, class... More>
  bool request() {
    return outside() && post().template request<Task, More...>();
  }
  template <class Task>
  bool cancel() {
    return outside() && post().template cancel<Task>();
  }
  template <class Value, class... More>
  bool set(Value value, More... more) {
    return outside() && post().set(value, more...);
  }
  template <class Trigger>
  bool fire() {
    return outside() && post().template fire<Trigger>();
  }
  template <class Provider>
  bool enable(bool enabled) {
    return outside() && post().template enable<Provider>(enabled);
  }

  /// The same words for other threads and interrupts, and for bodies. As long as the behaviour lives, a copy may be
  /// kept.
  Post post() { return {inbox_, data_}; }

  // The words of Seen, for the thread that calls step().
  template <class Task>
  RunState state() const {
    return seen().template state<Task>();
  }
  template <class Task>
  Holding holding() const {
    return seen().template holding<Task>();
  }
  template <class Task>
  Because why() const {
    return seen().template why<Task>();
  }
  Seen<Facts> seen() const { return Seen<Facts>(engine_.view()); }

  /// Lets other threads see what holds now. Between steps; false: somebody is still looking at the moment before the
  /// last, and there is room for two.
  bool show(Snapshot& snapshot) const { return snapshot.show(engine_.view()); }

  /// Micro-steps that one step() may take before it answers budget_exhausted.
  void set_budget(std::uint32_t micro_steps) { engine_.set_budget(micro_steps); }

  /// For whoever looks deeper: what holds between steps, by number (the generated `names` tell what a number is
  /// called).
  const Engine& engine() const { return engine_; }

protected:
  Program(const Bodies& bodies, Observer observer)
      : inbox_(cells_, words_),
        engine_(Facts::tables(), memory_.data(), bodies, inbox_, observer) {}
  ~Program() = default;

  StepResult step_to(Time now) { return checked(engine_.step(now)); }
  StepResult step_on() { return checked(engine_.step()); }
  typename Facts::Data& data() { return data_; }

private:
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
  std::array<LastWords::Slot, Facts::Roots::size> words_;
  alignas(8) std::array<std::byte, State::bytes(Facts::shape)> memory_;
  Inbox inbox_;
  Engine engine_;
};

/// What the generated code's Bodies::data does for one group's task. Slots::of and waiting of `Data` are its bases.
template <class Task, bool root>
void move_data(auto& data, Bodies::Data what, Index place, Index handle) noexcept {
  auto& slots = data.template of<Task>();
  switch (what) {
  case Bodies::Data::settle: return slots.settle(place);
  case Bodies::Data::retain: return slots.retain(place);
  case Bodies::Data::accept: break;
  }
  if constexpr (root) {
    auto& waiting = data.template waiting<Task>();
    slots.stage(place, std::move(waiting.value(handle)));
    waiting.free(handle);
  }
}

} // namespace director
