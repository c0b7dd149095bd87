#pragma once
// Written by directorc 0.1.0 from soccer.yaml. Whoever changes it here changes it in vain.
//
// In this order: states, triggers and tasks; what the C++ compiler must know of the specification (detail); what the
// body of each provider gets; the modules that a program implements; the behaviour itself.

#include "behaviours/soccer/messages.hpp"
#include "runtime/core/behaviour.hpp"

#ifdef __cpp_exceptions
#include <exception>
#endif

namespace soccer {

// States

/// What the referee says. (senses.yaml:9)
using Phase = soccer::GamePhase;

/// The inertial sensor reports falls. That the robot stands still, only the walk can say, which knows when it has
/// stopped. (senses.yaml:15)
/// unknown has no place in the order.
enum class Stability : std::int32_t { unknown, fallen, falling, unstable, standing };

/// How far away the camera sees the ball. Not seen for a second, it is lost. (senses.yaml:21)
/// lost has no place in the order.
enum class Ball : std::int32_t { lost, far, close, near };

/// How far it has come. It belongs to GetUp, so the next fall begins at the first step again. (recovery.yaml:10)
enum class RisingStep : std::int32_t { lying, tucked, kneeling };

// Triggers

/// (senses.yaml:29)
struct Vision {};

// Tasks

/// Arms out, knees soft, until the robot has hit the ground. (recovery.yaml:17)
struct Brace final : director::Task<Brace> {
  using director::Task<Brace>::Task;
  class Default;
};

/// (recovery.yaml:23)
struct GetUp final : director::Task<GetUp> {
  using director::Task<GetUp>::Task;
  class Tucking;
  class Pushing;
  class Rising;
};

/// (safety.yaml:10)
struct FallRecovery final : director::Task<FallRecovery> {
  using director::Task<FallRecovery>::Task;
  class Recovering;
  class Protecting;
  class Watching;
};

/// (locomotion.yaml:10)
struct Walk final : director::Task<Walk, soccer::WalkCommand> {
  using director::Task<Walk, soccer::WalkCommand>::Task;
  class Start;
  class Stop;
  class Walking;
  class Halting;
};

/// (kicking.yaml:10)
struct Kick final : director::Task<Kick, soccer::KickCommand> {
  using director::Task<Kick, soccer::KickCommand>::Task;
  class Default;
};

/// (looking.yaml:10)
struct LookAt final : director::Task<LookAt, soccer::Gaze> {
  using director::Task<LookAt, soccer::Gaze>::Task;
  class Default;
};

/// (planning.yaml:10)
struct WalkTo final : director::Task<WalkTo, soccer::WalkTarget> {
  using director::Task<WalkTo, soccer::WalkTarget>::Task;
  class Default;
};

/// (planning.yaml:16)
struct KickTo final : director::Task<KickTo, soccer::KickTarget> {
  using director::Task<KickTo, soccer::KickTarget>::Task;
  class Default;
};

/// (strategy.yaml:10)
struct Striker final : director::Task<Striker> {
  using director::Task<Striker>::Task;
  class Playing;
  class Ready;
  class Waiting;
};

/// (strategy.yaml:29)
struct KickToGoal final : director::Task<KickToGoal> {
  using director::Task<KickToGoal>::Task;
  class Default;
};

/// (strategy.yaml:35)
struct WalkToBall final : director::Task<WalkToBall> {
  using director::Task<WalkToBall>::Task;
  class Creeping;
  class Striding;
  class Searching;
};

/// (strategy.yaml:55)
struct WalkToReady final : director::Task<WalkToReady> {
  using director::Task<WalkToReady>::Task;
  class Default;
};

/// (strategy.yaml:61)
struct Look final : director::Task<Look> {
  using director::Task<Look>::Task;
  class Tracking;
  class Sweeping;
};

/// (limbs.yaml:10)
struct LeftArm final : director::Task<LeftArm, soccer::ArmMove> {
  using director::Task<LeftArm, soccer::ArmMove>::Task;
  class Default;
};

/// (limbs.yaml:11)
struct RightArm final : director::Task<RightArm, soccer::ArmMove> {
  using director::Task<RightArm, soccer::ArmMove>::Task;
  class Default;
};

/// (limbs.yaml:12)
struct Head final : director::Task<Head, soccer::Gaze> {
  using director::Task<Head, soccer::Gaze>::Task;
  class Default;
};

/// (servos.yaml:10)
struct LeftLeg final : director::Task<LeftLeg, soccer::LegMove> {
  using director::Task<LeftLeg, soccer::LegMove>::Task;
  class Default;
};

/// (servos.yaml:18)
struct RightLeg final : director::Task<RightLeg, soccer::LegMove> {
  using director::Task<RightLeg, soccer::LegMove>::Task;
  class Default;
};

/// (servos.yaml:27)
struct LeftHipYaw final : director::Task<LeftHipYaw, soccer::ServoMove> {
  using director::Task<LeftHipYaw, soccer::ServoMove>::Task;
  class Default;
};

/// (servos.yaml:28)
struct LeftKnee final : director::Task<LeftKnee, soccer::ServoMove> {
  using director::Task<LeftKnee, soccer::ServoMove>::Task;
  class Default;
};

/// (servos.yaml:29)
struct LeftAnkle final : director::Task<LeftAnkle, soccer::ServoMove> {
  using director::Task<LeftAnkle, soccer::ServoMove>::Task;
  class Default;
};

/// (servos.yaml:30)
struct RightHipYaw final : director::Task<RightHipYaw, soccer::ServoMove> {
  using director::Task<RightHipYaw, soccer::ServoMove>::Task;
  class Default;
};

/// (servos.yaml:31)
struct RightKnee final : director::Task<RightKnee, soccer::ServoMove> {
  using director::Task<RightKnee, soccer::ServoMove>::Task;
  class Default;
};

/// (servos.yaml:32)
struct RightAnkle final : director::Task<RightAnkle, soccer::ServoMove> {
  using director::Task<RightAnkle, soccer::ServoMove>::Task;
  class Default;
};

// What the C++ compiler must know of the specification: rows of tables, and what each body may ask for.
class Recovery;
class Safety;
class Locomotion;
class Kicking;
class Looking;
class Planning;
class Strategy;
class Limbs;
class Servos;

namespace detail {

template <class Of>
struct Facts;
template <>
struct Facts<Walk> {
  using Slots = director::Slots<Walk, 3>;
};
template <>
struct Facts<Kick> {
  using Slots = director::Slots<Kick, 1>;
};
template <>
struct Facts<LookAt> {
  using Slots = director::Slots<LookAt, 2>;
};
template <>
struct Facts<WalkTo> {
  using Slots = director::Slots<WalkTo, 2>;
};
template <>
struct Facts<KickTo> {
  using Slots = director::Slots<KickTo, 1>;
};
template <>
struct Facts<LeftArm> {
  using Slots = director::Slots<LeftArm, 3>;
};
template <>
struct Facts<RightArm> {
  using Slots = director::Slots<RightArm, 3>;
};
template <>
struct Facts<Head> {
  using Slots = director::Slots<Head, 1>;
};
template <>
struct Facts<LeftLeg> {
  using Slots = director::Slots<LeftLeg, 4>;
};
template <>
struct Facts<RightLeg> {
  using Slots = director::Slots<RightLeg, 4>;
};
template <>
struct Facts<LeftHipYaw> {
  using Slots = director::Slots<LeftHipYaw, 1>;
};
template <>
struct Facts<LeftKnee> {
  using Slots = director::Slots<LeftKnee, 1>;
};
template <>
struct Facts<LeftAnkle> {
  using Slots = director::Slots<LeftAnkle, 1>;
};
template <>
struct Facts<RightHipYaw> {
  using Slots = director::Slots<RightHipYaw, 1>;
};
template <>
struct Facts<RightKnee> {
  using Slots = director::Slots<RightKnee, 1>;
};
template <>
struct Facts<RightAnkle> {
  using Slots = director::Slots<RightAnkle, 1>;
};

/// The data of all tasks: those of requests, and those that wait in the inbox.
struct Data final :
    Facts<Walk>::Slots, Facts<Kick>::Slots, Facts<LookAt>::Slots, Facts<WalkTo>::Slots, Facts<KickTo>::Slots,
    Facts<LeftArm>::Slots, Facts<RightArm>::Slots, Facts<Head>::Slots, Facts<LeftLeg>::Slots, Facts<RightLeg>::Slots,
    Facts<LeftHipYaw>::Slots, Facts<LeftKnee>::Slots, Facts<LeftAnkle>::Slots, Facts<RightHipYaw>::Slots,
    Facts<RightKnee>::Slots, Facts<RightAnkle>::Slots {
  template <class Task>
  auto& of() {
    return static_cast<typename Facts<Task>::Slots&>(*this);
  }
  template <class Task>
  auto& waiting() {
    return static_cast<director::Waiting<Task>&>(*this);
  }
};

// An enumerator that the specification does not list is an error in `setting`.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
struct States final : director::Table<
    director::Row<Phase, 0>, director::Row<Stability, 1>, director::Row<Ball, 2>, director::Row<RisingStep, 3>> {
  static constexpr std::array<director::Domain, 4> domains{{
    {.low = 0, .high = 4, .external = true}, // Phase
    {.low = 0, .high = 4, .external = true}, // Stability
    {.low = 0, .high = 3, .external = true}, // Ball
    {.low = 0, .high = 2, .external = false}, // RisingStep
  }};
  static constexpr director::Setting setting(Phase value) {
    switch (value) {
    case Phase::initial: return {0, 0};
    case Phase::ready: return {0, 1};
    case Phase::set: return {0, 2};
    case Phase::playing: return {0, 3};
    case Phase::finished: return {0, 4};
    }
    return {0, director::unset};
  }
  static constexpr director::Setting setting(Stability value) {
    return {1, static_cast<std::int32_t>(value)};
  }
  static constexpr director::Setting setting(Ball value) {
    return {2, static_cast<std::int32_t>(value)};
  }
  static constexpr director::Setting setting(RisingStep value) {
    return {3, static_cast<std::int32_t>(value)};
  }
};
#pragma GCC diagnostic pop

/// The behaviour as a whole.
struct Whole final {
  static constexpr director::Shape shape{
      .groups = 24, .providers = 34, .edges = 38, .conditions = 12, .states = 4, .promises = 1, .plan_slots = 0,
      .listen_slots = 3, .most_edges = 4, .components = 1, .lacking = 6};
  static constexpr std::size_t recall_bytes = 28864;
  static const director::Tables& tables();
  static void called_from_inside();
  static constexpr std::size_t inbox_cells = 64;
  static constexpr std::array<std::uint16_t, 38> places{
      0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 2, 2, 2, 2, 3, 3, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 1, 0, 0, 0, 0, 0, 0};
  using Data = detail::Data;
  using States = detail::States;
  using Roots = director::Pack<director::Must<FallRecovery, 0, 0, 0>, director::Must<Striker, 1, 0, 1>>;
  using Triggers = director::Table<director::Row<Vision, 0>>;
  using Providers = director::Table<
      director::Row<Brace::Default, 0>, director::Row<GetUp::Tucking, 1>, director::Row<GetUp::Pushing, 2>,
      director::Row<GetUp::Rising, 3>, director::Row<FallRecovery::Recovering, 4>,
      director::Row<FallRecovery::Protecting, 5>, director::Row<FallRecovery::Watching, 6>,
      director::Row<Walk::Walking, 7>, director::Row<Walk::Halting, 8>, director::Row<Kick::Default, 9>,
      director::Row<LookAt::Default, 10>, director::Row<WalkTo::Default, 11>, director::Row<KickTo::Default, 12>,
      director::Row<Striker::Playing, 13>, director::Row<Striker::Ready, 14>, director::Row<Striker::Waiting, 15>,
      director::Row<KickToGoal::Default, 16>, director::Row<WalkToBall::Creeping, 17>,
      director::Row<WalkToBall::Striding, 18>, director::Row<WalkToBall::Searching, 19>,
      director::Row<WalkToReady::Default, 20>, director::Row<Look::Tracking, 21>, director::Row<Look::Sweeping, 22>,
      director::Row<LeftArm::Default, 23>, director::Row<RightArm::Default, 24>, director::Row<Head::Default, 25>,
      director::Row<LeftLeg::Default, 26>, director::Row<RightLeg::Default, 27>, director::Row<LeftHipYaw::Default, 28>,
      director::Row<LeftKnee::Default, 29>, director::Row<LeftAnkle::Default, 30>,
      director::Row<RightHipYaw::Default, 31>, director::Row<RightKnee::Default, 32>,
      director::Row<RightAnkle::Default, 33>>;
  using Groups = director::Table<
      director::Row<Brace, 0>, director::Row<GetUp, 1>, director::Row<FallRecovery, 2>, director::Row<Walk, 3>,
      director::Row<Kick, 4>, director::Row<LookAt, 5>, director::Row<WalkTo, 6>, director::Row<KickTo, 7>,
      director::Row<Striker, 8>, director::Row<KickToGoal, 9>, director::Row<WalkToBall, 10>,
      director::Row<WalkToReady, 11>, director::Row<Look, 12>, director::Row<LeftArm, 13>, director::Row<RightArm, 14>,
      director::Row<Head, 15>, director::Row<LeftLeg, 16>, director::Row<RightLeg, 17>, director::Row<LeftHipYaw, 18>,
      director::Row<LeftKnee, 19>, director::Row<LeftAnkle, 20>, director::Row<RightHipYaw, 21>,
      director::Row<RightKnee, 22>, director::Row<RightAnkle, 23>>;
};

template <>
struct Facts<Brace::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Recovery;
  using Task = Brace;
  using Tasks = director::Pack<
      director::Must<LeftLeg, 2, 0, 2>, director::Must<RightLeg, 3, 0, 3>, director::Must<LeftArm, 4, 0, 4>,
      director::Must<RightArm, 5, 0, 5>>;
};
template <>
struct Facts<GetUp::Tucking> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Recovery;
  using Task = GetUp;
  static constexpr std::array<director::Allowed, 1> sets{{{3, 1, 1}}};
  using Uses = director::Table<
      director::Row<LeftLeg, 6>, director::Row<RightLeg, 7>, director::Row<LeftArm, 8>, director::Row<RightArm, 9>>;
  using Tasks = director::Pack<
      director::Must<LeftLeg, 6, 1, 6>, director::Must<RightLeg, 7, 1, 7>, director::Must<LeftArm, 8, 1, 8>,
      director::Must<RightArm, 9, 1, 9>>;
};
template <>
struct Facts<GetUp::Pushing> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Recovery;
  using Task = GetUp;
  static constexpr std::array<director::Allowed, 1> sets{{{3, 2, 2}}};
  using Uses = director::Table<
      director::Row<LeftLeg, 6>, director::Row<RightLeg, 7>, director::Row<LeftArm, 8>, director::Row<RightArm, 9>>;
  using Tasks = director::Pack<
      director::Must<LeftLeg, 6, 1, 6>, director::Must<RightLeg, 7, 1, 7>, director::Must<LeftArm, 8, 1, 8>,
      director::Must<RightArm, 9, 1, 9>>;
};
template <>
struct Facts<GetUp::Rising> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Recovery;
  using Task = GetUp;
  static constexpr std::array<director::Allowed, 1> sets{{{1, 3, 3}}};
  using Uses = director::Table<
      director::Row<LeftLeg, 6>, director::Row<RightLeg, 7>, director::Row<LeftArm, 8>, director::Row<RightArm, 9>>;
  using Tasks = director::Pack<
      director::Must<LeftLeg, 6, 1, 6>, director::Must<RightLeg, 7, 1, 7>, director::Must<LeftArm, 8, 1, 8>,
      director::Must<RightArm, 9, 1, 9>>;
};
template <>
struct Facts<FallRecovery::Recovering> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Safety;
  using Task = FallRecovery;
  static constexpr bool flat = false;
  using pack_stand_up = director::Pack<director::Must<GetUp, 10, 0, 10>>;
  using Packs = director::Packs<pack_stand_up>;
  static constexpr std::array<const char*, 1> pack_names{"stand_up"};
};
template <>
struct Facts<FallRecovery::Protecting> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Safety;
  using Task = FallRecovery;
  static constexpr bool flat = false;
  using pack_protect = director::Pack<director::Must<Brace, 11, 0, 11>>;
  using Packs = director::Packs<pack_protect>;
  static constexpr std::array<const char*, 1> pack_names{"protect"};
};
template <>
struct Facts<FallRecovery::Watching> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Safety;
  using Task = FallRecovery;
};
template <>
struct Facts<Walk::Start> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Locomotion;
  using Task = Walk;
};
template <>
struct Facts<Walk::Stop> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Locomotion;
  using Task = Walk;
};
template <>
struct Facts<Walk::Walking> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Locomotion;
  using Task = Walk;
  static constexpr std::array<director::Allowed, 1> sets{{{1, 3, 3}}};
  using Uses = director::Table<director::Row<LeftLeg, 12>, director::Row<RightLeg, 13>>;
  using Tasks = director::Pack<
      director::Must<LeftLeg, 12, 2, 12>, director::Must<RightLeg, 13, 2, 13>, director::May<LeftArm, 14, 2, 14>,
      director::May<RightArm, 15, 2, 15>>;
};
template <>
struct Facts<Walk::Halting> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Locomotion;
  using Task = Walk;
  static constexpr std::array<director::Allowed, 1> sets{{{1, 4, 4}}};
  using Uses = director::Table<director::Row<LeftLeg, 12>, director::Row<RightLeg, 13>>;
  using Tasks = director::Pack<director::Must<LeftLeg, 12, 2, 12>, director::Must<RightLeg, 13, 2, 13>>;
};
template <>
struct Facts<Kick::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Kicking;
  using Task = Kick;
  static constexpr std::array<director::Allowed, 1> sets{{{1, 3, 3}}};
  using Uses = director::Table<director::Row<LeftLeg, 16>, director::Row<RightLeg, 17>>;
  using Tasks = director::Pack<director::Must<LeftLeg, 16, 3, 16>, director::Must<RightLeg, 17, 3, 17>>;
};
template <>
struct Facts<LookAt::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Looking;
  using Task = LookAt;
  using Tasks = director::Pack<director::Must<Head, 18, 0, 18>>;
};
template <>
struct Facts<WalkTo::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Planning;
  using Task = WalkTo;
  static constexpr bool flat = false;
  using pack_step = director::Pack<director::Must<Walk, 19, 0, 19>>;
  using Packs = director::Packs<pack_step>;
  static constexpr std::array<const char*, 1> pack_names{"step"};
};
template <>
struct Facts<KickTo::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Planning;
  using Task = KickTo;
  using Uses = director::Table<director::Row<Walk, 20>, director::Row<Kick, 21>>;
  using Triggers = director::Table<director::Row<Vision, 0>>;
  static constexpr bool flat = false;
  using pack_stand_by = director::Pack<>;
  using pack_line_up = director::Pack<director::Must<Walk, 20, 1, 20>>;
  using pack_kick = director::Pack<director::Must<Kick, 21, 0, 21>, director::Must<LookAt, 22, 0, 22>>;
  using Packs = director::Packs<pack_stand_by, pack_line_up, pack_kick>;
  static constexpr std::array<const char*, 3> pack_names{"stand_by", "line_up", "kick"};
};
template <>
struct Facts<Striker::Playing> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = Striker;
  static constexpr bool flat = false;
  using pack_attack = director::Pack<
      director::Must<KickToGoal, 23, 0, 23>, director::Must<WalkToBall, 24, 0, 24>, director::May<Look, 25, 0, 25>>;
  using Packs = director::Packs<pack_attack>;
  static constexpr std::array<const char*, 1> pack_names{"attack"};
};
template <>
struct Facts<Striker::Ready> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = Striker;
  using Uses = director::Table<director::Row<WalkToReady, 26>>;
  static constexpr bool flat = false;
  using pack_go = director::Pack<director::Must<WalkToReady, 26, 0, 27>, director::May<Look, 25, 0, 25>>;
  using pack_stay_there = director::Pack<director::Must<Look, 25, 0, 26>>;
  using Packs = director::Packs<pack_go, pack_stay_there>;
  static constexpr std::array<const char*, 2> pack_names{"go", "stay_there"};
};
template <>
struct Facts<Striker::Waiting> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = Striker;
  static constexpr bool flat = false;
  using pack_watch = director::Pack<director::Must<Look, 25, 0, 26>>;
  using Packs = director::Packs<pack_watch>;
  static constexpr std::array<const char*, 1> pack_names{"watch"};
};
template <>
struct Facts<KickToGoal::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = KickToGoal;
  using Uses = director::Table<director::Row<KickTo, 27>>;
  static constexpr bool flat = false;
  using pack_shoot = director::Pack<director::Must<KickTo, 27, 0, 28>>;
  using Packs = director::Packs<pack_shoot>;
  static constexpr std::array<const char*, 1> pack_names{"shoot"};
};
template <>
struct Facts<WalkToBall::Creeping> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = WalkToBall;
  using Triggers = director::Table<director::Row<Vision, 0>>;
  static constexpr bool flat = false;
  using pack_creep = director::Pack<director::Must<WalkTo, 28, 0, 29>>;
  using Packs = director::Packs<pack_creep>;
  static constexpr std::array<const char*, 1> pack_names{"creep"};
};
template <>
struct Facts<WalkToBall::Striding> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = WalkToBall;
  using Triggers = director::Table<director::Row<Vision, 0>>;
  static constexpr bool flat = false;
  using pack_stride = director::Pack<director::Must<WalkTo, 28, 0, 29>>;
  using Packs = director::Packs<pack_stride>;
  static constexpr std::array<const char*, 1> pack_names{"stride"};
};
template <>
struct Facts<WalkToBall::Searching> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = WalkToBall;
  static constexpr bool flat = false;
  using pack_turn = director::Pack<director::Must<Walk, 29, 2, 30>>;
  using Packs = director::Packs<pack_turn>;
  static constexpr std::array<const char*, 1> pack_names{"turn"};
};
template <>
struct Facts<WalkToReady::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = WalkToReady;
  using Uses = director::Table<director::Row<WalkTo, 30>>;
  static constexpr bool flat = false;
  using pack_go = director::Pack<director::Must<WalkTo, 30, 1, 31>>;
  using Packs = director::Packs<pack_go>;
  static constexpr std::array<const char*, 1> pack_names{"go"};
};
template <>
struct Facts<Look::Tracking> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = Look;
  using Triggers = director::Table<director::Row<Vision, 0>>;
  static constexpr bool flat = false;
  using pack_track = director::Pack<director::Must<LookAt, 31, 1, 32>>;
  using Packs = director::Packs<pack_track>;
  static constexpr std::array<const char*, 1> pack_names{"track"};
};
template <>
struct Facts<Look::Sweeping> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Strategy;
  using Task = Look;
  static constexpr bool flat = false;
  using pack_sweep = director::Pack<director::Must<LookAt, 31, 1, 32>>;
  using Packs = director::Packs<pack_sweep>;
  static constexpr std::array<const char*, 1> pack_names{"sweep"};
};
template <>
struct Facts<LeftArm::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Limbs;
  using Task = LeftArm;
};
template <>
struct Facts<RightArm::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Limbs;
  using Task = RightArm;
};
template <>
struct Facts<Head::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Limbs;
  using Task = Head;
};
template <>
struct Facts<LeftLeg::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = LeftLeg;
  using Uses = director::Table<
      director::Row<LeftHipYaw, 32>, director::Row<LeftKnee, 33>, director::Row<LeftAnkle, 34>>;
  static constexpr bool flat = false;
  using pack_turn_hip = director::Pack<director::Must<LeftHipYaw, 32, 0, 33>>;
  using pack_bend_knee = director::Pack<director::Must<LeftKnee, 33, 0, 34>>;
  using pack_set_foot = director::Pack<director::Must<LeftAnkle, 34, 0, 35>>;
  using Packs = director::Packs<pack_turn_hip, pack_bend_knee, pack_set_foot>;
  static constexpr std::array<const char*, 3> pack_names{"turn_hip", "bend_knee", "set_foot"};
};
template <>
struct Facts<RightLeg::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = RightLeg;
  using Uses = director::Table<
      director::Row<RightHipYaw, 35>, director::Row<RightKnee, 36>, director::Row<RightAnkle, 37>>;
  static constexpr bool flat = false;
  using pack_turn_hip = director::Pack<director::Must<RightHipYaw, 35, 0, 36>>;
  using pack_bend_knee = director::Pack<director::Must<RightKnee, 36, 0, 37>>;
  using pack_set_foot = director::Pack<director::Must<RightAnkle, 37, 0, 38>>;
  using Packs = director::Packs<pack_turn_hip, pack_bend_knee, pack_set_foot>;
  static constexpr std::array<const char*, 3> pack_names{"turn_hip", "bend_knee", "set_foot"};
};
template <>
struct Facts<LeftHipYaw::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = LeftHipYaw;
};
template <>
struct Facts<LeftKnee::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = LeftKnee;
};
template <>
struct Facts<LeftAnkle::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = LeftAnkle;
};
template <>
struct Facts<RightHipYaw::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = RightHipYaw;
};
template <>
struct Facts<RightKnee::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = RightKnee;
};
template <>
struct Facts<RightAnkle::Default> : director::NothingDeclared {
  using Behaviour = Whole;
  using Module = Servos;
  using Task = RightAnkle;
};

} // namespace detail

