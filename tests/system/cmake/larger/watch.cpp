#include "watch.hpp"

#include "buoy.hpp"
#include "lighthouse.hpp"

namespace {

using director::Outcome;

class Bell final : public buoy::Keeper {
  Outcome provide(buoy::Ring::Default& run) override { return run.keep(); }
};

class Keeper final : public lighthouse::Keeper {
  Outcome provide(lighthouse::Turn::Default& run) override { return run.request(lighthouse::Lamp{}); }
};

class Bulb final : public lighthouse::Bulb {
  Outcome provide(lighthouse::Lamp::Burning& run) override { return run.keep(); }
};

[[maybe_unused]] void count(void* events, const director::Event&) { ++*static_cast<int*>(events); }

} // namespace

int watch() {
  int events = 0;
  Bell bell;
  Keeper keeper;
  Bulb bulb;
#ifdef DIRECTOR_NO_OBSERVER // then a Behaviour takes none
  buoy::Behaviour first{bell};
  lighthouse::Behaviour second{bulb, keeper};
#else
  buoy::Behaviour first{bell, {count, &events}};
  lighthouse::Behaviour second{bulb, keeper, {count, &events}};
#endif
  first.request(buoy::Ring{harbour::Sound{.hertz = 220}});
  first.step();
  second.request<lighthouse::Turn>();
  second.step();
  return events;
}
