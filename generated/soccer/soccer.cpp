// Written by directorc 0.1.0 from soccer.yaml. Whoever changes it here changes it in vain.
#include "soccer.hpp"

#if __STDC_HOSTED__
#include <cassert>
#endif

namespace soccer {

// The tables; see runtime/core/tables.hpp. A column that is not named has its initial value.
namespace {

constexpr std::array<director::Group, 24> groups{{
  {.providers = {0, 1}, .edges = {2, 6}, .requesters = {49, 50}}, // Brace
  {.providers = {1, 4}, .edges = {6, 10}, .requesters = {50, 51}, .owned = {51, 52}}, // GetUp
  {.providers = {4, 7}, .edges = {10, 12}, .requesters = {52, 53}}, // FallRecovery
  {.providers = {7, 9}, .edges = {12, 16}, .requesters = {53, 56}, .start = true, .stop = true}, // Walk
  {.providers = {9, 10}, .edges = {16, 18}, .requesters = {56, 57}}, // Kick
  {.providers = {10, 11}, .edges = {18, 19}, .requesters = {57, 59}}, // LookAt
  {.providers = {11, 12}, .edges = {19, 20}, .requesters = {59, 61}}, // WalkTo
  {.providers = {12, 13}, .edges = {20, 23}, .requesters = {61, 62}, .listens = {0, 1}}, // KickTo
  {.providers = {13, 16}, .edges = {23, 27}, .requesters = {62, 63}}, // Striker
  {.providers = {16, 17}, .edges = {27, 28}, .requesters = {63, 64}}, // KickToGoal
  {.providers = {17, 20}, .edges = {28, 30}, .requesters = {64, 65}, .listens = {1, 2}}, // WalkToBall
  {.providers = {20, 21}, .edges = {30, 31}, .requesters = {65, 66}}, // WalkToReady
  {.providers = {21, 23}, .edges = {31, 32}, .requesters = {66, 67}, .listens = {2, 3}}, // Look
  {.providers = {23, 24}, .requesters = {67, 70}}, // LeftArm
  {.providers = {24, 25}, .requesters = {70, 73}}, // RightArm
  {.providers = {25, 26}, .requesters = {73, 74}}, // Head
  {.providers = {26, 27}, .edges = {32, 35}, .requesters = {74, 78}}, // LeftLeg
  {.providers = {27, 28}, .edges = {35, 38}, .requesters = {78, 82}}, // RightLeg
  {.providers = {28, 29}, .requesters = {82, 83}}, // LeftHipYaw
  {.providers = {29, 30}, .requesters = {83, 84}}, // LeftKnee
  {.providers = {30, 31}, .requesters = {84, 85}}, // LeftAnkle
  {.providers = {31, 32}, .requesters = {85, 86}}, // RightHipYaw
  {.providers = {32, 33}, .requesters = {86, 87}}, // RightKnee
  {.providers = {33, 34}, .requesters = {87, 88}}, // RightAnkle
}};
constexpr std::array<director::Provider, 34> providers{{
  {.needs = {2, 6}}, // Brace
  {.group = 1, .when = {6, 7}, .needs = {7, 11}}, // GetUp.tucking
  {.group = 1, .when = {11, 12}, .needs = {12, 16}}, // GetUp.pushing
  {.group = 1, .when = {16, 17}, .needs = {17, 21}}, // GetUp.rising
  {.group = 2, .when = {21, 22}}, // FallRecovery.recovering
  {.group = 2, .when = {22, 23}}, // FallRecovery.protecting
  {.group = 2}, // FallRecovery.watching
  {.group = 3, .needs = {23, 25}}, // Walk.walking
  {.group = 3, .needs = {25, 27}, .effects = {27, 29}, .causing = {29, 30}, .promises = {0, 1}}, // Walk.halting
  {.group = 4, .when = {30, 31}, .stay = {31, 32}, .needs = {32, 34}}, // Kick
  {.group = 5, .needs = {34, 35}}, // LookAt
  {.group = 6}, // WalkTo
  {.group = 7, .triggers = {35, 36}}, // KickTo
  {.group = 8, .when = {36, 37}}, // Striker.playing
  {.group = 8, .when = {37, 38}}, // Striker.ready
  {.group = 8}, // Striker.waiting
  {.group = 9}, // KickToGoal
  {.group = 10, .when = {38, 39}, .stay = {39, 40}, .triggers = {40, 41}}, // WalkToBall.creeping
  {.group = 10, .when = {41, 42}, .triggers = {42, 43}}, // WalkToBall.striding
  {.group = 10}, // WalkToBall.searching
  {.group = 11}, // WalkToReady
  {.group = 12, .when = {43, 44}, .triggers = {44, 45}}, // Look.tracking
  {.group = 12, .every = 600000}, // Look.sweeping
  {.group = 13}, // LeftArm
  {.group = 14}, // RightArm
  {.group = 15}, // Head
  {.group = 16}, // LeftLeg
  {.group = 17}, // RightLeg
  {.group = 18}, // LeftHipYaw
  {.group = 19}, // LeftKnee
  {.group = 20}, // LeftAnkle
  {.group = 21}, // RightHipYaw
  {.group = 22}, // RightKnee
  {.group = 23}, // RightAnkle
}};
constexpr std::array<director::Edge, 38> edges{{
  {.target = 2, .levels = {0, 1}}, // root>FallRecovery
  {.target = 8, .levels = {1, 2}, .need_urgency = 1}, // root>Striker
  {.requester = 0, .target = 16, .levels = {2, 3}}, // Brace>LeftLeg
  {.requester = 0, .target = 17, .levels = {3, 4}}, // Brace>RightLeg
  {.requester = 0, .target = 13, .levels = {4, 5}}, // Brace>LeftArm
  {.requester = 0, .target = 14, .levels = {5, 6}}, // Brace>RightArm
  {.requester = 1, .target = 16, .levels = {6, 7}}, // GetUp>LeftLeg
  {.requester = 1, .target = 17, .levels = {7, 8}}, // GetUp>RightLeg
  {.requester = 1, .target = 13, .levels = {8, 9}}, // GetUp>LeftArm
  {.requester = 1, .target = 14, .levels = {9, 10}}, // GetUp>RightArm
  {.requester = 2, .target = 1, .levels = {10, 11}}, // FallRecovery>GetUp
  {.requester = 2, .levels = {11, 12}}, // FallRecovery>Brace
  {.requester = 3, .target = 16, .levels = {12, 13}}, // Walk>LeftLeg
  {.requester = 3, .target = 17, .levels = {13, 14}}, // Walk>RightLeg
  {.requester = 3, .target = 13, .levels = {14, 15}}, // Walk>LeftArm
  {.requester = 3, .target = 14, .levels = {15, 16}}, // Walk>RightArm
  {.requester = 4, .target = 16, .levels = {16, 17}}, // Kick>LeftLeg
  {.requester = 4, .target = 17, .levels = {17, 18}}, // Kick>RightLeg
  {.requester = 5, .target = 15, .levels = {18, 19}}, // LookAt>Head
  {.requester = 6, .target = 3, .levels = {19, 20}}, // WalkTo>Walk
  {.requester = 7, .target = 3, .levels = {20, 21}}, // KickTo>Walk
  {.requester = 7, .target = 4, .levels = {21, 22}}, // KickTo>Kick
  {.requester = 7, .target = 5, .levels = {22, 23}}, // KickTo>LookAt
  {.requester = 8, .target = 9, .levels = {23, 24}}, // Striker>KickToGoal
  {.requester = 8, .target = 10, .levels = {24, 25}, .need_urgency = 1}, // Striker>WalkToBall
  {.requester = 8, .target = 12, .levels = {25, 27}, .need_urgency = 2}, // Striker>Look
  {.requester = 8, .target = 11, .levels = {27, 28}, .need_urgency = 2}, // Striker>WalkToReady
  {.requester = 9, .target = 7, .levels = {28, 29}}, // KickToGoal>KickTo
  {.requester = 10, .target = 6, .levels = {29, 30}}, // WalkToBall>WalkTo
  {.requester = 10, .target = 3, .levels = {30, 31}}, // WalkToBall>Walk
  {.requester = 11, .target = 6, .levels = {31, 32}}, // WalkToReady>WalkTo
  {.requester = 12, .target = 5, .levels = {32, 33}}, // Look>LookAt
  {.requester = 16, .target = 18, .levels = {33, 34}}, // LeftLeg>LeftHipYaw
  {.requester = 16, .target = 19, .levels = {34, 35}}, // LeftLeg>LeftKnee
  {.requester = 16, .target = 20, .levels = {35, 36}}, // LeftLeg>LeftAnkle
  {.requester = 17, .target = 21, .levels = {36, 37}}, // RightLeg>RightHipYaw
  {.requester = 17, .target = 22, .levels = {37, 38}}, // RightLeg>RightKnee
  {.requester = 17, .target = 23, .levels = {38, 39}}, // RightLeg>RightAnkle
}};
constexpr std::array<director::Level, 39> levels{{
  {.priority = 90}, // root>FallRecovery
  {.priority = 10, .rank = 1, .urgency = 1}, // root>Striker
  {}, // Brace>LeftLeg
  {}, // Brace>RightLeg
  {}, // Brace>LeftArm
  {}, // Brace>RightArm
  {}, // GetUp>LeftLeg
  {}, // GetUp>RightLeg
  {}, // GetUp>LeftArm
  {}, // GetUp>RightArm
  {}, // FallRecovery>GetUp
  {}, // FallRecovery>Brace
  {}, // Walk>LeftLeg
  {}, // Walk>RightLeg
  {.rank = 1, .optional = true}, // Walk>LeftArm
  {.rank = 1, .optional = true}, // Walk>RightArm
  {}, // Kick>LeftLeg
  {}, // Kick>RightLeg
  {}, // LookAt>Head
  {}, // WalkTo>Walk
  {}, // KickTo>Walk
  {}, // KickTo>Kick
  {.apart = true}, // KickTo>LookAt
  {.priority = 20}, // Striker>KickToGoal
  {.priority = 10, .rank = 1, .urgency = 1}, // Striker>WalkToBall
  {.rank = 3, .urgency = 2, .optional = true}, // Striker>Look
  {.rank = 2, .urgency = 2}, // Striker>Look
  {.rank = 2, .urgency = 2}, // Striker>WalkToReady
  {}, // KickToGoal>KickTo
  {}, // WalkToBall>WalkTo
  {}, // WalkToBall>Walk
  {}, // WalkToReady>WalkTo
  {}, // Look>LookAt
  {}, // LeftLeg>LeftHipYaw
  {}, // LeftLeg>LeftKnee
  {}, // LeftLeg>LeftAnkle
  {}, // RightLeg>RightHipYaw
  {}, // RightLeg>RightKnee
  {}, // RightLeg>RightAnkle
}};
constexpr std::array<director::Condition, 12> conditions{{
  {.state = 3, .accepts = {0, 1}, .components = {184, 185}}, // RisingStep == lying
  {.state = 3, .accepts = {1, 2}, .components = {185, 186}}, // RisingStep == tucked
  {.state = 3, .accepts = {2, 3}, .components = {186, 187}}, // RisingStep == kneeling
  {.state = 1, .accepts = {3, 4}, .components = {171, 172}}, // Stability == fallen
  {.state = 1, .accepts = {4, 5}, .components = {172, 173}}, // Stability == falling
  {.state = 1, .accepts = {5, 6}, .causers = {0, 1}, .components = {173, 174}}, // Stability == standing
  {.state = 1, .accepts = {6, 8}, .causers = {1, 2}, .components = {174, 175}}, // Stability != fallen|falling
  {.accepts = {8, 9}, .components = {165, 166}}, // Phase == playing
  {.accepts = {9, 10}, .components = {166, 167}}, // Phase == ready
  {.state = 2, .accepts = {10, 11}, .components = {178, 179}}, // Ball == near
  {.state = 2, .accepts = {11, 12}, .components = {179, 180}}, // Ball >= close
  {.state = 2, .accepts = {12, 13}, .components = {180, 181}}, // Ball != lost
}};
constexpr std::array<director::Interval, 13> intervals{{
  {}, // RisingStep == lying
  {.low = 1, .high = 1}, // RisingStep == tucked
  {.low = 2, .high = 2}, // RisingStep == kneeling
  {.low = 1, .high = 1}, // Stability == fallen
  {.low = 2, .high = 2}, // Stability == falling
  {.low = 4, .high = 4}, // Stability == standing
  {}, // Stability != fallen|falling
  {.low = 3, .high = 4}, // Stability != fallen|falling
  {.low = 3, .high = 3}, // Phase == playing
  {.low = 1, .high = 1}, // Phase == ready
  {.low = 3, .high = 3}, // Ball == near
  {.low = 2, .high = 3}, // Ball >= close
  {.low = 1, .high = 3}, // Ball != lost
}};
constexpr std::array<director::StateVariable, 4> states{{
  {.initial = 0, .external = true, .conditions = {163, 165}}, // Phase
  {.initial = 0, .external = true, .conditions = {167, 171}}, // Stability
  {.initial = 0, .expires = 1000000, .expires_to = 0, .external = true, .conditions = {175, 178}}, // Ball
  {.initial = 0, .owner = 1, .conditions = {181, 184}}, // RisingStep
}};
constexpr std::array<director::Trigger, 1> triggers{{
  {.listeners = {45, 49}}, // Vision
}};
constexpr std::array<director::Promise, 1> promises{{
  {.provider = 8, .condition = 5, .within = 2000000}, // Walk.halting
}};
constexpr std::array<director::Index, 187> lists{
    8, 8, 2, 3, 4, 5, 0, 6, 7, 8, 9, 1, 6, 7, 8, 9, 2, 6, 7, 8, 9, 3, 4, 12, 13, 12, 13, 5, 6, 1, 5, 6, 16, 17, 18, 0,
    7, 8, 9, 10, 0, 11, 0, 11, 0, 12, 17, 18, 21, 11, 10, 3, 0, 19, 20, 29, 21, 22, 31, 28, 30, 27, 1, 23, 24, 26, 25,
    4, 8, 14, 5, 9, 15, 18, 2, 6, 12, 16, 3, 7, 13, 17, 32, 33, 34, 35, 36, 37, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
    19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 8,
    7, 8, 0, 0, 3, 4, 5, 6, 0, 0, 0, 0, 9, 10, 11, 0, 0, 0, 0, 1, 2, 0, 0, 0};
constexpr std::array<director::Component, 1> components{{
  {.groups = {88, 112}, .edges = {112, 150}, .conditions = {150, 162}, .causing = {162, 163}}, // Brace, GetUp, FallRecovery, Walk, Kick, LookAt, WalkTo, KickTo, ...
}};
constexpr std::array<director::Index, 0> plan_groups{};
constexpr std::array<director::Index, 3> listened{0, 0, 0};

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
  .root_edges = 2,
  .most_edges = 4,
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

