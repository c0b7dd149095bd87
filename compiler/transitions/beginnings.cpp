// Header: compiler/transitions/beginnings.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/beginnings.hpp"

#include <cstddef>

namespace director::compiler::transitions {

namespace {

/// Limit for plays with which a row is searched, with the declared initial values, and with others.
constexpr std::size_t most_tries = 64;

} // namespace

std::optional<Beginning> Beginnings::find(const std::vector<Way>& ways, std::string& why) const {
  for (const Assume assume : {Assume::nothing, Assume::inside}) {
    const std::vector<std::pair<Way, Outside>> all = tries(ways, assume);
    for (const bool only_certain : {false, true}) {
      if (only_certain && !leaves_choice_) break;
      for (const auto& [way, outside] : all) {
        if (std::optional<Beginning> found = begin(way, outside, only_certain, why)) return found;
      }
    }
  }
  return {};
}

std::optional<Beginning> Beginnings::begin(const Way& way, const Outside& outside, bool only_certain,
                                           std::string& why) const {
  const Play played =
      player_.play(script_of(model_, way, {{}, {}, {}, only_certain}), player_.beginning(way, outside), 1, way);
  const Trial& trial = played.trial;
  if (why.empty()) why = trial.endless ? "When it is requested, the engine does not come to rest" : trial.why;
  if (!trial.good || !runs(trial.rest, way)) return {};
  return Beginning{way, outside, trial.runs, trial.rest, only_certain, {}};
}

/// Each way with its likeliest values, then each with its second ones, and so on.
std::vector<std::pair<Way, Outside>> Beginnings::tries(const std::vector<Way>& ways, Assume assume) const {
  std::vector<std::pair<Way, Outside>> out;
  std::vector<std::vector<Outside>> all;
  for (const Way& way : ways) all.push_back(outsides_for(model_, possible_, way, assume));
  for (std::size_t i = 0; i < most_outsides; ++i) {
    for (std::size_t way = 0; way < ways.size() && out.size() < most_tries; ++way) {
      if (i >= all[way].size() || (assume == Assume::inside && all[way][i].given.empty())) continue;
      out.emplace_back(ways[way], std::move(all[way][i]));
    }
  }
  return out;
}

} // namespace director::compiler::transitions
