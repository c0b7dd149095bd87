#pragma once
// SPDX-License-Identifier: MIT
// A small behaviour as tables with names, and events of it, for tests of trace formats.

#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "tests/compiler/support/compiled.hpp"

namespace director::tests {

/// Two tasks that need one lamp; one of them is queued.
struct Lamp {
  Compiled compiled = compile(R"(
behaviour: lamp
language: 1
states:
  Motion: {values: [still, moving], initial: still}
  Charge: {range: [0, 100], external: true}
triggers: [Alarm]
roots:
  Shine: {priority: 1}
  Signal: {priority: 2}
groups:
  Shine: {tasks: [Bulb]}
  Signal: {when: [Motion == still], triggers: [Alarm], tasks: [Bulb]}
  Bulb:
    providers:
      - {name: bright, sets: [Motion == moving]}
      - {name: dim, causing: [Motion == still]}
)");
  compiler::Lowered lowered = compiler::lower(compiled.model);
  compiler::RowNames rows{compiled.model, lowered};
  Names names = rows.names();

  Event event(Event::Kind kind, Time time, std::uint64_t micro_step = 1) const {
    Event out;
    out.kind = kind;
    out.time = out.until = time;
    out.micro_step = micro_step;
    return out;
  }
};

} // namespace director::tests