  template <class Context, class Module, Module* Behaviour::*module>
  static void start(void* self, director::Handling& handling) {
    constexpr void (Module::*body)(Context&) = &Module::start;
    Behaviour& behaviour = *static_cast<Behaviour*>(self);
    Context context{handling, behaviour.data()};
    guarded(
        behaviour, [&] { ((behaviour.*module)->*body)(context); }, [&] { handling.fault(); });
  }

  template <class Context, class Module, Module* Behaviour::*module>
  static void stop(void* self, director::Handling& handling) {
    constexpr void (Module::*body)(Context&) = &Module::stop;
    Behaviour& behaviour = *static_cast<Behaviour*>(self);
    Context context{handling, behaviour.data()};
    guarded(
        behaviour, [&] { ((behaviour.*module)->*body)(context); }, [&] { handling.fault(); });
  }

  static void data(void* self, director::Bodies::Data what, director::Index edge, director::Index handle) {
    Data& all = static_cast<Behaviour*>(self)->data();
    const director::Index place = Whole::places[edge];
    switch (edges[edge].target) {
    case 3: return director::move_data<Walk, false>(all, what, place, handle);
    case 4: return director::move_data<Kick, false>(all, what, place, handle);
    case 5: return director::move_data<LookAt, false>(all, what, place, handle);
    case 6: return director::move_data<WalkTo, false>(all, what, place, handle);
    case 7: return director::move_data<KickTo, false>(all, what, place, handle);
    case 13: return director::move_data<LeftArm, false>(all, what, place, handle);
    case 14: return director::move_data<RightArm, false>(all, what, place, handle);
    case 15: return director::move_data<Head, false>(all, what, place, handle);
    case 16: return director::move_data<LeftLeg, false>(all, what, place, handle);
    case 17: return director::move_data<RightLeg, false>(all, what, place, handle);
    case 18: return director::move_data<LeftHipYaw, false>(all, what, place, handle);
    case 19: return director::move_data<LeftKnee, false>(all, what, place, handle);
    case 20: return director::move_data<LeftAnkle, false>(all, what, place, handle);
    case 21: return director::move_data<RightHipYaw, false>(all, what, place, handle);
    case 22: return director::move_data<RightKnee, false>(all, what, place, handle);
    case 23: return director::move_data<RightAnkle, false>(all, what, place, handle);
    default: return;
    }
  }

