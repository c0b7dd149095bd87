// SPDX-License-Identifier: MIT
// Times and durations at the limits of 64 bits, and of different types.
#include "night_watch.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace {

using namespace director;
using namespace std::chrono_literals;
using std::chrono::duration, std::chrono::microseconds;

struct RoundGuard final : night_watch::Guard {
  Outcome provide(night_watch::Round::Default& run) override {
    rounds.push_back(run.reasons());
    return on_round ? on_round(run) : run.keep();
  }
  Outcome provide(night_watch::Lamp::Default& run) override {
    lamps += 1;
    return run.keep();
  }
  Outcome provide(night_watch::Gate::Closing& run) override { return run.keep(); }
  Outcome provide(night_watch::Gate::Opening& run) override { return run.keep(); }
  Outcome provide(night_watch::Leave::Default& run) override { return run.keep(); }
  Outcome provide(night_watch::Sit::Default& run) override {
    broken += run.triggered<Broken<night_watch::Gate::Opening>>() ? 1 : 0;
    return run.request(night_watch::Gate{});
  }
  std::function<Outcome(night_watch::Round::Default&)> on_round;
  std::vector<Reasons> rounds;
  int lamps = 0, broken = 0;
};

struct Night {
  RoundGuard guard;
  night_watch::Behaviour behaviour{guard};

  std::int32_t noise() const { return behaviour.engine().value(0); }
  Time now() const { return behaviour.engine().now(); }
};

constexpr Time most = std::numeric_limits<Time>::max(), least = std::numeric_limits<Time>::min();

