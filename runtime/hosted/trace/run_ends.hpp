#pragma once
// SPDX-License-Identifier: MIT
// The events behind which a group may not run any more. Whether it does they do not tell wholly: who can look at the
// engine looks there (compiler/trace/waits.cpp, runtime/live/feed.cpp).

#include "runtime/core/base/observer.hpp"

namespace director {

/// It is held by somebody else, by nobody, or has stopped.
inline bool ends_hold(const Event& event) {
  return event.kind == Event::Kind::grant || event.kind == Event::Kind::lose || event.kind == Event::Kind::stop;
}

/// The request of the event's edge waits, or is there no more.
inline bool ends_request(const Event& event) {
  return event.kind == Event::Kind::queue || event.kind == Event::Kind::withdraw ||
         (event.kind == Event::Kind::input && event.input == Event::Input::cancel);
}

} // namespace director
