#pragma once
#include "walker.hpp"

class Legs final : public walker::Legs {
public:
  director::Outcome provide(walker::Walk::Default& run) override;
  director::Outcome provide(walker::Step::Default& run) override { return run.done(); }
};
