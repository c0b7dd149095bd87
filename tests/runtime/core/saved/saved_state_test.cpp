// SPDX-License-Identifier: MIT
// The numbers of a saved state that are refused. That a state is continued correctly: tests/property/saved_test.cpp.
#include "runtime/core/inspect/view.hpp"
#include "runtime/core/saved/saved_rows.hpp"
#include "runtime/core/saved/saved_state.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

#include <cstring>
#include <string_view>

namespace director::tests {
namespace {

using namespace saved;

/// Lift is pushed to sinking, because Kneel waits for it; Arm has two providers, each of which needs a joint.
constexpr const char* crane =
    "{behaviour: b, language: 1, states: {Hook: {values: [high, low], initial: high}, Wind: {values: [calm, storm], "
    "initial: calm, "
    "external: true, expires: {after: 1 s, to: calm}}}, triggers: [Bell],"
    " roots: {Lift: {priority: {low: 1, high: 5}}, Kneel: {priority: 9}, Clock: {}},"
    " groups: {Lift: {providers: [{name: lifting, needs: [Arm], tasks: [Arm]},"
    "   {name: sinking, needs: [Arm], causing: [Hook == low within 2 s], tasks: [Arm]}]},"
    "  Kneel: {when: [Hook == low], needs: [Arm], tasks: [Arm]},"
    "  Arm: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}, Left: {}, Right: {},"
    "  Clock: {every: 100 ms, triggers: [Bell]}}}";

constexpr std::uint64_t fingerprint = 42;

struct Saved {
  Saved() : machine(crane), shape(Shape::of(machine.tables())), at(shape), bytes(saved_bytes(shape)) {
    machine.request("Lift");
    machine.request("Clock");
    machine.step(0);
    machine.request("Kneel");
    machine.set("Wind", "storm");
    machine.step(10);
    REQUIRE(save(machine.engine(), bytes, fingerprint) == SaveResult::saved);
  }
  LoadResult load() {
    seal(bytes);
    return director::load(machine.engine(), bytes, 10, fingerprint);
  }
  template <class Row, class Change>
  LoadResult with(std::size_t begin, std::size_t row, Change change) {
    const std::vector<std::byte> before = bytes;
    auto other = read<Row>(bytes.data() + begin, row);
    change(other);
    write(bytes.data() + begin, row, other);
    const LoadResult result = load();
    bytes = before;
    return result;
  }
  LoadResult with_group(const char* name, void (*change)(GroupRow&)) {
    return with<GroupRow>(at.groups, machine.group(name), change);
  }
  LoadResult with_edge(const char* name, void (*change)(EdgeRow&)) {
    return with<EdgeRow>(at.edges, machine.edge(name), change);
  }

