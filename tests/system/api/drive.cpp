// Header: tests/system/api/drive.hpp. Test: tests/system/api/drive_test.cpp, tests/system/threads/drive.cpp.
// SPDX-License-Identifier: MIT
#include "tests/system/api/drive.hpp"

#include <chrono>
#include <limits>
#include <tuple>

namespace director::tests {

namespace {

namespace watch = night_watch;
using property::Random;
using std::chrono::duration, std::chrono::microseconds;

struct Thrown {};

constexpr Time most = std::numeric_limits<Time>::max(), least = std::numeric_limits<Time>::min();

/// Over all that 64 bits hold where it is `far`, and often at an end; else mostly a little behind `now`.
Time any_time(Random& random, Time now, bool far) {
  const auto bits = static_cast<Time>(random.next() >> random.below(64));
  if (!far) return random.chance(0.1) ? now - random.between(0, 100'000) : later(now, random.between(0, 100'000));
  switch (random.below(8)) {
  case 0: return random.one_of({least, least + 1, most, most - 1, Time{0}});
  case 1: return bits;
  case 2: return -bits;
  case 3: return most - static_cast<Time>(random.below(1'000'000));
  default: return later(now, static_cast<Time>(random.below(200'000)));
  }
}

/// Calls use(duration) with a duration of one of many types.
template <class Use>
auto with_duration(Random& random, Time time, Use use) {
  const auto small = static_cast<std::int32_t>(random.next());
  switch (random.below(10)) {
  case 0: return use(duration<std::int32_t, std::milli>(small));
  case 1: return use(duration<std::uint32_t, std::milli>(static_cast<std::uint32_t>(small)));
  case 2: return use(duration<double>(static_cast<double>(time)));
  case 3: return use(duration<Time, std::ratio<3600>>(time));
  case 4: return use(duration<std::uint64_t, std::nano>(static_cast<std::uint64_t>(time)));
  default: return use(microseconds(time));
  }
}

} // namespace

struct Drive::Parts {
  Parts(std::uint64_t seed, bool by_itself)
      : random(seed),
        alone(by_itself),
        plans(*this),
        skills(*this),
        guard(*this) {}

  // Further actions of bodies and handlers.

  void complain(const char* what) {
    if (wrong.empty()) wrong = what;
  }
  /// In a body, handler or observer of the behaviour: it must refuse.
  void call_from_inside(courier::Behaviour& behaviour) {
    const bool refused = random.chance(0.5) ? behaviour.step(microseconds(0)) == StepResult::refused
                                            : !behaviour.set(courier::Battery{3}) && !behaviour.fire<courier::Bell>() &&
                                                  !behaviour.request<courier::Rest>() && !behaviour.cancel_all() &&
                                                  !behaviour.enable<courier::Rest::Default>(false);
    if (!refused) complain("a call from inside was not refused");
    std::ignore = behaviour.state<courier::Rest>();
    std::ignore = behaviour.holding<courier::Walk>();
  }
  void call_from_inside(watch::Behaviour& behaviour) {
    const bool refused = random.chance(0.5) ? behaviour.step(microseconds(0)) == StepResult::refused
                                            : !behaviour.set(watch::Noise::loud) && !behaviour.cancel<watch::Lamp>() &&
                                                  behaviour.save(saved) == SaveResult::refused &&
                                                  behaviour.load(saved, microseconds(0)) == LoadResult::refused;
    if (!refused) complain("a call from inside was not refused");
    std::ignore = behaviour.state<watch::Lamp>();
  }
  void throw_sometimes(double chance) {
    if (!calm && random.chance(chance)) throw Thrown{};
  }
  void misbehave(bool of_office) {
    if (calm) return;
    if (random.chance(0.1)) of_office ? call_from_inside(office) : call_from_inside(night);
    if (random.chance(0.1)) post_something(random);
    if (random.chance(0.02)) of_office ? step(night) : step(office); // unless that one called this one
    throw_sometimes(0.05);
  }
  template <class Context>
  void wait_sometimes(Context& run) {
    if (calm || !random.chance(0.3)) return;
    with_duration(random, any_time(random, 0, random.chance(0.2)), [&](auto time) { run.wait(time); });
  }
  /// Answers that every body may give.
  template <class Context>
  Outcome plain(Context& run) {
    if (calm) return run.keep();
    switch (random.below(4)) {
    case 0: return run.done();
    case 1: return run.fail();
    default: return run.keep();
    }
  }
  courier::Walk walk() { return courier::Walk{post::Steps{random.between(0, 9)}}; }

  struct WildPlans final : courier::Plans {
    explicit WildPlans(Parts& of) : all(of) {}
    Outcome provide(courier::Deliver::Default& run) override {
      all.tallies[0].runs += 1;
      if (run.task().weight == nullptr || *run.task().weight != 42) all.complain("the data of a task are not whole");
      all.wait_sometimes(run);
      all.misbehave(true);
      switch (all.calm ? 9 : all.random.below(5)) {
      case 0: return run.carry(all.walk());
      case 1: return run.carry(all.walk(), courier::Sing{});
      case 2: return run.enter(courier::Open{}, director::keep(all.walk()));
      case 3: return run.nothing();
      default: return all.plain(run);
      }
    }
    Outcome provide(courier::Rest::Default& run) override {
      all.tallies[0].runs += 1;
      all.wait_sometimes(run);
      all.misbehave(true);
      switch (all.calm ? 9 : all.random.below(4)) {
      case 0: return run.request(all.walk());
      case 1: return run.request(all.walk(), courier::Sing{});
      case 2: return run.request();
      default: return all.plain(run);
      }
    }
    Parts& all;
  };

  struct WildSkills final : courier::Skills {
    explicit WildSkills(Parts& of) : all(of) {}
    void start(courier::Walk::Start& run) override {
      if (walks) all.complain("what walks is started");
      walks = true;
      run.set(courier::Door::shut);
      all.misbehave(true);
    }
    void stop(courier::Walk::Stop& run) override {
      if (!walks) all.complain("what does not walk is stopped");
      if (run.task().count < 0 || run.task().count > 9) all.complain("the data of a task are not whole");
      walks = false;
      run.set(courier::Door::shut);
      all.misbehave(true);
    }
    Outcome provide(courier::Walk::Default& run) override {
      all.tallies[0].runs += 1;
      if (!walks) all.complain("what does not walk runs");
      if (run.task().count < 0 || run.task().count > 9) all.complain("the data of a task are not whole");
      std::ignore = run.try_set(courier::Battery{all.random.between(-20, 120)});
      all.wait_sometimes(run);
      all.misbehave(true);
      return all.plain(run);
    }
    Outcome provide(courier::Open::Passing& run) override {
      all.tallies[0].runs += 1;
      all.misbehave(true);
      return all.plain(run);
    }
    Outcome provide(courier::Open::Unlocking& run) override {
      all.tallies[0].runs += 1;
      if (all.random.chance(0.3)) run.set(courier::Door::open);
      all.misbehave(true);
      return all.plain(run);
    }
    Outcome provide(courier::Sing::Default& run) override {
      all.tallies[0].runs += 1;
      all.misbehave(true);
      return all.plain(run);
    }
    Parts& all;
    bool walks = false;
  };

  struct WildGuard final : watch::Guard {
    explicit WildGuard(Parts& of) : all(of) {}
    template <class Context>
    Outcome something(Context& run) {
      all.tallies[1].runs += 1;
      all.wait_sometimes(run);
      all.misbehave(false);
      return all.plain(run);
    }
    Outcome provide(watch::Round::Default& run) override { return something(run); }
    Outcome provide(watch::Lamp::Default& run) override { return something(run); }
    Outcome provide(watch::Leave::Default& run) override { return something(run); }
    Outcome provide(watch::Sit::Default& run) override {
      if (!all.calm && all.random.chance(0.5)) return run.request(watch::Gate{});
      return something(run);
    }
    Outcome provide(watch::Gate::Closing& run) override {
      if (all.random.chance(0.5)) run.set(watch::Bolt::shut);
      return something(run);
    }
    Outcome provide(watch::Gate::Opening& run) override {
      if (all.random.chance(0.3)) run.set(watch::Bolt::open);
      return something(run);
    }
    Parts& all;
  };

  // Observers.

  void hear(std::size_t which, const Event& event) {
    Tally& tally = tallies[which];
    if (event.kind == Event::Kind::lost) tally.lost += event.count;
    if (event.kind == Event::Kind::input && event.input == Event::Input::fire) tally.heard += 1;
    if (calm) return;
    if (random.chance(0.01)) which == 0 ? call_from_inside(office) : call_from_inside(night);
    if (random.chance(0.01)) post_something(random);
    throw_sometimes(0.01);
  }
  static void hear_office(void* self, const Event& event) { static_cast<Parts*>(self)->hear(0, event); }
  static void hear_night(void* self, const Event& event) { static_cast<Parts*>(self)->hear(1, event); }

  // Actions of the program.

  template <class Behaviour>
  void step(Behaviour& behaviour) {
    if (behaviour.engine().inside()) return;
    try {
      const Time time = any_time(random, behaviour.engine().now(), far);
      const StepResult result = far ? with_duration(random, time, [&](auto now) { return behaviour.step(now); })
                                    : behaviour.step(microseconds(time));
      if (result == StepResult::quiescent) rested(behaviour.engine().now(), &behaviour == static_cast<void*>(&night));
    } catch (const Thrown&) {}
  }

  /// At rest its time is that of the last step; before, it may be that of what was due earlier.
  void rested(Time now, bool is_night) {
    if (now < last_rest[is_night ? 1 : 0]) complain("time went backwards");
    last_rest[is_night ? 1 : 0] = now;
  }

  void post_something(Random& draw) {
    const courier::Behaviour::Post to = office.post();
    const watch::Behaviour::Post there = night.post();
    switch (draw.below(14)) {
    case 0: return std::ignore = to.set(courier::Battery{draw.between(-10, 100)}), void();
    case 1: return std::ignore = to.set(draw.one_of({post::Mood::calm, post::Mood::hurried})), void();
    case 2: return std::ignore = to.set(post::Mood::calm, courier::Battery{draw.between(-10, 100)}), void();
    case 3: return std::ignore = to.set_row(static_cast<Index>(draw.below(4)), draw.between(-20, 120)), void();
    case 4: tallies[0].fired += to.fire<courier::Bell>() ? 1U : 0U; return;
    case 5: to.request(courier::Deliver{{std::make_unique<int>(42)}}); return;
    case 6:
      to.request(courier::Deliver{{std::make_unique<int>(42)}, courier::Deliver::urgent}, courier::Rest{});
      return;
    case 7: to.request<courier::Rest>(); return;
    case 8: draw.chance(0.5) ? to.cancel<courier::Rest>() : to.cancel<courier::Deliver>(); return;
    case 9: draw.chance(0.5) ? to.cancel_all() : there.cancel_all(); return;
    case 10: return std::ignore = to.enable<courier::Open::Passing>(draw.chance(0.7)), void();
    case 11: return std::ignore = there.set(draw.one_of({watch::Noise::quiet, watch::Noise::loud})), void();
    case 12: there.request<watch::Lamp, watch::Leave>(); return;
    default: there.request<watch::Round, watch::Sit>(); return;
    }
  }

  void flood() {
    for (int i = random.between(0, 80); i > 0; --i) {
      const bool room = office.post().fire<courier::Bell>();
      tallies[0].fired += room ? 1U : 0U;
    }
  }

  void look() {
    if (!office.show(snapshot) && alone) complain("a snapshot nobody looks at could not be renewed");
    const auto seen = snapshot.look();
    if (!seen) return;
    char buffer[200];
    std::ignore = courier::names::why((*seen).why<courier::Walk>(), buffer);
    std::ignore = (*seen).holding<courier::Walk>();
  }

  void set_several() {
    std::ignore = office.set(courier::Battery{random.between(-20, 120)}, post::Mood::hurried);
    std::ignore = office.set(courier::Battery{random.between(-20, 120)});
    std::ignore = night.set(watch::Noise::loud);
    std::ignore = office.enable<courier::Open::Unlocking>(random.chance(0.8));
    office.request(courier::Deliver{{std::make_unique<int>(42)}});
  }

  /// It continues from its saved state, at another time.
  void save_and_load() {
    const SaveResult result = night.save(saved);
    if (result == SaveResult::inputs_wait) return;
    if (result != SaveResult::saved) complain("what is between steps could not be saved");
    if (night.load(saved, microseconds(any_time(random, night.engine().now(), far))) != LoadResult::loaded)
      complain("what was saved could not be loaded");
    last_rest[1] = least;
  }

  void turn() {
    switch (random.below(13)) {
    case 0: return flood();
    case 1: return look();
    case 2: return set_several();
    case 3:
      office.set_budget(static_cast<std::uint32_t>(random.between(0, 60)));
      office.set_work_budget(static_cast<std::uint64_t>(random.between(0, 40)));
      return night.set_budget(static_cast<std::uint32_t>(random.between(0, 60)));
    case 4:
    case 5:
    case 6: return post_something(random);
    case 7: return step(night);
    case 8: return save_and_load();
    default: return step(office);
    }
  }

  /// Everything is cancelled; it must come to rest, and stay at rest.
  template <class Behaviour>
  void bring_to_rest(Behaviour& behaviour, std::size_t which) {
    behaviour.set_budget(Engine::default_budget);
    behaviour.set_work_budget(0);
    behaviour.cancel_all();
    int steps = 0;
    while (behaviour.step(microseconds(behaviour.engine().now())) != StepResult::quiescent) {
      if (++steps == 100) return complain("what is cancelled does not come to rest");
    }
    const std::uint64_t runs = tallies[which].runs, micro_steps = behaviour.engine().micro_steps();
    if (behaviour.step(microseconds(most)) != StepResult::quiescent) complain("the end of time does not come to rest");
    if (tallies[which].runs != runs) complain("what was cancelled runs");
    if (behaviour.step(microseconds(most)) != StepResult::quiescent) complain("what is at rest does not rest");
    if (behaviour.engine().micro_steps() > micro_steps + 8) complain("what is at rest goes on");
    if (tallies[which].lost != behaviour.lost()) complain("the observer was told of another number of lost inputs");
    if (tallies[which].heard != tallies[which].fired) complain("what was accepted was not taken, or twice");
  }

  Random random;
  const bool alone;
  const bool far = random.chance(0.3); ///< time leaps
  bool calm = false;
  std::string wrong;
  Tally tallies[2];
  Time last_rest[2] = {least, least};
  WildPlans plans;
  WildSkills skills;
  WildGuard guard;
  courier::Behaviour office{plans, skills, {&hear_office, this}};
  watch::Behaviour night{guard, {&hear_night, this}};
  courier::Behaviour::Snapshot snapshot;
  std::array<std::byte, watch::Behaviour::saved_bytes()> saved;
};

Drive::Drive(std::uint64_t seed, bool alone) : parts_(std::make_unique<Parts>(seed, alone)) {}
Drive::~Drive() = default;

std::string Drive::wrong() const { return parts_->wrong; }

void Drive::go_on(int turns) {
  for (int i = 0; i < turns && parts_->wrong.empty(); ++i) parts_->turn();
}

void Drive::end() {
  if (!parts_->wrong.empty()) return;
  parts_->calm = true;
  parts_->bring_to_rest(parts_->office, 0);
  parts_->bring_to_rest(parts_->night, 1);
  if (parts_->skills.walks) parts_->complain("what is cancelled walks");
}

bool Drive::disturb(property::Random& random) {
  parts_->post_something(random);
  const auto seen = parts_->snapshot.look();
  if (!seen) return false;
  return ((*seen).state<courier::Deliver>() == RunState::running) != ((*seen).holding<courier::Deliver>().granted);
}

} // namespace director::tests
