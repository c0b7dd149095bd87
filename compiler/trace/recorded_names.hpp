#pragma once
// SPDX-License-Identifier: MIT
// What the header of a trace says of the behaviour that was recorded: as much of its tables as it takes to print its
// events, without the behaviour itself.

#include "compiler/base/json.hpp"
#include "compiler/lower/row_texts.hpp"

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

  std::string file, fingerprint;
  const std::string& behaviour() const { return texts_.behaviour; }

private:
  bool read_rows(const Json& header);

  RowTexts texts_;
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
