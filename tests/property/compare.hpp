#pragma once
// SPDX-License-Identifier: MIT
// One scenario on the engine and on the oracle: compares traces and the state after every micro-step, and notes what
// the scenario showed.

#include "tests/property/claims.hpp"
#include "tests/property/compiled.hpp"

#include <array>
#include <string>
#include <string_view>

namespace director::property {

enum class Show {
  push,
  ladder,
  denial_by_an_equal,
  repeated_pass,
  limbo,
  alternative_plan,
  level_change,
  dropped_push,
  deferral,
  broken_promise,
  count
};
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Show::count)> show_names{
    "a push",         "a ladder",       "a denial by an equal", "a repeated pass", "limbo", "an alternative plan",
    "a level change", "a dropped push", "a deferral",           "a broken promise"};

struct Verdict {
  std::string difference; ///< empty: engine and oracle agree
  std::array<bool, static_cast<std::size_t>(Show::count)> shown{};
  std::array<bool, kinds_of_claims> claimed{}; ///< the kinds of answers of `why`
  std::size_t micro_steps = 0;
  double dearest = 0;       ///< the most work of a micro-step, as a share of its bound
  std::size_t settling = 0; ///< the most micro-steps in a row that only arbitrated once more
};

/// The ways to play a scenario.
enum class Manner {
  once,     ///< each due time has a step of its own, as in `directorc simulate`, which must print the same
  often,    ///< the same, and then three times more, from where it ended
  in_leaps, ///< time advances in leaps, so that timers are late
};
/// The way to play a random case.
inline Manner manner_of(std::uint64_t seed) {
  return seed % 4 == 3 ? Manner::in_leaps : seed % 4 == 1 ? Manner::often : Manner::once;
}

Verdict compare(const Compiled& compiled, Manner manner);

} // namespace director::property
