#pragma once
// SPDX-License-Identifier: MIT
// The data of tasks while a scenario is played: a generated behaviour keeps them in typed slots, here they are values
// that can be printed and compared. The engine moves them. Source: runtime/core/engine/run.hpp (Bodies::Data).

#include "dsl/data.hpp"
#include "runtime/core/engine/run.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace director::compiler {

class DataSlots {
public:
  using Value = std::optional<dsl::Data>; ///< nothing: a task without data

  DataSlots(std::size_t groups, std::size_t edges) : edges_(edges), staging_(edges), groups_(groups) {}

  /// Keeps the data of an input until the engine accepts it.
  Index wait_for_input(Value value);
  void stage(Index edge, Value value) { staging_[edge] = std::move(value); }
  /// `target`: the group that the edge leads to.
  void move(Bodies::Data what, Index edge, Index handle, Index target);
  const Value& at(DataPlace place) const;

private:
  std::vector<Value> edges_, staging_, groups_, inputs_;
};

} // namespace director::compiler
