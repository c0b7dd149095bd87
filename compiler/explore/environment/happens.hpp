#pragma once
// SPDX-License-Identifier: MIT
// What may happen to an explored engine, and what its bodies did.

#include "compiler/explore/environment/ground.hpp"

#include <cstddef>
#include <cstdint>

namespace director::compiler {

/// What may happen next.
struct Happens {
  enum class Kind : std::uint8_t {
    go,      ///< the engine continues: a run, what handlers set, or one more arbitration
    request, ///< `row` of Ground::requests
    cancel,  ///< root edge `row`
    set,     ///< `row` of Ground::sets
    fire,    ///< trigger `row`
    wake,    ///< a wait or `every` of group `row` is due
    expire,  ///< `row` of Ground::expiries
    breaks,  ///< `row` of Ground::broken
  };
  Kind kind = Kind::go;
  Index row = 0;
};

/// What a body or handler did, or may do.
struct Action {
  enum class Kind : std::uint8_t { run, start, stop };
  enum class Answer : std::uint8_t { pack, kept, keep, done };
  Kind kind = Kind::run;
  Answer answer = Answer::pack;
  Index group = 0, provider = nil;
  std::size_t pack = 0; ///< of FreeBody::packs
  std::size_t puts = 0; ///< of FreeBody::puts, Ground::starting or Ground::stopping
};

/// Between two micro-steps.
enum class Phase : std::uint8_t {
  rest,   ///< nothing is left to do without an input
  open,   ///< an input was taken and nothing has run yet: more inputs may be in the inbox
  closed, ///< runs continue to the end before the next input
};

/// How much of what may happen is tried.
enum class Breadth : std::uint8_t {
  all,
  lean, ///< one input at a time, and only at rest; nothing is kept, and no optional entry of a pack is left out. Fewer
        ///< states, so that the search gets further
  usual, ///< as lean, and each body answers with its first pack or all its tasks, and never with done
};

} // namespace director::compiler
