#include "walker.hpp"

class LegsDouble final : public walker::Legs {
public:
  director::Outcome provide(walker::Walk::Default& run) override {
    run.try_set(walker::Pose::fallen);
    return run.request(walker::Step{});
  }
  director::Outcome provide(walker::Step::Default& run) override { return run.done(); }
};