  Machine machine;
  const Shape shape;
  const Layout at;
  std::vector<std::byte> bytes;
};

TEST_CASE("the check sum is that of zlib") {
  const std::string_view text = "123456789";
  CHECK(check_sum(std::as_bytes(std::span(text))) == 0xCBF43926);
}

TEST_CASE("a saved state is as long as the sum of its rows, and has a version, its length and the behaviour at its "
          "beginning") {
  Saved saved;
  const auto head = read<HeadRow>(saved.bytes.data(), 0);
  CHECK(head.version == version_word);
  CHECK(head.size == saved.bytes.size());
  CHECK(head.behaviour == fingerprint);
  CHECK(head.check_sum == check_sum(std::span(saved.bytes).subspan(8)));
  CHECK(saved.load() == LoadResult::loaded);
}

TEST_CASE("a loaded state is equal to the saved one, and leads to the same explanations") {
  Saved saved;
  Machine other(crane);
  REQUIRE(load(other.engine(), saved.bytes, 10, fingerprint) == LoadResult::loaded);
  for (Index e = 0; e < other.tables().edges.size(); ++e) {
    CHECK(other.engine().queued(e) == saved.machine.engine().queued(e));
    CHECK(other.engine().state(e) == saved.machine.engine().state(e));
  }
  CHECK(other.engine().in_force(other.group("Lift")));
  CHECK(other.engine().next_due() == saved.machine.engine().next_due());
  for (Machine* each : {&saved.machine, &other}) each->set("Wind", "storm");
  CHECK(other.step(2'000'009) == saved.machine.step(2'000'009));
  CHECK(other.step(2'000'010) == saved.machine.step(2'000'010)); // the promise is broken
}

TEST_CASE("a load is seen in the number of passes, though the number of the micro-step may be the same") {
  Saved saved;
  const View before = view_of(saved.machine.engine());
  REQUIRE(saved.load() == LoadResult::loaded);
  const View after = view_of(saved.machine.engine());
  CHECK(after.micro_step == before.micro_step);
  CHECK(after.passes > before.passes);
}

TEST_CASE("a number of a row that does not exist, or is not allowed there, is refused") {
  Saved saved;
  const auto impossible = LoadResult::impossible;
  // Of a group: its holder, provider, plan and push.
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.holder = 99; }) == impossible);
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.holder = 0; }) == impossible); // an edge to another group
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.active = 0; }) == impossible);
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.active = 99; }) == impossible);
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.planned = 99; }) == impossible);
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.active = nil; }) == impossible); // it is granted
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.flags = 64; }) == impossible);
  CHECK(saved.with_group("Lift", [](GroupRow& row) { row.push = {}; }) == impossible); // it is in force
  CHECK(saved.with_group("Lift", [](GroupRow& row) { row.push.edge = 99; }) == impossible);
  CHECK(saved.with_group("Lift", [](GroupRow& row) { row.push.provider = nil; }) == impossible);
  CHECK(saved.with_group("Lift", [](GroupRow& row) { row.push.condition = nil; }) == impossible);
  // Its runs and timers.
  CHECK(saved.with_group("Left", [](GroupRow& row) { row.queue_place = 0; }) == impossible);  // it is not granted
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.queue_place = 0; }) == impossible); // it has no reason
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.queue_place = 1, row.pending = 1; }) ==
        impossible); // two of one place
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.pending = 32; }) == impossible);
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.done = 2; }) == impossible);
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.stale_matters = 2; }) == impossible);
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.data_from = 0; }) == impossible);
  CHECK(saved.with_group("Clock", [](GroupRow& row) { row.promised = {0, 0}; }) == impossible);
  CHECK(saved.with_group("Lift", [](GroupRow& row) { row.promised.edge = nil; }) == impossible);
  CHECK(saved.with_group("Arm", [](GroupRow& row) { row.every = 5; }) == impossible); // no provider has a period
  CHECK(saved.with_group("Left", [](GroupRow& row) {
    row.wait = 5;
    row.holder = row.active = nil;
  }) == impossible);
  // Numbers of an edge.
  CHECK(saved.with_edge("root>Lift", [](EdgeRow& row) { row.level = 99; }) == impossible);
  CHECK(saved.with_edge("root>Lift", [](EdgeRow& row) { row.stamp = 99; }) == impossible);
  CHECK(saved.with_edge("root>Lift", [](EdgeRow& row) { row.level = nil; }) == impossible); // its target is granted
  CHECK(saved.with_edge("root>Kneel", [](EdgeRow& row) { row.why = Why{9}; }) == impossible);
  CHECK(saved.with_edge("root>Kneel", [](EdgeRow& row) { row.condition = nil; }) ==
        impossible); // it waits for a condition
  CHECK(saved.with_edge("root>Kneel", [](EdgeRow& row) { row.condition = 99; }) == impossible);
  // Other numbers.
  CHECK(saved.with<StateRow>(saved.at.states, 0, [](StateRow& row) { row.expiry = 5; }) ==
        impossible); // it does not expire
  CHECK(saved.with<StateRow>(saved.at.states, 1, [](StateRow& row) { row.by_handler = 0; }) == impossible);
  CHECK(saved.with<EnabledRow>(saved.at.providers, 1, [](EnabledRow& row) { row.set = 2; }) == impossible);
  CHECK(saved.with<FiredRow>(saved.at.listens, 0, [](FiredRow& row) { row.set = 2; }) == impossible);
  CHECK(saved.with<ComponentRow>(saved.at.components, 0, [](ComponentRow& row) { row.bits = 32; }) == impossible);
  CHECK(saved.with<ComponentRow>(saved.at.components, 0, [](ComponentRow& row) { row.work_place = 1; }) == impossible);
  CHECK(saved.with<HeadRow>(0, 0, [](HeadRow& row) { row.begun = 2; }) == impossible);
  CHECK(saved.with<HeadRow>(0, 0, [](HeadRow& row) { row.now = 11; }) == impossible); // later than the time of the step
  CHECK(saved.with<HeadRow>(0, 0, [](HeadRow& row) { row.until = never; }) == impossible);
  CHECK(saved.load() == LoadResult::loaded); // unchanged, it is loaded
}

