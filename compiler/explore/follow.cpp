// Header: compiler/explore/search.hpp. Test: tests/compiler/explore/search_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/search.hpp"
#include "compiler/explore/tape.hpp"
#include "compiler/explore/watch.hpp"

namespace director::compiler {

namespace {

/// Replays a way from the start without a break; `before` and `after` are called around each of its micro-steps.
template <class Before, class After>
void replay(const Ground& ground, const Way& way, Breadth breadth, Before&& before, After&& after) {
  Machine machine(ground, breadth);
  machine.start();
  machine.forget();
  std::vector<Happens> happens;
  Packed here;
  Tape tape;
  for (const std::uint32_t place : way) {
    here.clear();
    machine.pack(here);
    machine.unpack(here);
    machine.list(happens);
    before(machine);
    std::uint32_t at = 0;
    bool found = false;
    for (std::size_t i = 0; i < happens.size() && !found; ++i) {
      tape.begin();
      do {
        found = at++ == place;
        if (at != 1) machine.again();
        const Phase phase = machine.phase();
        machine.take(happens[i], tape);
        if (found) after(machine, happens[i], phase);
      } while (!found && tape.next());
    }
    machine.forget();
  }
}

} // namespace

std::vector<Taken> follow(const Ground& ground, const Way& way, Breadth breadth) {
  std::vector<Taken> out;
  replay(
      ground, way, breadth, [](const Machine&) {},
      [&](const Machine& machine, const Happens& happens, Phase before) {
        out.push_back({happens, machine.deeds(), before, machine.phase()});
      });
  return out;
}

bool shows(const Ground& ground, const Way& way, Breadth breadth, std::size_t assertion) {
  Watch watch(ground, {assertion});
  std::uint64_t remembered = 0;
  std::vector<std::size_t> seen;
  replay(
      ground, way, breadth, [&](const Machine& machine) { watch.before(machine, remembered); },
      [&](const Machine& machine, const Happens&, Phase) {
        seen.clear();
        remembered = watch.after(machine, seen);
      });
  return !seen.empty();
}

} // namespace director::compiler