  static director::Bodies of(Behaviour& behaviour) {
    static constexpr std::array<director::Outcome (*)(void*, director::Run&), 34> providers{
      &provide<Brace::Default, Recovery, &Behaviour::recovery_>,
      &provide<GetUp::Tucking, Recovery, &Behaviour::recovery_>,
      &provide<GetUp::Pushing, Recovery, &Behaviour::recovery_>,
      &provide<GetUp::Rising, Recovery, &Behaviour::recovery_>,
      &provide<FallRecovery::Recovering, Safety, &Behaviour::safety_>,
      &provide<FallRecovery::Protecting, Safety, &Behaviour::safety_>,
      &provide<FallRecovery::Watching, Safety, &Behaviour::safety_>,
      &provide<Walk::Walking, Locomotion, &Behaviour::locomotion_>,
      &provide<Walk::Halting, Locomotion, &Behaviour::locomotion_>,
      &provide<Kick::Default, Kicking, &Behaviour::kicking_>,
      &provide<LookAt::Default, Looking, &Behaviour::looking_>,
      &provide<WalkTo::Default, Planning, &Behaviour::planning_>,
      &provide<KickTo::Default, Planning, &Behaviour::planning_>,
      &provide<Striker::Playing, Strategy, &Behaviour::strategy_>,
      &provide<Striker::Ready, Strategy, &Behaviour::strategy_>,
      &provide<Striker::Waiting, Strategy, &Behaviour::strategy_>,
      &provide<KickToGoal::Default, Strategy, &Behaviour::strategy_>,
      &provide<WalkToBall::Creeping, Strategy, &Behaviour::strategy_>,
      &provide<WalkToBall::Striding, Strategy, &Behaviour::strategy_>,
      &provide<WalkToBall::Searching, Strategy, &Behaviour::strategy_>,
      &provide<WalkToReady::Default, Strategy, &Behaviour::strategy_>,
      &provide<Look::Tracking, Strategy, &Behaviour::strategy_>,
      &provide<Look::Sweeping, Strategy, &Behaviour::strategy_>,
      &provide<LeftArm::Default, Limbs, &Behaviour::limbs_>,
      &provide<RightArm::Default, Limbs, &Behaviour::limbs_>,
      &provide<Head::Default, Limbs, &Behaviour::limbs_>,
      &provide<LeftLeg::Default, Servos, &Behaviour::servos_>,
      &provide<RightLeg::Default, Servos, &Behaviour::servos_>,
      &provide<LeftHipYaw::Default, Servos, &Behaviour::servos_>,
      &provide<LeftKnee::Default, Servos, &Behaviour::servos_>,
      &provide<LeftAnkle::Default, Servos, &Behaviour::servos_>,
      &provide<RightHipYaw::Default, Servos, &Behaviour::servos_>,
      &provide<RightKnee::Default, Servos, &Behaviour::servos_>,
      &provide<RightAnkle::Default, Servos, &Behaviour::servos_>,
    };
    static constexpr std::array<void (*)(void*, director::Handling&), 24> starts{
      nullptr, // Brace
      nullptr, // GetUp
      nullptr, // FallRecovery
      &start<Walk::Start, Locomotion, &Behaviour::locomotion_>,
      nullptr, // Kick
      nullptr, // LookAt
      nullptr, // WalkTo
      nullptr, // KickTo
      nullptr, // Striker
      nullptr, // KickToGoal
      nullptr, // WalkToBall
      nullptr, // WalkToReady
      nullptr, // Look
      nullptr, // LeftArm
      nullptr, // RightArm
      nullptr, // Head
      nullptr, // LeftLeg
      nullptr, // RightLeg
      nullptr, // LeftHipYaw
      nullptr, // LeftKnee
      nullptr, // LeftAnkle
      nullptr, // RightHipYaw
      nullptr, // RightKnee
      nullptr, // RightAnkle
    };
    static constexpr std::array<void (*)(void*, director::Handling&), 24> stops{
      nullptr, // Brace
      nullptr, // GetUp
      nullptr, // FallRecovery
      &stop<Walk::Stop, Locomotion, &Behaviour::locomotion_>,
      nullptr, // Kick
      nullptr, // LookAt
      nullptr, // WalkTo
      nullptr, // KickTo
      nullptr, // Striker
      nullptr, // KickToGoal
      nullptr, // WalkToBall
      nullptr, // WalkToReady
      nullptr, // Look
      nullptr, // LeftArm
      nullptr, // RightArm
      nullptr, // Head
      nullptr, // LeftLeg
      nullptr, // RightLeg
      nullptr, // LeftHipYaw
      nullptr, // LeftKnee
      nullptr, // LeftAnkle
      nullptr, // RightHipYaw
      nullptr, // RightKnee
      nullptr, // RightAnkle
    };
    return {.self = &behaviour, .run = providers.data(), .start = starts.data(), .stop = stops.data(), .data = &data};
  }
};

} // namespace detail

