#pragma once
// SPDX-License-Identifier: MIT
// Random behaviours and scenarios for them, with many situations that are hard for arbitration: few states that many
// tasks wait for and several providers cause, shared resources, equal priorities, alternatives of needs, chains of
// pushes. Everything follows from the seed. Every scenario comes to rest by itself: after its scripted runs a provider
// only keeps its requests, and after as many calls a handler sets nothing.

#include "tests/property/draft.hpp"
#include "tests/property/random.hpp"

namespace director::property {

/// The properties of one random behaviour.
struct Flavour {
  double when = 0.4, causing = 0.4, needs = 0.45, optional = 0.3, apart = 0.12;
  double levels = 0.1;     ///< tasks with several levels
  double favourite = 0.35; ///< how often the few shared groups are requested or needed
  double diligence = 0.5;  ///< how often a body sets what its provider causes
  std::vector<int> priorities;
  int scripted_runs = 3;    ///< of a provider or handler; later ones only keep their requests
  int length = 1;           ///< of the scenario, times 10 to 30 steps
  bool moving_unit = false; ///< one unit is sometimes before and sometimes behind a task that is apart
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

/// 6 to 15 groups, among them a unit that moves in the order, because its first member may be requested at a lower
/// level.
Documents generate_moving_unit(std::uint64_t seed);

/// 3 to 8 groups, whose bodies change their requests in each of many runs.
Documents generate_long(std::uint64_t seed);

/// Five groups with equal edges, where one has another choice than the one denied to it. No body is scripted: each
/// requests all that it may.
Documents generate_equals(std::uint64_t seed);

/// Two to four such behaviours in one, small ones. They share at most states, so that they are components of their own:
/// the changes of one input or run in several of them still have one order.
Documents generate_parts(std::uint64_t seed);

/// One of any of these kinds, of up to 60 groups. The oracle is slow for scenarios of large ones.
Documents generate_any(std::uint64_t seed);

} // namespace director::property
