#pragma once
// SPDX-License-Identifier: MIT
// A way through the exploration as a scenario file: what the bodies did becomes the script, timers become time that
// passes. The file is played before anybody gets it: it is good only if the same happens with the tables and the time
// of the robot.

#include "compiler/explore/search.hpp"

#include <optional>
#include <string>

namespace director::compiler {

struct ScenarioHead {
  std::string title;
  std::string doc;          ///< what to look at
  std::string behaviour;    ///< path of the behaviour from where the scenario will be
  std::vector<Taken> round; ///< what comes again and again behind the way, which then never comes to rest
};

/// Nothing if it cannot be played so: timers would have to be due in another order than their durations allow.
std::optional<std::string> write_scenario(const Ground& ground, const std::vector<Taken>& way,
                                          const ScenarioHead& head);

/// What the program does on that way, in few words: `request Walk; set {Pose: standing}`.
std::string in_words(const Ground& ground, const std::vector<Taken>& way);

} // namespace director::compiler
