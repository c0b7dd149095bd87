#pragma once
// SPDX-License-Identifier: MIT
// A scenario file as it is written: no name resolved. Source: docs/scenarios.md.

#include "dsl/data.hpp"
#include "dsl/lexical/duration.hpp"
#include "dsl/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::dsl {

/// `{Pose: standing}`: one pair of `set` or `given`. The value is a name or a whole number, as text.
struct SettingSpec {
  Word state;
  Word value;
  bool operator==(const SettingSpec&) const = default;
};

/// An entry of a script's `tasks` or `with`, or of a step's `request` (which has no `keep`).
struct RequestSpec {
  Word group;
  std::optional<Word> level;
  std::optional<Located<Data>> data;
  Located<bool> keep;
  bool operator==(const RequestSpec&) const = default;
};

enum class Reason { new_task, pushed, subtask_done, wait, trigger };
enum class UseState { running, queued, none, done, failed };

struct UseGuardSpec {
  Word group;
  Located<UseState> state;
  bool operator==(const UseGuardSpec&) const = default;
};

/// The answer of a case. `nothing`: no answer is written, which is an empty pack.
enum class Answer { nothing, pack, tasks, done, failed, keep };

struct CaseSpec {
  // Guards: all that are written must hold.
  std::optional<Located<Reason>> reason;
  std::optional<Word> trigger;
  std::optional<Located<Data>> data;
  std::optional<Located<std::int64_t>> run; ///< from 1
  std::vector<UseGuardSpec> uses;
  // Effects.
  Located<Answer> answer;         ///< `continue: true` is `keep`
  std::optional<Word> pack;       ///< with Answer::pack
  std::vector<RequestSpec> tasks; ///< with Answer::tasks; with Answer::pack those of `with`
  std::vector<Word> without;      ///< groups: entries of the pack that are left out
  std::vector<SettingSpec> set;
  std::optional<Located<Duration>> wait;
  Span span{};
  bool operator==(const CaseSpec&) const = default;
};

/// `Walk: ...`, `Walk.halting: ...`, `Walk.start: ...`.
struct ScriptEntrySpec {
  Word group;
  std::optional<Word> part; ///< a provider, or `start` or `stop`
  std::vector<CaseSpec> cases;
  Span span{};
  bool operator==(const ScriptEntrySpec&) const = default;
};

struct InputSpec {
  enum class Kind { request, cancel, set, trigger, enable, disable };
  Located<Kind> kind;
  std::vector<RequestSpec> requests; ///< of request
  Word name;                         ///< of cancel, trigger: the name; of enable, disable: the group
  Word provider;                     ///< of enable, disable
  std::vector<SettingSpec> set;      ///< of set
  std::string shown;                 ///< as it is printed behind `> `: `set {Pose: standing, Charge: 3}`
  Span span{};
  bool operator==(const InputSpec&) const = default;
};

struct ExpectSpec {
  std::vector<Word> lines; ///< trimmed; neither blank ones nor comments
  Span span{};
  bool operator==(const ExpectSpec&) const = default;
};

/// Either `advance`, or inputs that are queued together.
struct StepSpec {
  std::optional<Located<Duration>> advance;
  std::vector<InputSpec> inputs;
  std::optional<ExpectSpec> expect;
  std::optional<Word> doc;
  Span span{};
  bool operator==(const StepSpec&) const = default;
};

struct ScenarioSpec {
  FileId file{};
  std::optional<Word> title;  ///< `scenario:`
  Word behaviour;             ///< path as written, relative to the scenario file
  std::string behaviour_path; ///< the same from the working directory: what read_behaviour takes
  std::optional<Word> doc;
  std::vector<SettingSpec> given;
  std::vector<ScriptEntrySpec> script;
  std::vector<StepSpec> steps;
  Span span{};
  bool operator==(const ScenarioSpec&) const = default;
};

} // namespace director::dsl
