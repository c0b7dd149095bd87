// runtime/core/base/parts.hpp: an engine for any tables, with all parts.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/engine.hpp"

namespace director {

namespace {

[[gnu::used]] const Parts all{&part::units,      &part::staleness, &part::plans,   &part::limbo,  &part::order,
                              &part::conditions, &part::pushes,    &part::equals,  &part::search, &part::optional,
                              &part::trail,      &part::timers,    &part::several, &part::states, &part::handlers,
                              &part::promises,   &part::data};

[[gnu::used]] const char* const together = &part::together;

} // namespace

Engine::Engine(const Tables& tables, std::byte* memory, const Bodies& bodies, Inbox& inbox, Observer observer)
    : Engine(tables, State::in(memory, State::layout(Shape::of(tables))), bodies, inbox) {
  observe(observer);
}

} // namespace director
