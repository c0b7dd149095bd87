// Door: runtime/core/behaviour.hpp. Test: itself.
// Message: DeclaredValue<porter::detail::Facts<porter::Open::Default> *>|DeclaredValue<Facts<.*Default>>
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.set(porter::Load::held);
#else
  run.set(porter::Door::open);
#endif
  return run.done();
}
