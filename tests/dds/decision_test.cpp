#include "runtime/dds/decision.hpp"
#include "tests/dds/robot.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::tests;

namespace {

/// Everything that one behaviour tells, in words.
struct Told {
  static void hear(void* self, const Event& event) {
    Told& told = *static_cast<Told*>(self);
    const dds::Decision d = dds::decision_of(event, *told.plug);
    if (event.kind != Event::Kind::set && event.kind != Event::Kind::input && event.kind != Event::Kind::ask)
      told.decisions.push_back(d.kind + " " + d.group + "." + d.provider + " for " + d.requester + ": " + d.reason);
    if (const auto ended = told.promises->hear(event))
      told.ended.push_back((ended->kept ? "kept " : "broken ") + ended->group + "." + ended->provider + ": " +
                           ended->condition);
  }
  const dds::Plug* plug = nullptr;
  dds::Promises* promises = nullptr;
  std::vector<std::string> decisions, ended;
};

} // namespace

TEST_CASE("a decision is told in names") {
  Plans plans;
  Skills skills;
  Told told;
  courier::Behaviour behaviour{plans, skills, {&Told::hear, &told}};
  const dds::Plug plugged = plug(behaviour);
  dds::Promises promises(plugged);
  told.plug = &plugged;
  told.promises = &promises;
  plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Sing{}); };
  behaviour.request<courier::Rest>();
  behaviour.step(0s);
  CHECK(told.decisions == std::vector<std::string>{"grant Rest.default for root: ", "run Rest.default for : new_task",
                                                   "grant Sing.default for Rest: ", "run Sing.default for : new_task"});
}

TEST_CASE("a promise is kept by the run of its provider, and broken when its time is over") {
  Plans plans;
  Skills skills;
  Told told;
  courier::Behaviour behaviour{plans, skills, {&Told::hear, &told}};
  const dds::Plug plugged = plug(behaviour);
  dds::Promises promises(plugged);
  told.plug = &plugged;
  told.promises = &promises;
  const auto hear = [&](Event event) {
    if (const auto ended = promises.hear(event))
      told.ended.push_back((ended->kept ? "kept " : "broken ") + ended->condition);
  };
  const Tables& t = plugged.tables();
  Index unlocking = 0;
  while (std::string(courier::names::provider(unlocking)) != "unlocking") ++unlocking;
  const Index open = t.providers[unlocking].group, door = state_row("Door");
  hear({.kind = Event::Kind::run, .group = open, .provider = unlocking, .micro_step = 5});
  hear({.kind = Event::Kind::set, .state = door, .value = 0, .micro_step = 5});
  CHECK(told.ended.empty());
  hear({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 6}); // by a handler, or a timer
  CHECK(told.ended.empty());
  hear({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 5});
  hear({.kind = Event::Kind::broken, .group = open, .provider = unlocking, .micro_step = 9});
  CHECK(told.ended == std::vector<std::string>{"kept Door == open", "broken Door == open"});
}
