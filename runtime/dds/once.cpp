// Header: runtime/dds/once.hpp. Test: tests/runtime/dds/once_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/once.hpp"

#include <algorithm>

namespace director::dds {

Once::Asker& Once::asker(std::uint64_t session) {
  auto found = std::ranges::find(askers_, session, &Asker::session);
  if (found == askers_.end()) {
    if (askers_.size() < most_askers) {
      found = askers_.insert(askers_.end(), Asker{});
    } else {
      found = std::ranges::min_element(askers_, {}, &Asker::heard);
      *found = {};
    }
    found->session = session;
  }
  found->heard = ++looks_;
  return *found;
}

Once::Seen Once::look(std::uint64_t session, std::uint64_t number) {
  const Asker& from = asker(session);
  if (number > from.highest) return {};
  if (from.highest - number >= window) return {.verdict = Verdict::too_old};
  const std::uint8_t answer = from.answers[number % window];
  if (answer == 0) return {};
  return {.verdict = Verdict::repeated, .answer = static_cast<std::uint8_t>(answer - 1)};
}

void Once::note(std::uint64_t session, std::uint64_t number, std::uint8_t answer) {
  Asker& from = asker(session);
  if (number > from.highest) {
    const std::uint64_t skipped = std::min(number - from.highest, window);
    for (std::uint64_t i = 0; i < skipped; ++i) from.answers[(number - i) % window] = 0;
    from.highest = number;
  }
  from.answers[number % window] = static_cast<std::uint8_t>(answer + 1);
}

} // namespace director::dds
