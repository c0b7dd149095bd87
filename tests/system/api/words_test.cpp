// SPDX-License-Identifier: MIT
// The specification may use the names that generated code uses itself: words.yaml compiles, and so do its packs.
#include "words.hpp"

#include <catch2/catch.hpp>

namespace {

namespace words = tests::words;
using director::Outcome;

Outcome data_task(words::Data::Task& run) {
  const int which = run.task();
  if (run.uses<words::Pack>().done()) return run.done();
  if (which == 1) return run.ask(words::Pack{nullptr});
  if (which == 2) return run.core_(words::Pack{nullptr});
  if (which == 3) return run.Pack(words::Pack{nullptr}, words::Given{});
  if (which == 4) return run.tasks(words::Context{}, words::Core{});
  if (which == 5) return run.Body(words::Slots{0.5});
  if (which == 6) return run.Given(words::Body{});
  return run.detail(words::Pack{nullptr});
}

Outcome data_body(words::Data::Body& run) {
  if (run.triggered<words::Facts>() || run.triggered<words::Row>()) run.set(words::States::Whole);
  run.set(words::Setting{5});
  return run.keep();
}

bool outside(words::Behaviour& behaviour) {
  return behaviour.request(words::Data{1, words::Data::Given}, words::Whole{}) &&
         behaviour.set(words::States::Facts, words::Setting{3}) && behaviour.fire<words::Row>() &&
         behaviour.enable<words::Data::Facts>(false) && behaviour.why<words::Data>().edge == director::nil;
}

TEST_CASE("a specification may use the words that generated code has for itself") {
  CHECK(&data_task != nullptr);
  CHECK(&data_body != nullptr);
  CHECK(&outside != nullptr);
  CHECK(std::string(words::names::group(0)) == "Data");
}

} // namespace
