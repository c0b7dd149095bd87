#include "legs.hpp"

director::Outcome Legs::provide(walker::Walk::Default& run) {
  const auto pose = walker::Pose::moving;
  run.try_set(pose);
  return run.request(walker::Step{});
}