TEST_CASE("a clock of few bits that counts days moves time on") {
  const auto ends = [](auto far) {
    Night night;
    CHECK(night.behaviour.set(night_watch::Noise::loud));
    night.behaviour.step(decltype(far)(0));
    CHECK(night.noise() == 1);
    night.behaviour.step(far);
    CHECK(night.now() == std::chrono::duration_cast<duration<Time, std::micro>>(
                             duration<Time, typename decltype(far)::period>(static_cast<Time>(far.count())))
                             .count());
    CHECK(night.noise() == 0); // it expired
  };
  ends(duration<std::uint32_t, std::milli>(4'294'967'000U));
  ends(duration<std::int32_t, std::milli>(2'147'483'000));
  ends(duration<int>(2'000'000));
  ends(duration<std::int16_t, std::ratio<3600>>(32'000));
  ends(duration<std::uint8_t, std::ratio<60>>(std::uint8_t{255}));
  ends(duration<std::uint64_t>(4'000'000'000U));
}

TEST_CASE("a duration of any type becomes microseconds, and what is beyond 64 bits their end") {
  CHECK(microseconds_begun(duration<std::uint32_t, std::milli>(4'294'967'295U)) == 4'294'967'295'000);
  CHECK(microseconds_begun(std::chrono::hours::max()) == most);
  CHECK(microseconds_begun(std::chrono::hours::min()) == least);
  CHECK(microseconds_begun(microseconds::max()) == most);
  CHECK(microseconds_begun(std::chrono::nanoseconds::max()) == most / 1000);
  CHECK(director::microseconds(std::chrono::nanoseconds::max()) == most / 1000 + 1);
  CHECK(microseconds_begun(duration<std::uint64_t>::max()) == most);
  CHECK(microseconds_begun(duration<std::uint64_t, std::nano>::max()) == 18'446'744'073'709'551);
  CHECK(microseconds_begun(duration<std::uint64_t, std::micro>::max()) == most);
  CHECK(director::microseconds(duration<std::int8_t, std::nano>(1)) == 1);
  CHECK(microseconds_begun(duration<std::int8_t, std::nano>(127)) == 0);
  CHECK(microseconds_begun(duration<std::int8_t, std::milli>(-128)) == -128'000);
  // Frames of a camera, and a unit of which one is beyond the range of time.
  CHECK(microseconds_begun(duration<std::int32_t, std::ratio<1, 60>>(61)) == 1'016'666);
  CHECK(director::microseconds(duration<std::int32_t, std::ratio<1, 60>>(61)) == 1'016'667);
  CHECK(microseconds_begun(duration<Time, std::ratio<1, 60>>(most)) == most);
  CHECK(microseconds_begun(duration<int, std::exa>(1)) == most);
  CHECK(microseconds_begun(duration<int, std::exa>(-1)) == least);
  CHECK(microseconds_begun(duration<int, std::exa>(0)) == 0);
  CHECK(microseconds_begun(duration<Time, std::atto>(most)) == 9'223'372);
  CHECK(director::microseconds(duration<Time, std::atto>(1)) == 1);
  // Numbers with a fraction, and NaN.
  CHECK(microseconds_begun(duration<double>(1.5)) == 1'500'000);
  CHECK(microseconds_begun(duration<float, std::milli>(0.25F)) == 250);
  CHECK(director::microseconds(duration<double, std::micro>(0.25)) == 1);
  CHECK(microseconds_begun(duration<double>(1e300)) == most);
  CHECK(microseconds_begun(duration<double>(-1e300)) == least);
  CHECK(microseconds_begun(duration<double>(std::numeric_limits<double>::infinity())) == most);
  CHECK(microseconds_begun(duration<double>(std::numeric_limits<double>::quiet_NaN())) == least);
}

TEST_CASE("a wait of the longest duration never ends") {
  const auto waits_for_ever = [](auto longest) {
    Night night;
    night.guard.on_round = [&](night_watch::Round::Default& run) {
      run.wait(longest);
      return run.keep();
    };
    night.behaviour.request<night_watch::Round>();
    CHECK(night.behaviour.step(5s) == StepResult::quiescent);
    CHECK(night.behaviour.step(6s) == StepResult::quiescent);
    CHECK(night.behaviour.step(microseconds(most - 1)) == StepResult::quiescent);
    CHECK(night.behaviour.step(microseconds::max()) == StepResult::quiescent);
    CHECK(night.guard.rounds.size() == 1);
  };
  waits_for_ever(microseconds::max());
  waits_for_ever(std::chrono::hours::max());
  waits_for_ever(duration<double>(std::numeric_limits<double>::infinity()));
}

TEST_CASE("a wait of the longest duration takes the place of one that ends") {
  Night night;
  night.guard.on_round = [&](night_watch::Round::Default& run) {
    if (night.guard.rounds.size() == 1) run.wait(10ms);
    if (night.guard.rounds.size() == 2) run.wait(microseconds::max());
    return run.keep();
  };
  night.behaviour.request<night_watch::Round>();
  night.behaviour.step(0s);
  night.behaviour.request<night_watch::Round>();
  night.behaviour.step(1ms);
  night.behaviour.step(1s);
  CHECK(night.guard.rounds.size() == 2);
}

TEST_CASE("a step to the longest duration takes all that is due, and ends") {
  Night night;
  night.guard.on_round = [](night_watch::Round::Default& run) {
    if (run.reasons().has(Reason::new_task)) run.wait(24h);
    return run.keep();
  };
  CHECK(night.behaviour.set(night_watch::Noise::loud));
  night.behaviour.request<night_watch::Round, night_watch::Lamp>();
  CHECK(night.behaviour.step(0s) == StepResult::quiescent);
  CHECK(night.behaviour.step(microseconds::max()) == StepResult::quiescent);
  CHECK(night.noise() == 0);
  CHECK(night.guard.rounds.size() == 2);
  CHECK(night.guard.lamps == 2); // a period that is late runs once
  CHECK(night.now() == most - 1);
  CHECK(night.behaviour.step(microseconds::max()) == StepResult::quiescent);
  CHECK(night.guard.lamps == 2);
}

TEST_CASE("whatever begins shortly before the end of time is never due") {
  Night night;
  night.guard.on_round = [](night_watch::Round::Default& run) {
    run.wait(1s);
    return run.keep();
  };
  CHECK(night.behaviour.step(microseconds(most - 10)) == StepResult::quiescent);
  CHECK(night.behaviour.set(night_watch::Noise::loud));
  night.behaviour.request<night_watch::Round, night_watch::Lamp, night_watch::Sit, night_watch::Leave>();
  CHECK(night.behaviour.step(microseconds(most - 9)) == StepResult::quiescent);
  CHECK(night.behaviour.step(microseconds(most - 1)) == StepResult::quiescent);
  CHECK(night.noise() == 1);
  CHECK(night.guard.rounds.size() == 1);
  CHECK(night.guard.lamps == 1);
  CHECK(night.guard.broken == 0);
  CHECK(night.behaviour.engine().next_due() == never);
}

TEST_CASE("from the first moment to the last one, what is late runs once") {
  Night night;
  CHECK(night.behaviour.step(microseconds::min()) == StepResult::quiescent);
  CHECK(night.behaviour.set(night_watch::Noise::loud));
  night.behaviour.request<night_watch::Lamp, night_watch::Sit, night_watch::Leave>();
  CHECK(night.behaviour.step(microseconds(least + 1)) == StepResult::quiescent);
  CHECK(night.guard.lamps == 1);
  CHECK(night.behaviour.step(microseconds(most - 1)) == StepResult::quiescent);
  CHECK(night.guard.lamps == 2);
  CHECK(night.guard.broken == 1);
  CHECK(night.noise() == 0);
}

TEST_CASE("a time that goes backwards, or is no number, counts as the last one") {
  Night night;
  night.behaviour.request<night_watch::Lamp>();
  night.behaviour.step(100s);
  for (const microseconds earlier : {microseconds::min(), microseconds(0), microseconds(1)}) {
    CHECK(night.behaviour.step(earlier) == StepResult::quiescent);
    CHECK(night.now() == 100'000'000);
  }
  night.behaviour.step(duration<double>(std::numeric_limits<double>::quiet_NaN()));
  CHECK(night.now() == 100'000'000);
  CHECK(night.guard.lamps == 1);
}

} // namespace
