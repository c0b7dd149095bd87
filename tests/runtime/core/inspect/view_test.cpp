// SPDX-License-Identifier: MIT
#include "runtime/core/inspect/view.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace director::tests {
namespace {

TEST_CASE("a copy of a view is equal to the view when it was made") {
  Machine machine("{behaviour: b, language: 1, states: {S: {values: [x, y], external: true}}, roots: {A: {}},"
                  " groups: {A: {needs: [B], tasks: {B: {}}}, B: {}}}");
  machine.request("A");
  machine.step();
  const Shape shape = Shape::of(machine.tables());
  std::vector<std::uint64_t> buffer(View::bytes(shape) / sizeof(std::uint64_t));
  const View then = view_of(machine.engine()).copy(reinterpret_cast<std::byte*>(buffer.data()));
  machine.cancel("A");
  machine.set("S", "y");
  machine.step(7);
  const View now = view_of(machine.engine());
  const Index b = machine.group("B"), root = machine.edge("root>A");
  CHECK(then.holding(b).group == machine.group("A"));
  CHECK(now.holding(b) == Holding{});
  CHECK(then.state(root) == RunState::running);
  CHECK(now.state(root) == RunState::none);
  CHECK(then.values[0].value == unset);
  CHECK(now.values[0].value == 1);
  CHECK(then.now == 0);
  CHECK(now.now == 7);
}

} // namespace
} // namespace director::tests
