#pragma once
// SPDX-License-Identifier: MIT
// Random behaviours and scenarios for them, dense with what makes arbitration hard: few states that many wait for and
// several cause, shared resources, equal priorities, alternatives of needs, ladders. Everything follows from the seed.
// Every scenario comes to rest by itself: after its scripted runs a provider only continues, and after as many calls a
// handler sets nothing.

#include "tests/property/draft.hpp"
#include "tests/property/random.hpp"

namespace director::property {

/// What one random behaviour is like as a whole.
struct Flavour {
  double when = 0.4, causing = 0.4, needs = 0.45, optional = 0.3, apart = 0.12;
  double levels = 0.1;     ///< tasks that can be asked for in several ways
  double favourite = 0.35; ///< how often the few shared groups are wanted
  double diligence = 0.5;  ///< how often a body sets what its provider causes
  std::vector<int> priorities;
  int scripted_runs = 3;    ///< of a provider or handler; later ones only continue
  int length = 1;           ///< of the scenario, times 10 to 30 steps
  bool moving_unit = false; ///< one unit is tried now before and now behind a task that is apart
};

Flavour random_flavour(Random& random);
BehaviourDraft random_behaviour(Random& random, const Flavour& flavour, std::size_t groups);
/// The scenario names `behaviour.yaml`.
Node random_scenario(Random& random, const Flavour& flavour, const BehaviourDraft& behaviour);

struct Documents {
  Node behaviour, scenario;
};

/// 3 to 15 groups; one in forty has 30.
Documents generate(std::uint64_t seed);

/// 6 to 15 groups, among them a unit that moves, as its first member may be asked for at a lower level.
Documents generate_moving_unit(std::uint64_t seed);

/// 3 to 8 groups, whose bodies ask for something else in each of many runs.
Documents generate_long(std::uint64_t seed);

/// Five groups of equals, where one has another choice than what is denied to it. No body is scripted: each asks for
/// all that it may.
Documents generate_equals(std::uint64_t seed);

/// Two to four such behaviours in one, small ones. What happens in one may matter to another by a state at most, so
/// that they are components of their own: what one input or run changes in several has one order all the same.
Documents generate_parts(std::uint64_t seed);

/// One of any of these kinds, of up to 60 groups. The scenario of a large one takes the oracle long.
Documents generate_any(std::uint64_t seed);

} // namespace director::property
