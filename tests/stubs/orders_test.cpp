// 2,000 orders, read by the cheap stand-in for Clang; tests/clang does the same ones with Clang itself, and compares.
#include "compiler/stubs/merge.hpp"
#include "tests/stubs/cheap_cpp.hpp"
#include "tests/stubs/orders.hpp"

#include <catch2/catch.hpp>

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

} // namespace

// That an insertion removes nothing is so by its type. What can go wrong is where it stands: within a comment, a string
// or another function, or under an #if; then it, or something of the user's, would not be found there afterwards.
TEST_CASE("whatever is edited in whatever order, the user's bytes stay in place and what is wanted is there") {
  std::size_t inserted = 0, written = 0, left_over = 0, refused = 0;
  for (unsigned number = 0; number < 2000; ++number) {
    Order order(number);
    for (int step = 0; step < order.steps(); ++step) {
      CAPTURE(number, step);
      if (step > 0) order.edit();
      const Merge merged = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
      const std::size_t before = functions(order);
      for (const std::string& fault : order.carry_out(merged)) FAIL(fault);
      std::size_t asked = 0;
      for (const Insertion& each : merged.insertions) asked += stubs_in(each.text);
      for (const auto& each : merged.sources) asked += stubs_in(each.text);
      if (merged.fresh.empty()) CHECK(functions(order) - before == asked);
      inserted += merged.insertions.size();
      written += merged.fresh.size() + merged.sources.size();
      left_over += merged.leftovers.size();
      refused += merged.obstacles.size();

      const Merge again = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
      if (!again.insertions.empty() || !again.sources.empty()) {
        for (const auto& [path, text] : order.texts()) UNSCOPED_INFO(path << ":\n" << text);
        for (const Insertion& each : again.insertions) UNSCOPED_INFO("again " << each.path << each.offset << each.text);
        FAIL("something is missing still");
      }
      CHECK(again.leftovers.size() == merged.leftovers.size());
    }
  }
  // The orders are worth something: much happens in them.
  CHECK(inserted > 2000);
  CHECK(written > 2000);
  CHECK(left_over > 500);
  CHECK(refused > 50);
}
