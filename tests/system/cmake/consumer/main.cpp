#include "lantern.hpp"

#include <iostream>

namespace {

using director::Outcome;

class Keeper final : public lantern::Keeper {
  Outcome provide(lantern::Shine::Brightly& run) override { return run.request(lantern::Lamp{}); }
};

class Bulb final : public lantern::Bulb {
  Outcome provide(lantern::Lamp::Burning& run) override {
    std::cout << "the lamp shines\n";
    return run.keep();
  }
};

} // namespace

int main() {
  Keeper keeper;
  Bulb bulb;
  lantern::Behaviour behaviour{bulb, keeper};
  behaviour.request<lantern::Shine>();
  behaviour.step();
}