Behaviour::Behaviour(
    Recovery& recovery, Safety& safety, Locomotion& locomotion, Kicking& kicking, Looking& looking, Planning& planning,
    Strategy& strategy, Limbs& limbs, Servos& servos, director::Observer observer)
    :
    Program(detail::Bodies::of(*this), observer), recovery_(&recovery), safety_(&safety), locomotion_(&locomotion),
    kicking_(&kicking), looking_(&looking), planning_(&planning), strategy_(&strategy), limbs_(&limbs),
    servos_(&servos) {}

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
  static constexpr std::array<const char*, 24> all{
      "Brace", "GetUp", "FallRecovery", "Walk", "Kick", "LookAt", "WalkTo", "KickTo", "Striker", "KickToGoal",
      "WalkToBall", "WalkToReady", "Look", "LeftArm", "RightArm", "Head", "LeftLeg", "RightLeg", "LeftHipYaw",
      "LeftKnee", "LeftAnkle", "RightHipYaw", "RightKnee", "RightAnkle"};
  return name_at(all, row);
}

const char* provider(director::Index row) {
  static constexpr std::array<const char*, 34> all{
      "default", "tucking", "pushing", "rising", "recovering", "protecting", "watching", "walking", "halting",
      "default", "default", "default", "default", "playing", "ready", "waiting", "default", "creeping", "striding",
      "searching", "default", "tracking", "sweeping", "default", "default", "default", "default", "default", "default",
      "default", "default", "default", "default", "default"};
  return name_at(all, row);
}

