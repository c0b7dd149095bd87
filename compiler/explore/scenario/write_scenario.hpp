#pragma once
// SPDX-License-Identifier: MIT
// Writes a way through the exploration as a scenario file. The file is played before it is returned: it is valid only
// if the same happens with the tables and the time of the robot.

#include "compiler/explore/search/search.hpp"

#include <optional>
#include <string>

namespace director::compiler {

struct ScenarioHead {
  std::string title;
  std::string doc;          ///< what to look at
  std::string behaviour;    ///< path of the behaviour from the scenario's folder
  std::vector<Taken> round; ///< what repeats after the way, which then never comes to rest
};

/// Empty if it cannot be played: timers would have to be due in another order than their durations allow.
std::optional<std::string> write_scenario(const Ground& ground, const std::vector<Taken>& way,
                                          const ScenarioHead& head);

/// The program's actions on that way, briefly: `request Walk; set {Pose: standing}`.
std::string in_words(const Ground& ground, const std::vector<Taken>& way);

} // namespace director::compiler
