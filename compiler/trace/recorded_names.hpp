#pragma once
// SPDX-License-Identifier: MIT
// The part of a behaviour in the header of a trace: what is needed of its tables to print its events, without the
// behaviour itself.

#include "compiler/base/json.hpp"
#include "compiler/lower/row_texts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

class RecordedNames {
public:
  /// Empty, and the reason, if this version cannot read the header.
  static std::optional<RecordedNames> read(const Json& header, std::string& problem);

  /// Valid as long as this object stays in place.
  director::Names names();

  std::string file, fingerprint;
  const std::string& behaviour() const { return texts_.behaviour; }

private:
  bool read_rows(const Json& header);
  bool read_use(const Json& json);

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
