#pragma once
// SPDX-License-Identifier: MIT
// Finds what makes the condition of a task true until the task is granted, because it loses a need or a condition then;
// what another provider of its group sets instead makes the condition false again.

#include "compiler/analysis/causing/takings.hpp"
#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/rounds/settings.hpp"
#include "compiler/analysis/rounds/spoiling.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

struct FallbackRound {
  /// A provider that loses a need: the causing one, or one whose requests lead to it. Or the causing one loses a
  /// condition.
  struct Loser {
    ProviderId provider{};
    const Use<GroupId>* need = nullptr;
    std::optional<Spoilt> spoilt{};
    std::vector<ChainStep> down{}; ///< from its group to the causing one

    /// Of what it loses.
    dsl::Span span() const { return need != nullptr ? need->span : spoilt->condition.span; }
  };
  /// Another provider of its group, and what it sets.
  struct Fallback {
    ProviderId provider{};
    ConditionUse entry{};
    bool promised = false;
    ValueSet values; ///< of these, those with which the waiter cannot continue
  };

  GroupId waits{};     ///< the task that waits for the condition
  std::string granted; ///< is_granted()
  Want want;
  Setting setting; ///< what makes the condition true
  Loser loser;
  std::vector<GroupId> needs; ///< all that the loser loses
  Taking how;
  Fallback fallback;
};

std::vector<FallbackRound> find_fallback_rounds(const Input& input);

} // namespace director::analysis
