// Header: compiler/explore/search/search.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/choice_sequence.hpp"
#include "compiler/explore/search/search.hpp"
#include "compiler/explore/search/watch.hpp"

namespace director::compiler {

template <class Before, class After>
void Follower::replay(const Way& way, Before&& before, After&& after) {
  Machine machine(ground_, breadth_);
  machine.start();
  machine.forget();
  std::vector<Happens> happens;
  Packed here;
  ChoiceSequence choices;
  for (std::size_t step = 0; step < way.size(); ++step) {
    here.clear();
    machine.pack(here);
    machine.unpack(here);
    machine.list(happens);
    before(machine);
    std::vector<std::uint32_t>& counts = counts_[Way(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(step))];
    std::uint32_t at = 0;
    bool moved = false, found = false;
    for (std::size_t i = 0; i < happens.size() && !found; ++i) {
      if (i < counts.size() && at + counts[i] <= way[step]) {
        at += counts[i];
        continue;
      }
      const std::uint32_t first = at;
      choices.begin();
      do {
        found = at++ == way[step];
        if (moved) machine.again();
        moved = true;
        ++micro_steps_;
        const Phase phase = machine.phase();
        machine.take(happens[i], choices);
        if (found) after(machine, happens[i], phase);
      } while (!found && choices.next());
      if (!found) counts.push_back(at - first);
    }
    machine.forget();
  }
}

std::vector<Taken> Follower::follow(const Way& way) {
  std::vector<Taken> out;
  replay(
      way, [](const Machine&) {},
      [&](const Machine& machine, const Happens& happens, Phase before) {
        out.push_back({happens, machine.actions(), before, machine.phase()});
      });
  return out;
}

/// Calls after(machine, watch, is_seen) after each micro-step.
template <class After>
void Follower::watch(const Way& way, std::size_t assertion, After&& after) {
  Watch watch(ground_, {assertion});
  std::uint64_t remembered = 0;
  std::vector<std::size_t> seen;
  replay(
      way, [&](const Machine& machine) { watch.before(machine, remembered); },
      [&](const Machine& machine, const Happens&, Phase) {
        seen.clear();
        remembered = watch.after(machine, seen);
        after(machine, watch, !seen.empty());
      });
}

bool Follower::shows(const Way& way, std::size_t assertion) {
  bool out = false;
  watch(way, assertion, [&](const Machine&, const Watch&, bool is_seen) { out = is_seen; });
  return out;
}

std::optional<Blocked> Follower::blocked(const Way& way, std::size_t assertion) {
  const Assertion& beats = ground_.model.assertions[assertion];
  std::optional<Blocked> out;
  watch(way, assertion, [&](const Machine& machine, const Watch& watch, bool is_seen) {
    out.reset();
    if (is_seen)
      out = blocked_by(machine.engine(), watch.blocked_request, static_cast<Index>(beats.groups.back().id.value));
  });
  return out;
}

std::optional<Cut> Follower::cut(const Way& way, std::size_t assertion) {
  std::optional<Cut> out;
  watch(way, assertion, [&](const Machine&, const Watch& watch, bool is_seen) {
    out = is_seen ? std::optional(watch.cut) : std::nullopt;
  });
  return out;
}

} // namespace director::compiler