// What the bodies of providers, and start and stop handlers, get

/// (recovery.yaml:17)
/// - needs: LeftLeg, RightLeg, LeftArm, RightArm
/// - tasks: LeftLeg, RightLeg, LeftArm, RightArm
class Brace::Default final : public director::Body<detail::Facts<Brace::Default>> {
public:
  using director::Body<detail::Facts<Brace::Default>>::Body;
};

/// (recovery.yaml:27)
/// - when: RisingStep == lying
/// - needs: LeftLeg, RightLeg, LeftArm, RightArm
/// - sets: RisingStep == tucked
/// - uses: LeftLeg, RightLeg, LeftArm, RightArm
/// - tasks: LeftLeg, RightLeg, LeftArm, RightArm
class GetUp::Tucking final : public director::Body<detail::Facts<GetUp::Tucking>> {
public:
  using director::Body<detail::Facts<GetUp::Tucking>>::Body;
};

/// (recovery.yaml:32)
/// - when: RisingStep == tucked
/// - needs: LeftLeg, RightLeg, LeftArm, RightArm
/// - sets: RisingStep == kneeling
/// - uses: LeftLeg, RightLeg, LeftArm, RightArm
/// - tasks: LeftLeg, RightLeg, LeftArm, RightArm
class GetUp::Pushing final : public director::Body<detail::Facts<GetUp::Pushing>> {
public:
  using director::Body<detail::Facts<GetUp::Pushing>>::Body;
};

