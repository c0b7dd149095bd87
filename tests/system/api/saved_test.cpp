// SPDX-License-Identifier: MIT
// The night watch saved and loaded: which timers continue, what is refused, and what is not called.
#include "night_watch.hpp"
#include "tests/support/numbers_of_event.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace director;
using namespace std::chrono_literals;
namespace watch = night_watch;
using Bytes = std::array<std::byte, watch::Behaviour::saved_bytes()>;

/// The lamp blinks by itself, the round looks again after three seconds, and Leave pushes the gate.
struct Guard final : watch::Guard {
  Outcome provide(watch::Round::Default& run) override {
    lines.push_back("round");
    run.wait(3s);
    return run.keep();
  }
  Outcome provide(watch::Lamp::Default& run) override {
    lines.push_back("lamp");
    return run.keep();
  }
  Outcome provide(watch::Leave::Default& run) override { return run.keep(); }
  Outcome provide(watch::Sit::Default& run) override {
    if (run.triggered<director::Broken<watch::Gate::Opening>>()) lines.push_back("broken");
    return run.request(watch::Gate{});
  }
  Outcome provide(watch::Gate::Closing& run) override { return run.keep(); }
  Outcome provide(watch::Gate::Opening& run) override { return run.keep(); }
  std::vector<std::string> lines;
};

TEST_CASE("what was due in three seconds is due in three seconds, at whatever time it is loaded") {
  for (const auto now :
       {std::chrono::microseconds(2s), std::chrono::microseconds(-5h), std::chrono::microseconds(1000h)}) {
    Guard guard;
    watch::Behaviour first{guard}, second{guard};
    first.request<watch::Round>();
    first.step(1s);
    first.step(2s);
    Bytes bytes;
    REQUIRE(first.save(bytes) == SaveResult::saved);
    REQUIRE(second.load(bytes, now) == LoadResult::loaded);
    CHECK(second.engine().now() == now.count());
    CHECK(second.engine().next_due() == (now + 2s).count());
    guard.lines.clear();
    second.step(now + 2s - 1us);
    CHECK(guard.lines.empty());
    second.step(now + 2s);
    CHECK(guard.lines == std::vector<std::string>{"round"});
  }
}

TEST_CASE("periods, promises and values that expire go on where they were") {
  Guard guard;
  watch::Behaviour first{guard}, second{guard};
  first.request<watch::Lamp>();
  first.request<watch::Sit>();
  first.step(0ms);
  CHECK(first.set(watch::Noise::loud)); // until 505 ms
  first.request<watch::Leave>();        // pushes the gate, which has 50 ms from here
  first.step(5ms);
  Bytes bytes;
  REQUIRE(first.save(bytes) == SaveResult::saved);
  REQUIRE(second.load(bytes, 1000ms) == LoadResult::loaded);
  CHECK(second.engine().value(0) == static_cast<std::int32_t>(watch::Noise::loud));
  guard.lines.clear();
  second.step(1005ms);
  CHECK(guard.lines == std::vector<std::string>{"lamp"});
  second.step(1050ms - 1us);
  guard.lines.clear();
  second.step(1050ms);
  CHECK(guard.lines == std::vector<std::string>{"broken"});
  second.step(1500ms - 1us);
  CHECK(second.engine().value(0) == static_cast<std::int32_t>(watch::Noise::loud));
  second.step(1500ms);
  CHECK(second.engine().value(0) == static_cast<std::int32_t>(watch::Noise::quiet));
}

TEST_CASE(
    "what waits in the inbox is not saved, and that is reported; in the object that loads it the inbox is unchanged") {
  Guard guard;
  watch::Behaviour first{guard}, second{guard};
  Bytes bytes;
  CHECK(first.save(bytes) == SaveResult::saved); // before the first step
  first.request<watch::Round>();                 // straight to the engine
  CHECK(first.save(bytes) == SaveResult::inputs_wait);
  first.step(0s);
  CHECK(first.save(bytes) == SaveResult::saved);
  first.post().request<watch::Lamp>(); // by the inbox
  CHECK(first.save(bytes) == SaveResult::inputs_wait);
  first.step(0s);
  while (first.post().enable<watch::Lamp::Default>(true)) {}
  first.post().cancel<watch::Lamp>(); // by its slot
  first.set_budget(1);
  while (first.step(0s) != StepResult::quiescent) {}
  CHECK(first.save(bytes) == SaveResult::saved);
  CHECK(first.lost() == 1);

  second.post().request<watch::Lamp>();
  REQUIRE(second.load(bytes, 0s) == LoadResult::loaded);
  CHECK(second.lost() == 0);
  CHECK(second.state<watch::Round>() == RunState::running);
  CHECK(second.state<watch::Lamp>() == RunState::none);
  second.step(0s);
  CHECK(second.state<watch::Lamp>() == RunState::running);
}

