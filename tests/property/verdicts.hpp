#pragma once
// SPDX-License-Identifier: MIT
// What findings say never happens, in terms of an exploration; and for what was never reached, what it depends on.

#include "dsl/source/diagnostic.hpp"
#include "tests/property/reached.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace director::property {

/// This provider never runs.
struct NeverRuns {
  compiler::ProviderId provider{};
};
/// The target of this edge is never granted for it.
struct NeverGranted {
  compiler::EdgeId edge{};
};
/// The provider is never pushed for the condition; `to_effect`: or does not run while the task waits, as if its group
/// is in one unit with it, so that the push has no effect.
struct NeverPushed {
  compiler::ProviderId provider{};
  compiler::ConditionId condition{};
  bool to_effect = false;
};
/// The members of a pack, a row of whole_packs(), are never granted together.
struct NeverWhole {
  std::size_t pack = 0;
};
/// While the provider runs and `edge` is requested, the task `loser` below that is never granted, because of the group.
struct NeverBelow {
  compiler::ProviderId provider{};
  compiler::EdgeId edge{}, loser{};
  compiler::GroupId group{};
};
/// No provider of the group runs while each of these states has one of these values.
struct NeverWhile {
  struct Part {
    compiler::StateId state{};
    compiler::ValueSet values;
    bool unset = false;
  };
  compiler::GroupId group{};
  std::vector<Part> parts;
};

/// Once none of these holds, none ever holds again.
struct NeverBack {
  std::vector<compiler::ConditionId> conditions;
};

using Claim = std::variant<NeverRuns, NeverGranted, NeverPushed, NeverWhole, NeverBelow, NeverWhile, NeverBack>;

/// The claims of a finding, each by itself; none if it claims nothing that could be reached.
std::vector<Claim> claims_of(const dsl::Diagnostic& finding, const compiler::Model& model);

/// Providers that it says cannot run with the current declarations, without saying never.
std::vector<compiler::ProviderId> hints_of(const dsl::Diagnostic& finding, const compiler::Model& model);

/// Tasks that it says are kept from a group by another requester, without saying never.
std::vector<compiler::EdgeId> losers_of(const dsl::Diagnostic& finding, const compiler::Model& model);

/// States that it says never have some of their values.
std::vector<compiler::StateId> lacking_of(const dsl::Diagnostic& finding, const compiler::Model& model);

/// None of them holds.
bool are_lost(const NeverBack& claim, const compiler::Model& model, const std::vector<std::int32_t>& values);

bool is_contradicted(const Claim& claim, const compiler::Model& model, const Reached& reached);
std::string in_words(const Claim& claim, const compiler::Model& model);

/// Conditions that no declaration satisfies, and needs without a plan, are errors, reported at their declaration. The
/// checks take them as corrected, and do not report what follows from them; with the current declarations it cannot
/// happen, and depends on them.
struct FollowOn {
  std::vector<compiler::ProviderId> idle, unpushed;
  std::vector<compiler::EdgeId> ungranted;
  std::vector<std::pair<compiler::ProviderId, std::size_t>> unwhole;                ///< packs
  std::vector<std::pair<compiler::ProviderId, compiler::ConditionId>> unpushed_for; ///< for this condition
};
FollowOn follow_on_of(const compiler::Model& model);

/// What was never reached.
struct Unreached {
  std::string kind;      ///< "provider", "task", "push" or "pack", and its kind
  std::string what;      ///< its name
  bool reported = false; ///< by a finding about it or about what it depends on
};
std::vector<Unreached> unreached_of(const compiler::Model& model, const Reached& reached,
                                    const std::vector<dsl::Diagnostic>& findings);

} // namespace director::property
