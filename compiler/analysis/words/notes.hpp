#pragma once
// SPDX-License-Identifier: MIT
// Notes that several checks use, each at the place of the declaration.

#include "compiler/analysis/chains/step.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// A chain: one note for each step, of a long one for the first and last few. `begins`: whether it continues from the
/// note before.
void add_chain(const Model& model, const std::vector<ChainStep>& chain, std::vector<dsl::Note>& notes,
               dsl::Note::Link begins = dsl::Note::Link::first);

/// Adds the note unless it is there already.
void add_once(dsl::Note note, std::vector<dsl::Note>& notes);

/// The place where one group requests another, preferably with a mandatory level; `Span{}`: it does not.
dsl::Span request_span(const Model& model, GroupId from, GroupId to);

/// The first entry by which a provider requests a group. `task` is null: it does not.
struct RequestEntry {
  const Pack* pack = nullptr;
  const Task* task = nullptr;
};
RequestEntry find_entry(const Model& model, ProviderId provider, GroupId group);

/// A note: the provider requests the task of this entry.
dsl::Note requests(const Model& model, ProviderId provider, const Task& task);

/// A note: the provider promises what satisfies the condition.
dsl::Note causes(const Model& model, ProviderId causer, ConditionId condition);

/// A note: the condition is one of the provider's `when`.
dsl::Note runs_only_while(const Model& model, ProviderId provider, const ConditionUse& condition);

/// Keeps the first notes, the count of the rest, and the last one, on which others may depend: a longer list is easier
/// to read in the file. `most` is 2 or more.
constexpr std::size_t most_notes = 40;
void shorten(std::vector<dsl::Note>& notes, std::size_t most = most_notes);
/// Keeps the first of equivalent notes, as of all that request one group, and counts the rest: none of them matters
/// more than another, and the next note gets its place.
constexpr std::size_t most_alike = 8;
void shorten_list(std::vector<dsl::Note>& notes, std::size_t most = most_alike);

} // namespace director::analysis