/// On its feet again, though not yet steady. That is for the walk to settle. (recovery.yaml:37)
/// - when: RisingStep == kneeling
/// - needs: LeftLeg, RightLeg, LeftArm, RightArm
/// - sets: Stability == unstable
/// - uses: LeftLeg, RightLeg, LeftArm, RightArm
/// - tasks: LeftLeg, RightLeg, LeftArm, RightArm
class GetUp::Rising final : public director::Body<detail::Facts<GetUp::Rising>> {
public:
  using director::Body<detail::Facts<GetUp::Rising>>::Body;
};

/// (safety.yaml:13)
/// - when: Stability == fallen
class FallRecovery::Recovering final : public director::Body<detail::Facts<FallRecovery::Recovering>> {
public:
  using director::Body<detail::Facts<FallRecovery::Recovering>>::Body;

  /// GetUp. (safety.yaml:16)
  template <class... Given>
  director::Outcome stand_up(Given... tasks) {
    using Pack = detail::Facts<FallRecovery::Recovering>::pack_stand_up;
    static_assert(Pack::takes<Given...>, "stand_up asks for GetUp only");
    static_assert(Pack::once<Given...>, "stand_up is given a task twice");
    static_assert(director::given<GetUp, Given...>, "stand_up must be given its task GetUp");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (safety.yaml:17)
/// - when: Stability == falling
class FallRecovery::Protecting final : public director::Body<detail::Facts<FallRecovery::Protecting>> {
public:
  using director::Body<detail::Facts<FallRecovery::Protecting>>::Body;

  /// Brace. (safety.yaml:20)
  template <class... Given>
  director::Outcome protect(Given... tasks) {
    using Pack = detail::Facts<FallRecovery::Protecting>::pack_protect;
    static_assert(Pack::takes<Given...>, "protect asks for Brace only");
    static_assert(Pack::once<Given...>, "protect is given a task twice");
    static_assert(director::given<Brace, Given...>, "protect must be given its task Brace");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// All is well. (safety.yaml:21)
class FallRecovery::Watching final : public director::Body<detail::Facts<FallRecovery::Watching>> {
public:
  using director::Body<detail::Facts<FallRecovery::Watching>>::Body;
};

/// (locomotion.yaml:13)
class Walk::Start final : public director::Handler<detail::Facts<Walk::Start>> {
public:
  using director::Handler<detail::Facts<Walk::Start>>::Handler;
};

/// (locomotion.yaml:14)
class Walk::Stop final : public director::Handler<detail::Facts<Walk::Stop>> {
public:
  using director::Handler<detail::Facts<Walk::Stop>>::Handler;
};

/// (locomotion.yaml:17)
/// - needs: LeftLeg, RightLeg
/// - sets: Stability == unstable
/// - uses: LeftLeg, RightLeg
/// - tasks: LeftLeg, RightLeg, LeftArm (optional), RightArm (optional)
class Walk::Walking final : public director::Body<detail::Facts<Walk::Walking>> {
public:
  using director::Body<detail::Facts<Walk::Walking>>::Body;
};

/// Brings both feet together. Never anybody's first choice, so it runs when somebody who goes first waits for what it
/// promises. (locomotion.yaml:21)
/// - needs: LeftLeg, RightLeg
/// - causing: Stability == standing within 2 s
/// - uses: LeftLeg, RightLeg
/// - tasks: LeftLeg, RightLeg
class Walk::Halting final : public director::Body<detail::Facts<Walk::Halting>> {
public:
  using director::Body<detail::Facts<Walk::Halting>>::Body;
};

/// (kicking.yaml:10)
/// - when: Stability == standing
/// - stay: Stability != fallen|falling
/// - needs: LeftLeg, RightLeg
/// - sets: Stability == unstable
/// - uses: LeftLeg, RightLeg
/// - tasks: LeftLeg, RightLeg
class Kick::Default final : public director::Body<detail::Facts<Kick::Default>> {
public:
  using director::Body<detail::Facts<Kick::Default>>::Body;
};

/// (looking.yaml:10)
/// - needs: Head
/// - tasks: Head
class LookAt::Default final : public director::Body<detail::Facts<LookAt::Default>> {
public:
  using director::Body<detail::Facts<LookAt::Default>>::Body;
};

/// (planning.yaml:10)
class WalkTo::Default final : public director::Body<detail::Facts<WalkTo::Default>> {
public:
  using director::Body<detail::Facts<WalkTo::Default>>::Body;

  /// Walk. (planning.yaml:14)
  template <class... Given>
  director::Outcome step(Given... tasks) {
    using Pack = detail::Facts<WalkTo::Default>::pack_step;
    static_assert(Pack::takes<Given...>, "step asks for Walk only");
    static_assert(Pack::once<Given...>, "step is given a task twice");
    static_assert(director::given<Walk, Given...>, "step must be given its task Walk");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (planning.yaml:16)
/// - uses: Walk, Kick
/// - triggers: Vision
class KickTo::Default final : public director::Body<detail::Facts<KickTo::Default>> {
public:
  using director::Body<detail::Facts<KickTo::Default>>::Body;

  /// Asks for nothing. (planning.yaml:22)
  director::Outcome stand_by() {
    return Body::ask<detail::Facts<KickTo::Default>::pack_stand_by, 0>();
  }

  /// Walk. (planning.yaml:23)
  template <class... Given>
  director::Outcome line_up(Given... tasks) {
    using Pack = detail::Facts<KickTo::Default>::pack_line_up;
    static_assert(Pack::takes<Given...>, "line_up asks for Walk only");
    static_assert(Pack::once<Given...>, "line_up is given a task twice");
    static_assert(director::given<Walk, Given...>, "line_up must be given its task Walk");
    return Body::ask<Pack, 1>(tasks...);
  }

  /// Kick, LookAt (apart). (planning.yaml:24)
  template <class... Given>
  director::Outcome kick(Given... tasks) {
    using Pack = detail::Facts<KickTo::Default>::pack_kick;
    static_assert(Pack::takes<Given...>, "kick asks for Kick and LookAt only");
    static_assert(Pack::once<Given...>, "kick is given a task twice");
    static_assert(director::given<Kick, Given...>, "kick must be given its task Kick");
    static_assert(director::given<LookAt, Given...>, "kick must be given its task LookAt");
    return Body::ask<Pack, 2>(tasks...);
  }
};

/// (strategy.yaml:13)
/// - when: Phase == playing
class Striker::Playing final : public director::Body<detail::Facts<Striker::Playing>> {
public:
  using director::Body<detail::Facts<Striker::Playing>>::Body;

  /// KickToGoal, WalkToBall, Look (optional). (strategy.yaml:16)
  template <class... Given>
  director::Outcome attack(Given... tasks) {
    using Pack = detail::Facts<Striker::Playing>::pack_attack;
    static_assert(Pack::takes<Given...>, "attack asks for KickToGoal, WalkToBall and Look only");
    static_assert(Pack::once<Given...>, "attack is given a task twice");
    static_assert(director::given<KickToGoal, Given...>, "attack must be given its task KickToGoal");
    static_assert(director::given<WalkToBall, Given...>, "attack must be given its task WalkToBall");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// Goes to its place before the kick-off, and waits there. (strategy.yaml:17)
/// - when: Phase == ready
/// - uses: WalkToReady
class Striker::Ready final : public director::Body<detail::Facts<Striker::Ready>> {
public:
  using director::Body<detail::Facts<Striker::Ready>>::Body;

  /// WalkToReady, Look (optional). (strategy.yaml:22)
  template <class... Given>
  director::Outcome go(Given... tasks) {
    using Pack = detail::Facts<Striker::Ready>::pack_go;
    static_assert(Pack::takes<Given...>, "go asks for WalkToReady and Look only");
    static_assert(Pack::once<Given...>, "go is given a task twice");
    static_assert(director::given<WalkToReady, Given...>, "go must be given its task WalkToReady");
    return Body::ask<Pack, 0>(tasks...);
  }

  /// Look. (strategy.yaml:23)
  template <class... Given>
  director::Outcome stay_there(Given... tasks) {
    using Pack = detail::Facts<Striker::Ready>::pack_stay_there;
    static_assert(Pack::takes<Given...>, "stay_there asks for Look only");
    static_assert(Pack::once<Given...>, "stay_there is given a task twice");
    static_assert(director::given<Look, Given...>, "stay_there must be given its task Look");
    return Body::ask<Pack, 1>(tasks...);
  }
};

/// The referee has not started the game yet, or has ended it. (strategy.yaml:24)
class Striker::Waiting final : public director::Body<detail::Facts<Striker::Waiting>> {
public:
  using director::Body<detail::Facts<Striker::Waiting>>::Body;

  /// Look. (strategy.yaml:27)
  template <class... Given>
  director::Outcome watch(Given... tasks) {
    using Pack = detail::Facts<Striker::Waiting>::pack_watch;
    static_assert(Pack::takes<Given...>, "watch asks for Look only");
    static_assert(Pack::once<Given...>, "watch is given a task twice");
    static_assert(director::given<Look, Given...>, "watch must be given its task Look");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (strategy.yaml:29)
/// - uses: KickTo
class KickToGoal::Default final : public director::Body<detail::Facts<KickToGoal::Default>> {
public:
  using director::Body<detail::Facts<KickToGoal::Default>>::Body;

  /// KickTo. (strategy.yaml:33)
  template <class... Given>
  director::Outcome shoot(Given... tasks) {
    using Pack = detail::Facts<KickToGoal::Default>::pack_shoot;
    static_assert(Pack::takes<Given...>, "shoot asks for KickTo only");
    static_assert(Pack::once<Given...>, "shoot is given a task twice");
    static_assert(director::given<KickTo, Given...>, "shoot must be given its task KickTo");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// Small steps close to the ball; the step back to long ones comes later than the step to small ones.
/// (strategy.yaml:38)
/// - when: Ball == near
/// - stay: Ball >= close
/// - triggers: Vision
class WalkToBall::Creeping final : public director::Body<detail::Facts<WalkToBall::Creeping>> {
public:
  using director::Body<detail::Facts<WalkToBall::Creeping>>::Body;

  /// WalkTo. (strategy.yaml:44)
  template <class... Given>
  director::Outcome creep(Given... tasks) {
    using Pack = detail::Facts<WalkToBall::Creeping>::pack_creep;
    static_assert(Pack::takes<Given...>, "creep asks for WalkTo only");
    static_assert(Pack::once<Given...>, "creep is given a task twice");
    static_assert(director::given<WalkTo, Given...>, "creep must be given its task WalkTo");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (strategy.yaml:45)
/// - when: Ball != lost
/// - triggers: Vision
class WalkToBall::Striding final : public director::Body<detail::Facts<WalkToBall::Striding>> {
public:
  using director::Body<detail::Facts<WalkToBall::Striding>>::Body;

  /// WalkTo. (strategy.yaml:49)
  template <class... Given>
  director::Outcome stride(Given... tasks) {
    using Pack = detail::Facts<WalkToBall::Striding>::pack_stride;
    static_assert(Pack::takes<Given...>, "stride asks for WalkTo only");
    static_assert(Pack::once<Given...>, "stride is given a task twice");
    static_assert(director::given<WalkTo, Given...>, "stride must be given its task WalkTo");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// Nobody knows where the ball is; turn on the spot until it comes into view. (strategy.yaml:50)
class WalkToBall::Searching final : public director::Body<detail::Facts<WalkToBall::Searching>> {
public:
  using director::Body<detail::Facts<WalkToBall::Searching>>::Body;

  /// Walk. (strategy.yaml:53)
  template <class... Given>
  director::Outcome turn(Given... tasks) {
    using Pack = detail::Facts<WalkToBall::Searching>::pack_turn;
    static_assert(Pack::takes<Given...>, "turn asks for Walk only");
    static_assert(Pack::once<Given...>, "turn is given a task twice");
    static_assert(director::given<Walk, Given...>, "turn must be given its task Walk");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (strategy.yaml:55)
/// - uses: WalkTo
class WalkToReady::Default final : public director::Body<detail::Facts<WalkToReady::Default>> {
public:
  using director::Body<detail::Facts<WalkToReady::Default>>::Body;

  /// WalkTo. (strategy.yaml:59)
  template <class... Given>
  director::Outcome go(Given... tasks) {
    using Pack = detail::Facts<WalkToReady::Default>::pack_go;
    static_assert(Pack::takes<Given...>, "go asks for WalkTo only");
    static_assert(Pack::once<Given...>, "go is given a task twice");
    static_assert(director::given<WalkTo, Given...>, "go must be given its task WalkTo");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (strategy.yaml:64)
/// - when: Ball != lost
/// - triggers: Vision
class Look::Tracking final : public director::Body<detail::Facts<Look::Tracking>> {
public:
  using director::Body<detail::Facts<Look::Tracking>>::Body;

  /// LookAt. (strategy.yaml:68)
  template <class... Given>
  director::Outcome track(Given... tasks) {
    using Pack = detail::Facts<Look::Tracking>::pack_track;
    static_assert(Pack::takes<Given...>, "track asks for LookAt only");
    static_assert(Pack::once<Given...>, "track is given a task twice");
    static_assert(director::given<LookAt, Given...>, "track must be given its task LookAt");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (strategy.yaml:69)
/// - triggers: every 600 ms
class Look::Sweeping final : public director::Body<detail::Facts<Look::Sweeping>> {
public:
  using director::Body<detail::Facts<Look::Sweeping>>::Body;

  /// LookAt. (strategy.yaml:72)
  template <class... Given>
  director::Outcome sweep(Given... tasks) {
    using Pack = detail::Facts<Look::Sweeping>::pack_sweep;
    static_assert(Pack::takes<Given...>, "sweep asks for LookAt only");
    static_assert(Pack::once<Given...>, "sweep is given a task twice");
    static_assert(director::given<LookAt, Given...>, "sweep must be given its task LookAt");
    return Body::ask<Pack, 0>(tasks...);
  }
};

/// (limbs.yaml:10)
class LeftArm::Default final : public director::Body<detail::Facts<LeftArm::Default>> {
public:
  using director::Body<detail::Facts<LeftArm::Default>>::Body;
};

/// (limbs.yaml:11)
class RightArm::Default final : public director::Body<detail::Facts<RightArm::Default>> {
public:
  using director::Body<detail::Facts<RightArm::Default>>::Body;
};

/// (limbs.yaml:12)
class Head::Default final : public director::Body<detail::Facts<Head::Default>> {
public:
  using director::Body<detail::Facts<Head::Default>>::Body;
};

/// (servos.yaml:10)
/// - uses: LeftHipYaw, LeftKnee, LeftAnkle
class LeftLeg::Default final : public director::Body<detail::Facts<LeftLeg::Default>> {
public:
  using director::Body<detail::Facts<LeftLeg::Default>>::Body;

  /// LeftHipYaw. (servos.yaml:15)
  template <class... Given>
  director::Outcome turn_hip(Given... tasks) {
    using Pack = detail::Facts<LeftLeg::Default>::pack_turn_hip;
    static_assert(Pack::takes<Given...>, "turn_hip asks for LeftHipYaw only");
    static_assert(Pack::once<Given...>, "turn_hip is given a task twice");
    static_assert(director::given<LeftHipYaw, Given...>, "turn_hip must be given its task LeftHipYaw");
    return Body::ask<Pack, 0>(tasks...);
  }

  /// LeftKnee. (servos.yaml:16)
  template <class... Given>
  director::Outcome bend_knee(Given... tasks) {
    using Pack = detail::Facts<LeftLeg::Default>::pack_bend_knee;
    static_assert(Pack::takes<Given...>, "bend_knee asks for LeftKnee only");
    static_assert(Pack::once<Given...>, "bend_knee is given a task twice");
    static_assert(director::given<LeftKnee, Given...>, "bend_knee must be given its task LeftKnee");
    return Body::ask<Pack, 1>(tasks...);
  }

  /// LeftAnkle. (servos.yaml:17)
  template <class... Given>
  director::Outcome set_foot(Given... tasks) {
    using Pack = detail::Facts<LeftLeg::Default>::pack_set_foot;
    static_assert(Pack::takes<Given...>, "set_foot asks for LeftAnkle only");
    static_assert(Pack::once<Given...>, "set_foot is given a task twice");
    static_assert(director::given<LeftAnkle, Given...>, "set_foot must be given its task LeftAnkle");
    return Body::ask<Pack, 2>(tasks...);
  }
};

/// (servos.yaml:18)
/// - uses: RightHipYaw, RightKnee, RightAnkle
class RightLeg::Default final : public director::Body<detail::Facts<RightLeg::Default>> {
public:
  using director::Body<detail::Facts<RightLeg::Default>>::Body;

  /// RightHipYaw. (servos.yaml:23)
  template <class... Given>
  director::Outcome turn_hip(Given... tasks) {
    using Pack = detail::Facts<RightLeg::Default>::pack_turn_hip;
    static_assert(Pack::takes<Given...>, "turn_hip asks for RightHipYaw only");
    static_assert(Pack::once<Given...>, "turn_hip is given a task twice");
    static_assert(director::given<RightHipYaw, Given...>, "turn_hip must be given its task RightHipYaw");
    return Body::ask<Pack, 0>(tasks...);
  }

  /// RightKnee. (servos.yaml:24)
  template <class... Given>
  director::Outcome bend_knee(Given... tasks) {
    using Pack = detail::Facts<RightLeg::Default>::pack_bend_knee;
    static_assert(Pack::takes<Given...>, "bend_knee asks for RightKnee only");
    static_assert(Pack::once<Given...>, "bend_knee is given a task twice");
    static_assert(director::given<RightKnee, Given...>, "bend_knee must be given its task RightKnee");
    return Body::ask<Pack, 1>(tasks...);
  }

  /// RightAnkle. (servos.yaml:25)
  template <class... Given>
  director::Outcome set_foot(Given... tasks) {
    using Pack = detail::Facts<RightLeg::Default>::pack_set_foot;
    static_assert(Pack::takes<Given...>, "set_foot asks for RightAnkle only");
    static_assert(Pack::once<Given...>, "set_foot is given a task twice");
    static_assert(director::given<RightAnkle, Given...>, "set_foot must be given its task RightAnkle");
    return Body::ask<Pack, 2>(tasks...);
  }
};

/// (servos.yaml:27)
class LeftHipYaw::Default final : public director::Body<detail::Facts<LeftHipYaw::Default>> {
public:
  using director::Body<detail::Facts<LeftHipYaw::Default>>::Body;
};

/// (servos.yaml:28)
class LeftKnee::Default final : public director::Body<detail::Facts<LeftKnee::Default>> {
public:
  using director::Body<detail::Facts<LeftKnee::Default>>::Body;
};

/// (servos.yaml:29)
class LeftAnkle::Default final : public director::Body<detail::Facts<LeftAnkle::Default>> {
public:
  using director::Body<detail::Facts<LeftAnkle::Default>>::Body;
};

/// (servos.yaml:30)
class RightHipYaw::Default final : public director::Body<detail::Facts<RightHipYaw::Default>> {
public:
  using director::Body<detail::Facts<RightHipYaw::Default>>::Body;
};

/// (servos.yaml:31)
class RightKnee::Default final : public director::Body<detail::Facts<RightKnee::Default>> {
public:
  using director::Body<detail::Facts<RightKnee::Default>>::Body;
};

/// (servos.yaml:32)
class RightAnkle::Default final : public director::Body<detail::Facts<RightAnkle::Default>> {
public:
  using director::Body<detail::Facts<RightAnkle::Default>>::Body;
};

// Modules: what the program implements

class Recovery {
public:
  virtual director::Outcome provide(Brace::Default& run) = 0;
  virtual director::Outcome provide(GetUp::Tucking& run) = 0;
  virtual director::Outcome provide(GetUp::Pushing& run) = 0;
  virtual director::Outcome provide(GetUp::Rising& run) = 0;

protected:
  ~Recovery() = default; // nobody deletes through this interface
};

class Safety {
public:
  virtual director::Outcome provide(FallRecovery::Recovering& run) = 0;
  virtual director::Outcome provide(FallRecovery::Protecting& run) = 0;
  virtual director::Outcome provide(FallRecovery::Watching& run) = 0;

protected:
  ~Safety() = default; // nobody deletes through this interface
};

class Locomotion {
public:
  virtual void start(Walk::Start& run) = 0;
  virtual void stop(Walk::Stop& run) = 0;
  virtual director::Outcome provide(Walk::Walking& run) = 0;
  virtual director::Outcome provide(Walk::Halting& run) = 0;

protected:
  ~Locomotion() = default; // nobody deletes through this interface
};

class Kicking {
public:
  virtual director::Outcome provide(Kick::Default& run) = 0;

protected:
  ~Kicking() = default; // nobody deletes through this interface
};

class Looking {
public:
  virtual director::Outcome provide(LookAt::Default& run) = 0;

protected:
  ~Looking() = default; // nobody deletes through this interface
};

class Planning {
public:
  virtual director::Outcome provide(WalkTo::Default& run) = 0;
  virtual director::Outcome provide(KickTo::Default& run) = 0;

protected:
  ~Planning() = default; // nobody deletes through this interface
};

class Strategy {
public:
  virtual director::Outcome provide(Striker::Playing& run) = 0;
  virtual director::Outcome provide(Striker::Ready& run) = 0;
  virtual director::Outcome provide(Striker::Waiting& run) = 0;
  virtual director::Outcome provide(KickToGoal::Default& run) = 0;
  virtual director::Outcome provide(WalkToBall::Creeping& run) = 0;
  virtual director::Outcome provide(WalkToBall::Striding& run) = 0;
  virtual director::Outcome provide(WalkToBall::Searching& run) = 0;
  virtual director::Outcome provide(WalkToReady::Default& run) = 0;
  virtual director::Outcome provide(Look::Tracking& run) = 0;
  virtual director::Outcome provide(Look::Sweeping& run) = 0;

protected:
  ~Strategy() = default; // nobody deletes through this interface
};

class Limbs {
public:
  virtual director::Outcome provide(LeftArm::Default& run) = 0;
  virtual director::Outcome provide(RightArm::Default& run) = 0;
  virtual director::Outcome provide(Head::Default& run) = 0;

protected:
  ~Limbs() = default; // nobody deletes through this interface
};

class Servos {
public:
  virtual director::Outcome provide(LeftLeg::Default& run) = 0;
  virtual director::Outcome provide(RightLeg::Default& run) = 0;
  virtual director::Outcome provide(LeftHipYaw::Default& run) = 0;
  virtual director::Outcome provide(LeftKnee::Default& run) = 0;
  virtual director::Outcome provide(LeftAnkle::Default& run) = 0;
  virtual director::Outcome provide(RightHipYaw::Default& run) = 0;
  virtual director::Outcome provide(RightKnee::Default& run) = 0;
  virtual director::Outcome provide(RightAnkle::Default& run) = 0;

protected:
  ~Servos() = default; // nobody deletes through this interface
};

namespace detail {
struct Bodies;
} // namespace detail

/// A striker that walks to the ball, stops softly, kicks, falls, gets up and plays on. (soccer.yaml:2)
/// Holds all memory of its own. The modules must live as long as it does. All that includes this header must be
/// compiled either with exceptions or without.
class Behaviour final : public director::Program<detail::Whole> {
public:
  Behaviour(
      Recovery& recovery, Safety& safety, Locomotion& locomotion, Kicking& kicking, Looking& looking,
      Planning& planning, Strategy& strategy, Limbs& limbs, Servos& servos, director::Observer observer = {});

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

  Recovery* recovery_;
  Safety* safety_;
  Locomotion* locomotion_;
  Kicking* kicking_;
  Looking* looking_;
  Planning* planning_;
  Strategy* strategy_;
  Limbs* limbs_;
  Servos* servos_;
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

} // namespace soccer
