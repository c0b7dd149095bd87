#pragma once
// SPDX-License-Identifier: MIT
// Reads texts and prints the findings in a line each, so that tests compare all of it:
//   3:5 `wehn` unknown_key: group `Kick` has no key `wehn` (did you mean `when`?)

#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"

#include <string>
#include <vector>

namespace director::dsl {

/// One a line: place, the text there, id (with `warning`), message, (help), and notes in lines of their own.
std::string findings_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources);

struct Read {
  MemoryFiles files;
  Sources sources;
  ReadResult result;
  /// The main file alone.
  const BehaviourSpec& file() const { return result.spec.files.back(); }
  std::string findings() const { return findings_text(result.diagnostics, sources); }
  std::string text(const Span& span) const { return std::string(sources.text(span)); }
};

/// The whole text of `main.yaml`.
Read read_text(const std::string& text);
/// The same behind two lines, `behaviour: b` and `language: 1`: `body` begins in line 3.
Read read_body(const std::string& body);

struct ScenarioRead {
  MemoryFiles files;
  Sources sources;
  ReadScenarioResult result;
  std::string findings() const { return findings_text(result.diagnostics, sources); }
  std::string text(const Span& span) const { return std::string(sources.text(span)); }
};

/// `b.scenario.yaml`, behind the line `behaviour: b.yaml`: `body` begins in line 2.
ScenarioRead read_scenario_body(const std::string& body);

/// A mistake and its message.
struct Case {
  const char* text;
  const char* findings;
};

} // namespace director::dsl
