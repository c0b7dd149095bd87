#pragma once
// SPDX-License-Identifier: MIT
// What a behaviour may do without. A part of the engine is a source of its own, which the rest calls by weak
// references: the linker takes it from the library only where something else names it. Generated code names the parts
// that its tables use; where a part is missing nothing gets as far as a call of it. Only ELF has such references:
// elsewhere all parts are linked.

#include "runtime/core/base/tables.hpp"

#include <array>

#ifdef __ELF__
#define DIRECTOR_PART [[gnu::weak]]
#else
#define DIRECTOR_PART
#endif

namespace director {

/// A name for each part, in its source. Timers are also taken where a body calls Run::wait(), and inputs of several
/// records only where link() makes one: these functions stand in their sources.
namespace part {
extern const char units, staleness, plans, limbo, order, conditions, pushes, equals, search, optional,
    trail;                                                                     // arbitration
extern const char timers, together, several, states, handlers, promises, data; // engine
} // namespace part

/// A component of at most so many groups is decided whole: to find out what a change reaches costs more there. It is
/// more on a 32-bit machine, as what finds that out is code of its own: 5 kB, for an eighth of the time at 24 groups.
inline constexpr Index most_decided_whole = sizeof(void*) < 8 ? 32 : 16;

using Parts = std::array<const char*, 17>;

/// What these tables use. `data`: some task has data. `all`: whatever the tables are.
constexpr Parts parts_of(const Tables& t, bool data, bool all = false) {
  const bool requests = t.edges.size() > t.root_edges;
  const bool shared = any(t.components, [](const Component& row) { return row.groups.size() > 1; }); // by groups
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
