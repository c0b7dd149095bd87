#pragma once
// SPDX-License-Identifier: MIT
// Optional parts of the engine. A part is a source of its own, which the others call by weak references: the linker
// takes it from the library only if something else names it. Generated code names the parts that its tables use;
// without a part, no call of it is reached. Only ELF has such references: elsewhere all parts are linked.

#include "runtime/core/base/tables.hpp"

#include <array>

#ifdef __ELF__
#define DIRECTOR_PART [[gnu::weak]]
#else
#define DIRECTOR_PART
#endif

namespace director {

/// A name for each part, defined in its source. Timers are also linked if a body calls Run::wait(), and inputs of
/// several records only if link() makes one: these functions are in the sources of the parts.
namespace part {
extern const char units, staleness, plans, limbo, order, conditions, pushes, equals, search, optional,
    trail;                                                                     // arbitration
extern const char timers, together, several, states, handlers, promises, data; // engine
} // namespace part

/// Components of at most this many groups are decided whole: there, finding what a change reaches costs more. The limit
/// is higher on a 32-bit machine, because that code takes 5 kB, and saves only an eighth of the time at 24 groups.
inline constexpr Index most_decided_whole = sizeof(void*) < 8 ? 32 : 16;

using Parts = std::array<const char*, 17>;

/// The parts that these tables use. `data`: some task has data. `all`: all parts.
constexpr Parts parts_of(const Tables& t, bool data, bool all = false) {
  const bool requests = t.edges.size() > t.root_edges;
  const bool shared =
      any(t.components, [](const Component& row) { return row.groups.size() > 1; }); // by several groups
  const bool pushes = any(t.conditions, [](const Condition& row) { return !row.causers.empty(); });
  const bool equals = any(t.groups, [](const Group& row) { return row.equals; });
  const bool search = t.most_edges > 1 || equals;
  const bool optional = any(t.levels, [](const Level& row) { return row.optional; });
  const bool trail = any(t.components, [](const Component& row) { return row.groups.size() > most_decided_whole; });
  const bool periods = any(t.providers, [](const Provider& row) { return row.every != 0; });
  const bool handlers =
      periods || any(t.groups, [](const Group& row) { return row.start || row.stop || !row.owned.empty(); });
  const bool timers =
      periods || !t.promises.empty() || any(t.states, [](const StateVariable& row) { return row.expires != 0; });
  const auto use = [all](bool used, const char& name) { return used || all ? &name : nullptr; };
  return {use(requests, part::units),
          use(shared, part::staleness),
          use(shared || pushes, part::plans),
          use(shared, part::limbo),
          use(shared || t.components.size() > 1, part::order),
          use(!t.conditions.empty(), part::conditions),
          use(pushes, part::pushes),
          use(equals, part::equals),
          use(search, part::search),
          use(optional, part::optional),
          use(trail, part::trail),
          use(timers, part::timers),
          use(t.groups.size() > 1, part::several),
          use(!t.states.empty(), part::states),
          use(handlers, part::handlers),
          use(!t.promises.empty() || !t.triggers.empty(), part::promises),
          use(data, part::data)};
}

} // namespace director
