#pragma once
// SPDX-License-Identifier: MIT
// What several checks tell in notes, each at the place where it is written.

#include "compiler/analysis/chains/step.hpp"
#include "dsl/diagnostic.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// A chain: one note for each step, of a long one for the first and last few. `begins`: whether it goes on from the
/// note before.
void add_chain(const Model& model, const std::vector<ChainStep>& chain, std::vector<dsl::Note>& notes,
               dsl::Note::Link begins = dsl::Note::Link::first);

/// Where one group requests another, first with a mandatory level; `Span{}`: it does not.
dsl::Span request_span(const Model& model, GroupId from, GroupId to);

/// The provider promises what satisfies the condition.
dsl::Note causes(const Model& model, ProviderId causer, ConditionId condition);

/// The condition is one of the provider's `when`.
dsl::Note runs_only_while(const Model& model, ProviderId provider, const ConditionUse& condition);

/// Of many notes the first ones, how many more there are, and the last one, on which the others may rest: who reads
/// more of them than this reads them in the file. `most` is 2 or more.
constexpr std::size_t most_notes = 40;
void shorten(std::vector<dsl::Note>& notes, std::size_t most = most_notes);
/// Of those that say the same of many, as of all that ask for one group, the first ones and how many more there are:
/// none of them matters more than another, and so the next thing is told of too.
constexpr std::size_t most_alike = 8;
void shorten_list(std::vector<dsl::Note>& notes, std::size_t most = most_alike);

} // namespace director::analysis