const char* edge(director::Index row) {
  static constexpr std::array<const char*, 38> all{
      "root>FallRecovery", "root>Striker", "Brace>LeftLeg", "Brace>RightLeg", "Brace>LeftArm", "Brace>RightArm",
      "GetUp>LeftLeg", "GetUp>RightLeg", "GetUp>LeftArm", "GetUp>RightArm", "FallRecovery>GetUp", "FallRecovery>Brace",
      "Walk>LeftLeg", "Walk>RightLeg", "Walk>LeftArm", "Walk>RightArm", "Kick>LeftLeg", "Kick>RightLeg", "LookAt>Head",
      "WalkTo>Walk", "KickTo>Walk", "KickTo>Kick", "KickTo>LookAt", "Striker>KickToGoal", "Striker>WalkToBall",
      "Striker>Look", "Striker>WalkToReady", "KickToGoal>KickTo", "WalkToBall>WalkTo", "WalkToBall>Walk",
      "WalkToReady>WalkTo", "Look>LookAt", "LeftLeg>LeftHipYaw", "LeftLeg>LeftKnee", "LeftLeg>LeftAnkle",
      "RightLeg>RightHipYaw", "RightLeg>RightKnee", "RightLeg>RightAnkle"};
  return name_at(all, row);
}

const char* state(director::Index row) {
  static constexpr std::array<const char*, 4> all{"Phase", "Stability", "Ball", "RisingStep"};
  return name_at(all, row);
}

