// Door: runtime/core/behaviour.hpp. Test: itself.
// Message: unused-result
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.done();
#endif
  return run.keep();
}
