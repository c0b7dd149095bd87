#pragma once
// SPDX-License-Identifier: MIT
// The courier with bodies that a test sets, and a record of the events, with the generated names.

#include "courier.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace director::tests {

inline post::Parcel parcel(int weight) { return {std::make_unique<int>(weight)}; }

namespace courier = post::courier;

/// A body that a test may set; without one everything remains unchanged.
template <class Context>
using Body = std::function<Outcome(Context&)>;

template <class Context>
Outcome answer(const Body<Context>& body, Context& run) {
  return body ? body(run) : run.keep();
}

struct Plans final : courier::Plans {
  Body<courier::Deliver::Default> deliver;
  Body<courier::Rest::Default> rest;
  Outcome provide(courier::Deliver::Default& run) override { return answer(deliver, run); }
  Outcome provide(courier::Rest::Default& run) override { return answer(rest, run); }
};

struct Skills final : courier::Skills {
  Body<courier::Walk::Default> walk;
  Body<courier::Open::Passing> passing;
  Body<courier::Open::Unlocking> unlocking;
  Body<courier::Sing::Default> sing;
  std::function<void(courier::Walk::Start&)> on_start;
  std::function<void(courier::Walk::Stop&)> on_stop;
  void start(courier::Walk::Start& run) override {
    if (on_start) on_start(run);
  }
  void stop(courier::Walk::Stop& run) override {
    if (on_stop) on_stop(run);
  }
  Outcome provide(courier::Walk::Default& run) override { return answer(walk, run); }
  Outcome provide(courier::Open::Passing& run) override { return answer(passing, run); }
  Outcome provide(courier::Open::Unlocking& run) override { return answer(unlocking, run); }
  Outcome provide(courier::Sing::Default& run) override { return answer(sing, run); }
};

/// The events: `run Walk.default`, `start Walk`, `set Door open`, `refused Battery 50`, `queue root>Rest`.
class Record {
public:
  Observer observer() { return {&Record::tell, this}; }
  /// And clears it.
  std::vector<std::string> take() { return std::exchange(lines_, {}); }

private:
  static void tell(void* self, const Event& event);
  std::vector<std::string> lines_;
};

struct Office {
  Plans plans;
  Skills skills;
  Record record;
  courier::Behaviour behaviour{plans, skills, record.observer()};
};

} // namespace director::tests