TEST_CASE("a plan that lacks a provider, and a wrong length, are refused") {
  Saved saved;
  REQUIRE(saved.shape.plan_slots > 0);
  bool refused = false;
  for (std::size_t slot = 0; slot < saved.shape.plan_slots; ++slot) {
    refused = refused || saved.with<PlanRow>(saved.at.plan, slot, [](PlanRow& row) { row.provider = nil; }) ==
                             LoadResult::impossible;
    CHECK(saved.with<PlanRow>(saved.at.plan, slot, [](PlanRow& row) { row.provider = 99; }) == LoadResult::impossible);
  }
  CHECK(refused); // in one of the plans
  CHECK(saved.with<HeadRow>(0, 0, [](HeadRow& row) { row.size = 4; }) == LoadResult::damaged);
  saved.bytes.push_back(std::byte{0});
  auto head = read<HeadRow>(saved.bytes.data(), 0);
  ++head.size;
  write(saved.bytes.data(), 0, head);
  CHECK(saved.load() == LoadResult::impossible);
}

TEST_CASE("holders that hold each other are refused") {
  Machine machine("{behaviour: b, language: 1, roots: {A: {}, B: {}}, groups: {A: {tasks: [B]}, B: {tasks: [A]}}}");
  std::vector<std::byte> bytes(saved_bytes(Shape::of(machine.tables())));
  machine.request("A");
  machine.step();
  REQUIRE(save(machine.engine(), bytes, fingerprint) == SaveResult::saved);
  const Layout at(Shape::of(machine.tables()));
  for (const char* const edge : {"A>B", "B>A"}) {
    const Index target = machine.tables().edges[machine.edge(edge)].target;
    auto row = read<GroupRow>(bytes.data() + at.groups, target);
    row.holder = machine.edge(edge);
    row.flags = 0;
    row.queue_place = nil;
    write(bytes.data() + at.groups, target, row);
  }
  seal(bytes);
  CHECK(load(machine.engine(), bytes, 0, fingerprint) == LoadResult::impossible);
}

TEST_CASE("nothing is saved or loaded from inside a body, and a time behind the last one is the last one") {
  Saved saved;
  SaveResult result = SaveResult::saved;
  LoadResult loaded = LoadResult::loaded;
  saved.machine.body("Clock", [&](Run& run) {
    result = save(saved.machine.engine(), saved.bytes, fingerprint);
    loaded = director::load(saved.machine.engine(), saved.bytes, 0, fingerprint);
    return run.keep();
  });
  saved.machine.step(100'000);
  CHECK(result == SaveResult::refused);
  CHECK(loaded == LoadResult::refused);
  REQUIRE(director::load(saved.machine.engine(), saved.bytes, never, fingerprint) == LoadResult::loaded);
  CHECK(saved.machine.engine().now() == last_time);
  CHECK(saved.machine.engine().next_due() == last_time); // it is armed, at the last time
}

} // namespace
} // namespace director::tests