TEST_CASE("a span that is too small, or bytes of another behaviour, are refused, and nothing changes") {
  Guard guard;
  watch::Behaviour first{guard}, second{guard};
  Bytes bytes{};
  CHECK(first.save(std::span(bytes).first(bytes.size() - 1)) == SaveResult::too_small);
  CHECK(bytes == Bytes{});
  first.request<watch::Round>();
  first.step(0s);
  std::vector<std::byte> page(bytes.size() + 100); // a page of flash may be larger
  REQUIRE(first.save(page) == SaveResult::saved);
  const auto refused = [&](std::span<const std::byte> from, LoadResult why) {
    CHECK(second.load(from, 0s) == why);
    CHECK(second.state<watch::Round>() == RunState::none);
  };
  refused(std::span(page).first(bytes.size() - 1), LoadResult::truncated);
  refused({}, LoadResult::truncated);
  page[bytes.size() / 2] ^= std::byte{16};
  refused(page, LoadResult::damaged);
  page[bytes.size() / 2] ^= std::byte{16};
  page[9] ^= std::byte{1}; // of the size, which is more than there is now
  refused(page, LoadResult::damaged);
  page[9] ^= std::byte{1};
  page[12] ^= std::byte{1}; // of the fingerprint
  saved::seal(std::span(page).first(bytes.size()));
  refused(page, LoadResult::other_behaviour);
  page[12] ^= std::byte{1};
  page[2] ^= std::byte{3}; // the format
  refused(page, LoadResult::other_version);
  page[2] ^= std::byte{3};
  saved::seal(std::span(page).first(bytes.size()));
  CHECK(second.load(page, 0s) == LoadResult::loaded);
}

/// The night watch with a range of its own.
struct Ranged {
  using Data = watch::detail::Whole::Data;
  using Groups = watch::detail::Whole::Groups;
  struct States {
    static inline std::array<Domain, 1> domains{{{.low = 0, .high = 9}}};
  };
  static std::uint64_t fingerprint() { return 1; }
};

TEST_CASE("a behaviour whose state has another range is another one") {
  const std::uint64_t before = saved::Data<Ranged>::fingerprint();
  Ranged::States::domains[0].high = 5;
  CHECK(saved::Data<Ranged>::fingerprint() != before);
}

TEST_CASE("a value that its state does not declare is refused, even with a valid check sum") {
  Guard guard;
  watch::Behaviour behaviour{guard};
  Bytes bytes;
  REQUIRE(behaviour.save(bytes) == SaveResult::saved);
  const saved::Layout at(Shape::of(behaviour.engine().tables()));
  for (const std::int32_t value : {2, -1, 77, unset}) {
    auto row = saved::read<saved::StateRow>(bytes.data() + at.states, 0);
    const std::int32_t before = std::exchange(row.value, value);
    saved::write(bytes.data() + at.states, 0, row);
    saved::seal(bytes);
    CHECK(behaviour.load(bytes, 0s) == LoadResult::impossible);
    row.value = before;
    saved::write(bytes.data() + at.states, 0, row);
  }
  saved::seal(bytes);
  CHECK(behaviour.load(bytes, 0s) == LoadResult::loaded);
}

TEST_CASE("each answer has a line of its own") {
  std::vector<std::string> lines;
  for (int i = 0; i <= static_cast<int>(SaveResult::refused); ++i) lines.push_back(to_text(static_cast<SaveResult>(i)));
  for (int i = 0; i <= static_cast<int>(LoadResult::refused); ++i) lines.push_back(to_text(static_cast<LoadResult>(i)));
  CHECK(lines ==
        std::vector<std::string>{
            "saved", "not saved: the span is smaller than Behaviour::saved_bytes()",
            "not saved: inputs wait in the inbox; call step() first, and post nothing until the state is saved",
            "not saved: called from inside a body, handler or observer; save between two calls of step()", "loaded",
            "not loaded: bytes are missing at the end; give all that save() wrote",
            "not loaded: no saved state, or one of another version of Director, another byte order or another "
            "DIRECTOR_SMALL_INDEX; save it again with this program",
            "not loaded: the check sum does not fit, the bytes have changed since they were saved",
            "not loaded: saved by another behaviour, by another version of it, or with data of other types; save "
            "it again with this program",
            "not loaded: the behaviour cannot be in such a state, the bytes were not made by save()",
            "not loaded: called from inside a body, handler or observer; load between two calls of step()"});
}

} // namespace
