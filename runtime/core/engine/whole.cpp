// runtime/core/base/parts.hpp: an engine for any tables, with all parts.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/engine.hpp"

/// Names this file to the linker, for shared libraries: others may call their engine, and need other parts.
extern "C" [[gnu::used]] const char director_whole_engine = 0;

namespace director {

namespace {

[[gnu::used]] constexpr Parts all = parts_of({}, true, true);
[[gnu::used]] constexpr const char* together = &part::together;

} // namespace

Engine::Engine(const Tables& tables, std::byte* memory, const Bodies& bodies, Inbox& inbox, Observer observer)
    : Engine(tables, State::in(memory, State::layout(Shape::of(tables)).begin), bodies, inbox) {
  observe(observer);
}

} // namespace director
