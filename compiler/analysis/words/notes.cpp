// Header: compiler/analysis/words/notes.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/notes.hpp"

#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace director::analysis {

using dsl::Note;

namespace {

/// Limit: a longer chain is easier to read in the file.
constexpr std::size_t most_steps_in_notes = 12;

/// Makes the first note that is left out count all of them.
void leave_out(Note& first, std::size_t count, std::string_view where) {
  first.message = fmt::format("and {} more of such notes, {}", count, where);
  first.link = Note::Link::aside;
}

} // namespace

void add_chain(const Model& model, const std::vector<ChainStep>& chain, std::vector<Note>& notes, Note::Link begins) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainStep& step = chain[i];
    if (chain.size() > most_steps_in_notes && i == most_steps_in_notes / 2) {
      const std::size_t left_out = chain.size() - most_steps_in_notes;
      notes.push_back({step.span,
                       fmt::format("{} more steps lead from {} to {}", left_out, name_of(model, step.from),
                                   name_of(model, chain[i + left_out - 1].to)),
                       begins});
      i += left_out - 1;
      continue;
    }
    notes.push_back({step.span,
                     fmt::format("{} {} {}", name_of(model, step.from), step.by_need ? "needs" : "requests",
                                 name_of(model, step.to)),
                     begins});
    begins = Note::Link::next;
  }
}

Span request_span(const Model& model, GroupId from, GroupId to) {
  Span first{};
  for (const ProviderId provider : model.groups[from].providers) {
    for (const Pack& pack : model.providers[provider].packs) {
      for (const Task& task : pack.tasks) {
        if (task.target != to) continue;
        const std::vector<Level>& levels = model.edges[task.edge].levels;
        if (std::any_of(task.levels.begin(), task.levels.end(),
                        [&](const Task::NamedLevel& named) { return !levels[named.level].optional; }))
          return task.span;
        if (first == Span{}) first = task.span;
      }
    }
  }
  return first;
}

dsl::Note causes(const Model& model, ProviderId causer, ConditionId condition) {
  const ConditionUse& promise = promise_of(model, causer, condition);
  return {promise.span, fmt::format("{} causes {}", name_of(model, causer), name_of(model, promise.id))};
}

void add_once(dsl::Note note, std::vector<dsl::Note>& notes) {
  const auto same = [&](const dsl::Note& other) { return other.span == note.span && other.message == note.message; };
  if (std::none_of(notes.begin(), notes.end(), same)) notes.push_back(std::move(note));
}

RequestEntry find_entry(const Model& model, ProviderId provider, GroupId group) {
  for (const Pack& pack : model.providers[provider].packs) {
    for (const Task& task : pack.tasks) {
      if (task.target == group) return {&pack, &task};
    }
  }
  return {};
}

dsl::Note requests(const Model& model, ProviderId provider, const Task& task) {
  return {task.span, fmt::format("{} requests {}", name_of(model, provider), name_of(model, task.target))};
}

dsl::Note runs_only_while(const Model& model, ProviderId provider, const ConditionUse& condition) {
  return {condition.span, fmt::format("{} runs only while {}", name_of(model, provider), name_of(model, condition.id))};
}

void shorten(std::vector<Note>& notes, std::size_t most) {
  if (notes.size() <= most) return;
  leave_out(notes[most - 2], notes.size() - (most - 1), "before the last one");
  notes[most - 1] = std::move(notes.back());
  if (notes[most - 1].link == Note::Link::next) notes[most - 1].link = Note::Link::aside;
  notes.resize(most);
}

void shorten_list(std::vector<Note>& notes, std::size_t most) {
  if (notes.size() <= most) return;
  leave_out(notes[most - 1], notes.size() - (most - 1), "from here on");
  notes.resize(most);
}

} // namespace director::analysis
