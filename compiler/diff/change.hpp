#pragma once
// SPDX-License-Identifier: MIT
// A change of meaning between two behaviours, and its kind. Things with the same name are the same; ids of the two
// models are unrelated.

#include "dsl/source/span.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace director::compiler {

/// The most dangerous first: the order in which changes are reported.
enum class ChangeKind {
  refused,
  hardened,
  takeover_gained,
  takeover_lost,
  tie_order,
  unit,
  became_dead,
  became_reachable,
  condition_loosened,
  condition_tightened,
  push_gained,
  push_lost,
  bound_grew,
  preference,
  promise,
  sets,
  handler,
  needs_added,
  needs_removed,
  request_added,
  request_removed,
  state_values,
  state_initial,
  state_source,
  triggers,
  levels,
  transition_changed,
  softened,
  bound_shrank,
  group_removed,
  provider_removed,
  state_removed,
  assertion,
  api,
  realtime,
  uses,
  group_added,
  provider_added,
  state_added,
  accepted,
  finding_new,
  finding_gone,
  priority,
  layers,
};

struct ChangeKindPage {
  ChangeKind kind;
  std::string_view id;
  std::string_view meaning; ///< a sentence
};

/// In order of danger.
std::span<const ChangeKindPage> change_kinds();
const ChangeKindPage& page_of(ChangeKind kind);

struct BehaviourChange {
  ChangeKind kind{};
  std::string subject; ///< `Walk.halting`, `Stability`, `root>Kick`
  std::string message;
  std::optional<dsl::Span> before, after; ///< at least one of them
  bool breaks_code = false;               ///< C++ that was written for the old one does not compile unchanged
  std::string hint;                       ///< a possible other interpretation; mostly empty
  bool operator==(const BehaviourChange&) const = default;
};

/// Pairs of groups between which control may pass differently, and how many of them were played: for large behaviours
/// only some.
struct TransitionsPlayed {
  std::size_t wanted = 0, played = 0;
};

} // namespace director::compiler
