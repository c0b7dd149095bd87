#pragma once
// SPDX-License-Identifier: MIT
// What a run asks of other groups takes effect. A part of the loop in step.cpp; where size counts, of several.cpp.

#include "runtime/core/engine/notes.hpp"

namespace director {

DIRECTOR_INLINE_OR_PART void Engine::commit_pack(Range edges) {
  Staged* staged = x_.s.staged_request;
  for (Index e = edges.begin; e != edges.end; ++e, ++staged) {
    const Index level = staged->level;
    if (level == nil) {
      if (observed() && x_.s.request[e].level != nil) report_request(Event::Kind::withdraw, e);
      withdraw(e);
      continue;
    }
    staged->level = nil;
    if (observed()) report_request(staged->keep ? Event::Kind::keep : Event::Kind::ask, e, level);
    if (staged->keep) continue;
    if (edges.size() != 1 || !asks_again(e, level)) {
      request(e, level);
      continue;
    }
    give_what_is_asked_again(e);
    if (bodies_.data != nullptr) settle_data(e);
  }
}

} // namespace director
