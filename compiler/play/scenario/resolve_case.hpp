#pragma once
// SPDX-License-Identifier: MIT
// Resolves one case of a script for one provider or handler. Findings are added to the list of `names`.

#include "compiler/play/scenario/names.hpp"

namespace director::compiler {

Case resolve_case(const dsl::CaseSpec& spec, ProviderId provider, Names& names);

/// The provider of a promise with a time limit, by the trigger that fires when it is broken: `Walk.halting.broken`.
std::optional<ProviderId> find_promise(const Model& model, std::string_view trigger);

/// `which`: "start" or "stop"; `handler` is that of the group. The reader ensures that its cases have `data`, `run` and
/// `set` only.
Case resolve_handler_case(const dsl::CaseSpec& spec, GroupId group, std::string_view which, const Handler& handler,
                          Names& names);

/// The default for a provider without a script: the first pack, or all tasks, at their first level.
Case unscripted(const Model& model, ProviderId provider);

} // namespace director::compiler
