#pragma once
// SPDX-License-Identifier: MIT
// Where the data of tasks are while a scenario is played: what a generated behaviour keeps in typed slots are values
// that can be printed and compared here. The engine says when they move. Source: runtime/core/engine/run.hpp
// (Bodies::Data).

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

  /// Data of an input, to wait until the engine accepts it.
  Index wait_for_input(Value value);
  void stage(Index edge, Value value) { staging_[edge] = std::move(value); }
  /// `target`: the group that the edge leads to.
  void move(Bodies::Data what, Index edge, Index handle, Index target);
  const Value& at(DataPlace place) const;

private:
  std::vector<Value> edges_, staging_, groups_, inputs_;
};

} // namespace director::compiler
