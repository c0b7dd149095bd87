// Header: tests/oracle/behaviour.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, section 6: what a provider can read.
#include "tests/oracle/behaviour.hpp"

#include <algorithm>

namespace director::oracle {

Sight Behaviour::sight(GroupId group, ProviderId provider, const std::set<Reason>& reasons) const {
  Sight out{group, provider, reasons, fired_[group], data_[group], {}};
  for (const auto& use : parts_.model().providers[provider].uses) {
    Sight::Use& seen = out.uses[use.id];
    for (const EdgeId edge : parts_.model().groups[group].edges) {
      if (parts_.target(edge) != use.id || !facts_.request[edge])
        continue; // a need that was not requested has no state
      seen.run = now_.granted_to(edge, use.id) ? Sight::Run::running : Sight::Run::queued;
      if (seen.run != Sight::Run::running) continue;
      if (done_[use.id] == Done::done) seen.result = Sight::Result::done;
      if (done_[use.id] == Done::failed) seen.result = Sight::Result::failed;
    }
  }
  return out;
}

} // namespace director::oracle
