#pragma once
// Written by directorc 0.1.0 from chase_ball.yaml. Whoever changes it here changes it in vain.
//
// In this order: states, triggers and tasks; what the C++ compiler must know of the specification (detail); what the
// body of each provider gets; the modules that a program implements; the behaviour itself.

#include "behaviours/soccer/wheels.hpp"
#include "runtime/core/behaviour.hpp"

#ifdef __cpp_exceptions
#include <exception>
#endif

namespace chase_ball {

// States

/// (chase_ball.yaml:9)
enum class Ball : std::int32_t { lost, seen };

// Triggers

/// (chase_ball.yaml:11)
struct Picture {};

// Tasks

/// (chase_ball.yaml:16)
struct ChaseBall final : director::Task<ChaseBall> {
  using director::Task<ChaseBall>::Task;
  class Driving;
  class Turning;
};

/// (chase_ball.yaml:21)
struct Wheels final : director::Task<Wheels, chase_ball::WheelSpeeds> {
  using director::Task<Wheels, chase_ball::WheelSpeeds>::Task;
  class Default;
};

// What the C++ compiler must know of the specification: rows of tables, and what each body may ask for.
class Cart;

namespace detail {

template <class Of>
struct Facts;
template <>
struct Facts<Wheels> {
  using Slots = director::Slots<Wheels, 1>;
};

/// The data of all tasks: those of requests, and those that wait in the inbox.
struct Data final : Facts<Wheels>::Slots {
  template <class Task>
  auto& of() {
    return static_cast<typename Facts<Task>::Slots&>(*this);
  }
  template <class Task>
  auto& waiting() {
    return static_cast<director::Waiting<Task>&>(*this);
  }
};

struct States final : director::Table<director::Row<Ball, 0>> {
  static constexpr std::array<director::Domain, 1> domains{{
    {.low = 0, .high = 1, .external = true}, // Ball
  }};
  static constexpr director::Setting setting(Ball value) {
    return {0, static_cast<std::int32_t>(value)};
  }
};

/// The behaviour as a whole.
struct Whole final {
  static constexpr director::Shape shape{
      .groups = 2, .providers = 3, .edges = 2, .conditions = 1, .states = 1, .promises = 0, .plan_slots = 0,
      .listen_slots = 1, .most_edges = 1, .components = 1, .lacking = 1};
  static constexpr std::size_t recall_bytes = 4864;
  static const director::Tables& tables();
  static void called_from_inside();
  static constexpr std::size_t inbox_cells = 64;
  static constexpr std::array<std::uint16_t, 2> places{0, 0};
  using Data = detail::Data;
  using States = detail::States;
  using Roots = director::Pack<director::Must<ChaseBall, 0, 0, 0>>;
  using Triggers = director::Table<director::Row<Picture, 0>>;
  using Providers = director::Table<
      director::Row<ChaseBall::Driving, 0>, director::Row<ChaseBall::Turning, 1>, director::Row<Wheels::Default, 2>>;
  using Groups = director::Table<director::Row<ChaseBall, 0>, director::Row<Wheels, 1>>;
};

template <>
struct Facts<ChaseBall::Driving> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Cart;
  using Task = ChaseBall;
  using Triggers = director::Table<director::Row<Picture, 0>>;
  using Tasks = director::Pack<director::Must<Wheels, 1, 0, 1>>;
};
template <>
struct Facts<ChaseBall::Turning> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Cart;
  using Task = ChaseBall;
  using Tasks = director::Pack<director::Must<Wheels, 1, 0, 1>>;
};
template <>
struct Facts<Wheels::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Cart;
  using Task = Wheels;
};

} // namespace detail

// What the bodies of providers, and start and stop handlers, get

/// (chase_ball.yaml:19)
/// - when: Ball == seen
/// - triggers: Picture
/// - tasks: Wheels
class ChaseBall::Driving final : public director::Body<detail::Facts<ChaseBall::Driving>> {
public:
  using director::Body<detail::Facts<ChaseBall::Driving>>::Body;
};

/// (chase_ball.yaml:20)
/// - tasks: Wheels
class ChaseBall::Turning final : public director::Body<detail::Facts<ChaseBall::Turning>> {
public:
  using director::Body<detail::Facts<ChaseBall::Turning>>::Body;
};

/// (chase_ball.yaml:21)
class Wheels::Default final : public director::Body<detail::Facts<Wheels::Default>> {
public:
  using director::Body<detail::Facts<Wheels::Default>>::Body;
};

// Modules: what the program implements

class Cart {
public:
  virtual director::Outcome provide(ChaseBall::Driving& run) = 0;
  virtual director::Outcome provide(ChaseBall::Turning& run) = 0;
  virtual director::Outcome provide(Wheels::Default& run) = 0;

protected:
  ~Cart() = default; // nobody deletes through this interface
};

namespace detail {
struct Bodies;
} // namespace detail

/// The smallest useful behaviour. A cart turns until it sees the ball, and drives to it. (chase_ball.yaml:2)
/// Holds all memory of its own. The modules must live as long as it does. All that includes this header must be
/// compiled either with exceptions or without.
class Behaviour final : public director::Program<detail::Whole> {
public:
  explicit Behaviour(Cart& cart, director::Observer observer = {});

  /// Takes the inputs that were posted before, then all that is due up to `now` (a duration since any start; an earlier
  /// one counts as the last), until nothing is left to do. What a body or handler threw is thrown on, after its
  /// micro-step; call again to go on. Not from inside a body or handler: an assertion fails there.
  template <director::Duration Now>
  director::StepResult step(Now now) {
    return hand_on(step_to(director::microseconds_begun(now)));
  }

private:
  friend struct detail::Bodies;
  director::StepResult hand_on(director::StepResult result) {
    if (result == director::StepResult::fault) throw_on();
    return result;
  }
  void throw_on();

  Cart* cart_;
#ifdef __cpp_exceptions
  std::exception_ptr thrown_; ///< the first that a body threw since the last step
#endif
};

/// What the rows are called that a director::Event names; empty where there is no such row.
namespace names {
const char* group(director::Index row);
const char* provider(director::Index row);  ///< `halting`; `default` where its group writes its words directly
const char* edge(director::Index row);      ///< `root>Walk`
const char* state(director::Index row);
const char* value(director::Index state, std::int32_t number); ///< `unset` too; empty for a number of a range
const char* trigger(director::Index row);
const char* condition(director::Index row); ///< `Stability == standing`

/// What `why` answered, as a line for people. Written into `room`, cut off where that is too small.
const char* why(const director::Because& because, std::span<char> room);
} // namespace names

} // namespace chase_ball
