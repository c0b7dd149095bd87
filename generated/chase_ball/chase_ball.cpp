// Written by directorc 0.1.0 from chase_ball.yaml. Whoever changes it here changes it in vain.
#include "chase_ball.hpp"

#if __STDC_HOSTED__
#include <cassert>
#endif

namespace chase_ball {

// The tables; see runtime/core/tables.hpp. A column that is not named has its initial value.
namespace {

constexpr std::array<director::Group, 2> groups{{
  {.providers = {0, 2}, .edges = {1, 2}, .requesters = {3, 4}, .listens = {0, 1}}, // ChaseBall
  {.providers = {2, 3}, .requesters = {4, 5}}, // Wheels
}};
constexpr std::array<director::Provider, 3> providers{{
  {.when = {0, 1}, .triggers = {1, 2}}, // ChaseBall.driving
  {}, // ChaseBall.turning
  {.group = 1}, // Wheels
}};
constexpr std::array<director::Edge, 2> edges{{
  {.levels = {0, 1}}, // root>ChaseBall
  {.requester = 0, .target = 1, .levels = {1, 2}}, // ChaseBall>Wheels
}};
constexpr std::array<director::Level, 2> levels{{
  {}, // root>ChaseBall
  {}, // ChaseBall>Wheels
}};
constexpr std::array<director::Condition, 1> conditions{{
  {.accepts = {0, 1}, .components = {11, 12}}, // Ball == seen
}};
constexpr std::array<director::Interval, 1> intervals{{
  {.low = 1, .high = 1}, // Ball == seen
}};
constexpr std::array<director::StateVariable, 1> states{{
  {.initial = 0, .expires = 500000, .expires_to = 0, .external = true, .conditions = {10, 11}}, // Ball
}};
constexpr std::array<director::Trigger, 1> triggers{{
  {.listeners = {2, 3}}, // Picture
}};
constexpr std::array<director::Promise, 0> promises{};
constexpr std::array<director::Index, 12> lists{0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0};
constexpr std::array<director::Component, 1> components{{
  {.groups = {5, 7}, .edges = {7, 9}, .conditions = {9, 10}}, // ChaseBall, Wheels
}};
constexpr std::array<director::Index, 0> plan_groups{};
constexpr std::array<director::Index, 1> listened{0};

constexpr director::Tables rows{
  .groups = groups,
  .providers = providers,
  .edges = edges,
  .levels = levels,
  .conditions = conditions,
  .intervals = intervals,
  .states = states,
  .triggers = triggers,
  .promises = promises,
  .lists = lists,
  .components = components,
  .plan_groups = plan_groups,
  .listened = listened,
  .root_edges = 1,
  .most_edges = 1,
};
static_assert(director::State::bytes(director::Shape::of(rows)) == director::State::bytes(detail::Whole::shape));
static_assert(director::Recall::bytes(rows) == detail::Whole::recall_bytes);

} // namespace

namespace detail {

const director::Tables& Whole::tables() { return rows; }

void Whole::called_from_inside() {
#if __STDC_HOSTED__
  assert(false && "from inside a body or handler only `post` reaches the behaviour");
#endif
}

/// What the engine calls.
struct Bodies {
  /// What the user's code throws waits in the behaviour until the micro-step is over.
  template <class Call, class Fault>
  static auto guarded([[maybe_unused]] Behaviour& behaviour, Call call, [[maybe_unused]] Fault fault) {
#ifdef __cpp_exceptions
    try {
      return call();
    } catch (...) {
      if (!behaviour.thrown_) behaviour.thrown_ = std::current_exception();
      return fault();
    }
#else
    return call();
#endif
  }

  // The body is chosen by its exact type: to resolve a call among the bodies of a large module costs the compiler much more.
  template <class Context, class Module, Module* Behaviour::*module>
  static director::Outcome provide(void* self, director::Run& run) {
    constexpr director::Outcome (Module::*body)(Context&) = &Module::provide;
    Behaviour& behaviour = *static_cast<Behaviour*>(self);
    Context context{run, behaviour.data()};
    return guarded(
        behaviour, [&] { return ((behaviour.*module)->*body)(context); }, [&] { return run.fault(); });
  }

  static void data(void* self, director::Bodies::Data what, director::Index edge, director::Index handle) {
    Data& all = static_cast<Behaviour*>(self)->data();
    const director::Index place = Whole::places[edge];
    switch (edges[edge].target) {
    case 1: return director::move_data<Wheels, false>(all, what, place, handle);
    default: return;
    }
  }

  static director::Bodies of(Behaviour& behaviour) {
    static constexpr std::array<director::Outcome (*)(void*, director::Run&), 3> providers{
      &provide<ChaseBall::Driving, Cart, &Behaviour::cart_>,
      &provide<ChaseBall::Turning, Cart, &Behaviour::cart_>,
      &provide<Wheels::Default, Cart, &Behaviour::cart_>,
    };
    return {.self = &behaviour, .run = providers.data(), .data = &data};
  }
};

} // namespace detail

Behaviour::Behaviour(Cart& cart, director::Observer observer)
    : Program(detail::Bodies::of(*this), observer), cart_(&cart) {}

void Behaviour::throw_on() {
#ifdef __cpp_exceptions
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
#endif
}

namespace names {
namespace {
template <std::size_t count>
const char* name_at(const std::array<const char*, count>& all, std::size_t row) {
  return row < count ? all[row] : "";
}
} // namespace

const char* group(director::Index row) {
  static constexpr std::array<const char*, 2> all{"ChaseBall", "Wheels"};
  return name_at(all, row);
}

const char* provider(director::Index row) {
  static constexpr std::array<const char*, 3> all{"driving", "turning", "default"};
  return name_at(all, row);
}

const char* edge(director::Index row) {
  static constexpr std::array<const char*, 2> all{"root>ChaseBall", "ChaseBall>Wheels"};
  return name_at(all, row);
}

const char* state(director::Index row) {
  static constexpr std::array<const char*, 1> all{"Ball"};
  return name_at(all, row);
}

const char* value(director::Index state, std::int32_t number) {
  if (number == director::unset) return "unset";
  switch (state) {
  case 0: {
    static constexpr std::array<const char*, 2> all{"lost", "seen"};
    return name_at(all, static_cast<std::size_t>(number));
  }
  default: return "";
  }
}

const char* trigger(director::Index row) {
  static constexpr std::array<const char*, 1> all{"Picture"};
  return name_at(all, row);
}

const char* condition(director::Index row) {
  static constexpr std::array<const char*, 1> all{"Ball == seen"};
  return name_at(all, row);
}

const char* why(const director::Because& because, std::span<char> room) {
  static constexpr director::Names all{
      .self = nullptr, .group = [](const void*, director::Index row) { return group(row); },
      .provider = [](const void*, director::Index row) { return provider(row); },
      .edge = [](const void*, director::Index row) { return edge(row); },
      .condition = [](const void*, director::Index row) { return condition(row); }};
  return director::to_text(because, all, room);
}

} // namespace names

} // namespace chase_ball
