#pragma once
// SPDX-License-Identifier: MIT
// Events after which a group may not run any more. They do not say it for certain: code with access to the engine reads
// that (compiler/trace/waits.cpp, runtime/live/feed.cpp).

#include "runtime/core/base/observer.hpp"

namespace director {

/// Whether the group of the event has another holder, or none, or has stopped.
inline bool ends_hold(const Event& event) {
  return event.kind == Event::Kind::grant || event.kind == Event::Kind::lose || event.kind == Event::Kind::stop;
}

/// Whether the request of the event's edge is queued or withdrawn.
inline bool ends_request(const Event& event) {
  return event.kind == Event::Kind::queue || event.kind == Event::Kind::withdraw ||
         (event.kind == Event::Kind::input && event.input == Event::Input::cancel);
}

} // namespace director
