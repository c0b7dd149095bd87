// Header: tests/bench/small_cases.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/small_cases.hpp"

#include "alone.hpp"
#include "chain.hpp"
#include "fan.hpp"
#include "steal.hpp"
#include "tests/bench/by_hand.hpp"
#include "walker.hpp"

#include <stdexcept>
#include <tuple>

namespace bench {

namespace {

using director::Outcome;

/// Aborts if a case does not do what it is meant to measure.
void expect(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

class Alone final : public alone::Alone {
public:
  Outcome provide(alone::Stand::Default& run) override {
    ++calls;
    return run.request();
  }
  std::uint64_t calls = 0;
};

class Idle {
public:
  Idle() {
    expect(behaviour_.set(alone::Charge{50}), "it has a charge");
    behaviour_.request<alone::Stand>();
    behaviour_.step();
    expect(behaviour_.state<alone::Stand>() == director::RunState::running, "it stands");
  }
  void once() { behaviour_.step(); }
  std::uint64_t calls() const { return bodies_.calls; }

protected:
  Alone bodies_;
  alone::Behaviour behaviour_{bodies_};
};

class Set : public Idle {
public:
  void once() {
    value_ ^= 1;
    std::ignore = behaviour_.set(alone::Charge{value_});
    behaviour_.step();
  }

private:
  int value_ = 50;
};

class Again : public Idle {
public:
  void once() {
    behaviour_.request<alone::Stand>();
    behaviour_.step();
  }
};

class Steal final : public steal::Steal {
public:
  Steal() {
    behaviour_.request(steal::Left{steal::Left::low}, steal::Right{});
    behaviour_.step();
    expect(calls_ == 3, "the right one has it");
  }
  Outcome provide(steal::Left::Default& run) override { return share(run); }
  Outcome provide(steal::Right::Default& run) override { return share(run); }
  Outcome provide(steal::Shared::Default& run) override {
    ++calls_;
    return run.request();
  }
  void once() {
    high_ = !high_;
    behaviour_.request(high_ ? steal::Left{steal::Left::high} : steal::Left{steal::Left::low});
    behaviour_.step();
  }
  std::uint64_t calls() const { return calls_; }

private:
  Outcome share(auto& run) {
    ++calls_;
    return run.request(steal::Shared{});
  }
  bool high_ = false;
  std::uint64_t calls_ = 0;
  steal::Behaviour behaviour_{*this};
};

class Walker final : public walker::Walker {
public:
  Walker() {
    behaviour_.request<walker::Walk>();
    behaviour_.step();
    expect(calls_ == 2, "it walks");
  }
  Outcome provide(walker::Walk::Walking& run) override {
    ++calls_;
    run.set(walker::Pose::moving);
    return run.request(walker::Legs{});
  }
  Outcome provide(walker::Walk::Halting& run) override {
    ++calls_;
    run.set(walker::Pose::standing);
    return run.request(walker::Legs{});
  }
  Outcome provide(walker::Kick::Default& run) override {
    ++calls_;
    return run.done();
  }
  Outcome provide(walker::Legs::Default& run) override {
    ++calls_;
    return run.request();
  }
  void once() {
    behaviour_.request<walker::Kick>();
    behaviour_.step();
  }
  std::uint64_t calls() const { return calls_; }

private:
  std::uint64_t calls_ = 0;
  walker::Behaviour behaviour_{*this};
};

class Chain final : public chain::Chain {
public:
  Chain() { once(); }
  Outcome provide(chain::Link0::Default& run) override { return ask(run, chain::Link1{}); }
  Outcome provide(chain::Link1::Default& run) override { return ask(run, chain::Link2{}); }
  Outcome provide(chain::Link2::Default& run) override { return ask(run, chain::Link3{}); }
  Outcome provide(chain::Link3::Default& run) override { return ask(run, chain::Link4{}); }
  Outcome provide(chain::Link4::Default& run) override { return ask(run, chain::Link5{}); }
  Outcome provide(chain::Link5::Default& run) override { return ask(run, chain::Link6{}); }
  Outcome provide(chain::Link6::Default& run) override { return ask(run, chain::Link7{}); }
  Outcome provide(chain::Link7::Default& run) override { return ask(run, chain::Link8{}); }
  Outcome provide(chain::Link8::Default& run) override { return ask(run); }
  void once() {
    behaviour_.request<chain::Link0>();
    behaviour_.step();
  }
  std::uint64_t calls() const { return calls_; }

private:
  template <class... Next>
  Outcome ask(auto& run, Next... next) {
    ++calls_;
    return run.request(next...);
  }
  std::uint64_t calls_ = 0;
  chain::Behaviour behaviour_{*this};
};

class Fan final : public fan::Fan {
public:
  Fan() { once(); }
  Outcome provide(fan::All::Default& run) override {
    ++calls_;
    return run.request(fan::Part1{}, fan::Part2{}, fan::Part3{}, fan::Part4{}, fan::Part5{}, fan::Part6{}, fan::Part7{},
                       fan::Part8{}, fan::Part9{}, fan::Part10{}, fan::Part11{}, fan::Part12{}, fan::Part13{},
                       fan::Part14{}, fan::Part15{}, fan::Part16{}, fan::Part17{}, fan::Part18{}, fan::Part19{},
                       fan::Part20{});
  }
  Outcome provide(fan::Part1::Default& run) override { return part(run); }
  Outcome provide(fan::Part2::Default& run) override { return part(run); }
  Outcome provide(fan::Part3::Default& run) override { return part(run); }
  Outcome provide(fan::Part4::Default& run) override { return part(run); }
  Outcome provide(fan::Part5::Default& run) override { return part(run); }
  Outcome provide(fan::Part6::Default& run) override { return part(run); }
  Outcome provide(fan::Part7::Default& run) override { return part(run); }
  Outcome provide(fan::Part8::Default& run) override { return part(run); }
  Outcome provide(fan::Part9::Default& run) override { return part(run); }
  Outcome provide(fan::Part10::Default& run) override { return part(run); }
  Outcome provide(fan::Part11::Default& run) override { return part(run); }
  Outcome provide(fan::Part12::Default& run) override { return part(run); }
  Outcome provide(fan::Part13::Default& run) override { return part(run); }
  Outcome provide(fan::Part14::Default& run) override { return part(run); }
  Outcome provide(fan::Part15::Default& run) override { return part(run); }
  Outcome provide(fan::Part16::Default& run) override { return part(run); }
  Outcome provide(fan::Part17::Default& run) override { return part(run); }
  Outcome provide(fan::Part18::Default& run) override { return part(run); }
  Outcome provide(fan::Part19::Default& run) override { return part(run); }
  Outcome provide(fan::Part20::Default& run) override { return part(run); }
  void once() {
    behaviour_.request<fan::All>();
    behaviour_.step();
  }
  std::uint64_t calls() const { return calls_; }

private:
  Outcome part(auto& run) {
    ++calls_;
    return run.request();
  }
  std::uint64_t calls_ = 0;
  fan::Behaviour behaviour_{*this};
};

class Nothing {
public:
  void once() { idler_.step(); }
  std::uint64_t calls() const { return 0; }

private:
  Idler& idler_ = idler();
};

/// Every input goes through `take` of by_hand.cpp.
template <Input input, std::size_t providers>
class ByHand {
public:
  void once() {
    if constexpr (input == Input::set || input == Input::steal) which_ ^= 1;
    take(robot_, input, which_);
  }
  std::uint64_t calls() const { return robot_.calls; }

private:
  std::size_t which_ = 0;
  Robot robot_ = build_by_hand(providers);
};

} // namespace

void add_small_cases(std::vector<Entry>& entries) {
  const auto add = [&](const char* name, const char* title, const char* aim, auto director, auto by_hand) {
    Entry entry;
    entry.name = name;
    entry.title = title;
    entry.aim = aim;
    entry.director = director;
    entry.by_hand = by_hand;
    entries.push_back(entry);
  };
  add("idle", "idle `step` with nothing to do", "2x", make<Idle>, make<Nothing>);
  add("set", "set a state that changes no condition", "10", make<Set>, make<ByHand<Input::set, 1>>);
  add("again", "re-request of a running root task (one provider run)", "40", make<Again>,
      make<ByHand<Input::again, 1>>);
  add("steal", "steal: two root tasks over one shared task (two runs)", "150", make<Steal>,
      make<ByHand<Input::steal, 3>>);
  add("soft", "soft transition: kick requested, push, halted, kick, walk again (four runs)", "400", make<Walker>,
      make<ByHand<Input::kick, 4>>);
  add("chain", "tree: root task and a chain of 8, each re-requesting", "350", make<Chain>, make<ByHand<Input::all, 9>>);
  add("fan", "fan: one provider with 20 needs and 20 tasks, all re-requested", "900", make<Fan>,
      make<ByHand<Input::all, 21>>);
}

} // namespace bench
