// A program for a computer and for a Cortex-M3 without an operating system: both must print the same.
#include "ferry.hpp"
#include "say.hpp"

#include <chrono>

namespace {

using director::Event;
using director::Outcome;
using namespace std::chrono_literals;

class Deck final : public ferry::Deck {
  Outcome provide(ferry::Load::Cars& run) override {
    run.set(ferry::Ramp::down);
    return run.request(ferry::Winch{});
  }
  Outcome provide(ferry::Load::Closing& run) override {
    if (++turns_ == 3) run.set(ferry::Ramp::up);
    run.wait(100ms);
    return run.request(ferry::Winch{});
  }
  int turns_ = 0;
};

class Bridge final : public ferry::Bridge {
  Outcome provide(ferry::Sail::Default& run) override { return run.request(ferry::Winch{}); }
};

class Engine final : public ferry::Engine {
  Outcome provide(ferry::Winch::Default& run) override { return run.keep(); }
};

void tell(void*, const Event& event) {
  switch (event.kind) {
  case Event::Kind::run: say("run "); break;
  case Event::Kind::push: say("push "); break;
  case Event::Kind::grant: say("grant "); break;
  case Event::Kind::queue: say("queue "); break;
  default: return;
  }
  say(ferry::names::group(event.group));
  if (event.provider != director::nil) {
    say(".");
    say(ferry::names::provider(event.provider));
  }
  say("\n");
}

Deck deck;
Bridge bridge;
Engine engine;
ferry::Behaviour behaviour{deck, bridge, engine, {tell, nullptr}};

} // namespace

int main() {
  behaviour.request<ferry::Load>();
  behaviour.step(0s);
  behaviour.request<ferry::Sail>();
  for (auto now = 10ms; now < 1s; now += 10ms) behaviour.step(now);
  say("done\n");
  return 0; // without an operating system, main is a function like any other
}
