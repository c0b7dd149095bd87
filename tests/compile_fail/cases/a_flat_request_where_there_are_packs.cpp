// Door: runtime/core/behaviour.hpp. Test: itself.
// Message: flat
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.request(porter::Grip{});
#else
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{});
#endif
}
