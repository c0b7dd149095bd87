// SPDX-License-Identifier: MIT
// 2,000 orders, read by the cheap stand-in for Clang; tests/compiler/clang does the same ones with Clang itself, and
// compares.
#include "compiler/stubs/merge.hpp"
#include "tests/compiler/stubs/cheap_cpp.hpp"
#include "tests/compiler/stubs/orders.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace director::tests;
using namespace director::compiler::stubs;

namespace {

/// How many functions of modules the texts have.
std::size_t functions(const Order& order) { return read_cheaply(order.texts(), order.wanted()).functions.size(); }

/// How many stubs a text has; each gets its context as `run`.
std::size_t stubs_in(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = text.find("& run)"); at != text.npos; at = text.find("& run)", at + 1)) ++count;
  return count;
}

struct Counts {
  std::size_t inserted = 0, written = 0, left_over = 0, refused = 0;
};

/// The beginning of an order or a step of it, and stubs; returns what is wrong.
std::string stubs_after(Order& order, Counts& counts) {
  const Merge merged = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
  const std::size_t before = functions(order);
  std::string out;
  for (const std::string& fault : order.carry_out(merged)) out += fault + "\n";
  std::size_t asked = 0;
  for (const Insertion& each : merged.insertions) asked += stubs_in(each.text);
  for (const auto& each : merged.sources) asked += stubs_in(each.text);
  if (merged.fresh.empty() && functions(order) - before != asked)
    out += fmt::format("{} stubs are inserted, {} are found\n", asked, functions(order) - before);
  counts.inserted += merged.insertions.size();
  counts.written += merged.fresh.size() + merged.sources.size();
  counts.left_over += merged.leftovers.size();
  counts.refused += merged.obstacles.size();

  const Merge again = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
  for (const Insertion& each : again.insertions)
    out += fmt::format("missing still: in {} at {}:{}\n", each.path, each.offset, each.text);
  for (const auto& each : again.sources) out += fmt::format("missing still: {}\n", each.path);
  if (again.leftovers.size() != merged.leftovers.size()) out += "it is said of other functions that nobody asks\n";
  return out;
}

/// The fault of these steps of an order, and the program then.
std::string fault_of(unsigned number, const std::vector<int>& steps, Counts& counts) {
  Order order(number);
  std::string fault = stubs_after(order, counts);
  for (std::size_t i = 0; i < steps.size() && fault.empty(); ++i) {
    order.edit(steps[i]);
    fault = stubs_after(order, counts);
  }
  if (fault.empty()) return {};
  return fmt::format("order {}, steps {}\n{}{}", number, fmt::join(steps, ", "), to_text(order), fault);
}

} // namespace

// By its type an insertion removes nothing. Its place can be wrong: within a comment, a string or another function, or
// under an #if; then it, or something of the user's, would not be found there afterwards.
TEST_CASE("whatever is edited in whatever order, the user's bytes stay in place and what is wanted is there") {
  Counts counts;
  for (unsigned number = 0; number < 2000; ++number) {
    const std::vector<int> steps = Order(number).steps();
    if (fault_of(number, steps, counts).empty()) continue;
    const auto fails = [&](const std::vector<int>& fewer) { return !fault_of(number, fewer, counts).empty(); };
    FAIL(fault_of(number, shrunk(steps, fails), counts));
  }
  // The orders are not trivial: they have many events.
  CHECK(counts.inserted > 2000);
  CHECK(counts.written > 2000);
  CHECK(counts.left_over > 500);
  CHECK(counts.refused > 50);
}

TEST_CASE("of the steps of an order that fails those are printed that it needs") {
  const auto needs_both = [](const std::vector<int>& steps) {
    const auto has = [&](int step) { return std::find(steps.begin(), steps.end(), step) != steps.end(); };
    return has(2) && has(5);
  };
  CHECK(shrunk({1, 2, 3, 4, 5, 6}, needs_both) == std::vector<int>{2, 5});
  CHECK(shrunk({1, 2, 3}, [](const std::vector<int>&) { return true; }).empty());
  CHECK(shrunk({1, 2, 3}, [](const std::vector<int>& steps) { return steps.size() > 1; }) == std::vector<int>{2, 3});
}

TEST_CASE("a step does the same whatever was done before it, where it can") {
  Order whole(7), part(7);
  whole.edit(1), part.edit(1);
  CHECK(whole.yaml() == part.yaml());
  whole.edit(2), part.edit(2);
  CHECK(whole.texts() == part.texts());
}