const char* value(director::Index state, std::int32_t number) {
  if (number == director::unset) return "unset";
  switch (state) {
  case 0: {
    static constexpr std::array<const char*, 5> all{"initial", "ready", "set", "playing", "finished"};
    return name_at(all, static_cast<std::size_t>(number));
  }
  case 1: {
    static constexpr std::array<const char*, 5> all{"unknown", "fallen", "falling", "unstable", "standing"};
    return name_at(all, static_cast<std::size_t>(number));
  }
  case 2: {
    static constexpr std::array<const char*, 4> all{"lost", "far", "close", "near"};
    return name_at(all, static_cast<std::size_t>(number));
  }
  case 3: {
    static constexpr std::array<const char*, 3> all{"lying", "tucked", "kneeling"};
    return name_at(all, static_cast<std::size_t>(number));
  }
  default: return "";
  }
}

const char* trigger(director::Index row) {
  static constexpr std::array<const char*, 1> all{"Vision"};
  return name_at(all, row);
}

const char* condition(director::Index row) {
  static constexpr std::array<const char*, 12> all{
      "RisingStep == lying", "RisingStep == tucked", "RisingStep == kneeling", "Stability == fallen",
      "Stability == falling", "Stability == standing", "Stability != fallen|falling", "Phase == playing",
      "Phase == ready", "Ball == near", "Ball >= close", "Ball != lost"};
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

} // namespace soccer
