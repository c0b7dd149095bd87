#pragma once
// SPDX-License-Identifier: MIT
// Converts a way through the exploration into steps and a script: the bodies' answers become the script, timers become
// time that passes.

#include "compiler/explore/scenario/scenario_words.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace director::compiler {

class ScenarioDraft {
public:
  using Words = std::vector<std::string>;
  using Cases = std::vector<Words>;

  explicit ScenarioDraft(const Ground& ground) : g_(ground), m_(ground.model), words_(ground) {}

  /// Converts the way; call it once. False: it cannot be expressed.
  bool fill(const std::vector<Taken>& way);

  /// Adds what bodies do after the way, at each call.
  void repeat(const std::vector<Taken>& round);

  /// A provider that is not on the way only continues. True if that is new.
  bool add_continuing(const std::string& name) { return script_.try_emplace(name, Cases{{"continue: true"}}).second; }

  const std::vector<std::string>& lines() const { return lines_; }
  const std::vector<Words>& steps() const { return steps_; }
  const std::map<std::string, Cases>& script() const { return script_; }

private:
  void begin_step(const Taken& taken);
  bool advance(Time by);
  bool input(const Taken& taken);
  void act(const Action& action);

  struct LastRun {
    Cases* cases = nullptr;
    std::size_t at = 0;
    Time time = 0;
  };

  const Ground& g_;
  const Model& m_;
  ScenarioWords words_;
  std::map<std::string, Cases> script_; ///< by provider or handler
  std::map<std::string, int> counts_;
  std::set<std::string> repeated_;
  std::vector<Words> steps_;
  std::vector<std::string> lines_; ///< what happens on the way
  std::vector<LastRun> last_run_;
  std::vector<Time> last_set_;
  Time now_ = 0;
};

} // namespace director::compiler
