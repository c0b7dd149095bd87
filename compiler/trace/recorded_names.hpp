#pragma once
// SPDX-License-Identifier: MIT
// What the header of a trace says of the behaviour that was recorded: as much of its tables as it takes to print its
// events, without the behaviour itself.

#include "compiler/base/json.hpp"
#include "runtime/core/inspect/why_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

class RecordedNames {
public:
  /// Nothing, and why, where the header is none that this version can read.
  static std::optional<RecordedNames> read(const Json& header, std::string& problem);

  /// For as long as this object lives and stays where it is.
  director::Names names();

  std::string behaviour, file, fingerprint;

private:
  struct Rows {
    std::vector<std::string> groups, providers, edges, conditions, states, triggers, levels;
  };
  template <std::vector<std::string> Rows::* all>
  static const char* find(const void* self, Index row);
  static const char* value(const void* self, Index state, std::int32_t number);
  bool read_rows(const Json& header);

  Rows rows_;
  std::vector<std::vector<std::string>> values_; ///< by state
  std::vector<director::Group> group_rows_;
  std::vector<director::Provider> provider_rows_;
  std::vector<director::Edge> edge_rows_;
  std::vector<director::Level> level_rows_;
  std::vector<director::Condition> condition_rows_;
  std::vector<director::StateVariable> state_rows_;
  std::vector<director::Trigger> trigger_rows_;
  director::Tables tables_;
};

} // namespace director::compiler
