#pragma once
// SPDX-License-Identifier: MIT
// The state in which engine and oracle must agree after every micro-step.

#include "runtime/core/base/tables.hpp"
#include "tests/oracle/assignment.hpp"
#include "tests/oracle/behaviour.hpp"

#include <string>
#include <vector>

namespace director::property {

struct Snapshot {
  struct Group {
    std::optional<oracle::EdgeId> holder;
    std::optional<oracle::ProviderId> active;
    bool granted = false, needed = false;
    std::optional<oracle::Push> push;
    bool in_force = false;
    std::set<oracle::Reason> pending;
    bool operator==(const Group&) const = default;
  };
  std::size_t lines = 0; ///< lines of the trace so far
  std::vector<Group> groups;
  std::vector<std::optional<std::uint32_t>> requests; ///< edge: level
  std::vector<std::optional<std::int64_t>> values;    ///< state
  std::vector<oracle::GroupId> queue;
  std::vector<oracle::GroupId> order; ///< groups that are held: component after component, each in its order
  bool operator==(const Snapshot&) const = default;
};

Snapshot snapshot_of(const oracle::Behaviour& behaviour, const Tables& tables);

/// For messages: a line for each group that is held or pushed.
std::string to_text(const Snapshot& snapshot, const compiler::Model& model);

} // namespace director::property
