#pragma once
// SPDX-License-Identifier: MIT
// One case of a script, as one provider or handler would act on it. Findings go to where `names` writes them.

#include "compiler/play/names.hpp"

namespace director::compiler {

Case resolve_case(const dsl::CaseSpec& spec, ProviderId provider, Names& names);

/// `which`: "start" or "stop"; `handler` is that of the group. Its cases have `data`, `run` and `set` only: the reader
/// sees to that.
Case resolve_handler_case(const dsl::CaseSpec& spec, GroupId group, std::string_view which, const Handler& handler,
                          Names& names);

/// What a provider does that the script says nothing about: the first pack, or all tasks, at their first level.
Case unscripted(const Model& model, ProviderId provider);

} // namespace director::compiler
