// Header: compiler/play/why/why.hpp. Test: tests/compiler/cli/commands/why_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/why/why.hpp"

#include "compiler/lower/row_names.hpp"
#include "dsl/source/colours.hpp"
#include "dsl/source/harmless.hpp"
#include "runtime/hosted/trace/event_text.hpp"
#include "runtime/hosted/why_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace director::compiler {

namespace {

/// The places of the specification that notes are about.
class Places {
public:
  Places(const View& view, const Because& because, const Model& model, const Lowered& lowered)
      : view_(view),
        because_(because),
        model_(model),
        lowered_(lowered),
        tables_(*view.tables) {}

  Span of(const WhyNote& note) const {
    switch (note.about) {
    case WhyNote::About::edge: return note.row < tables_.edges.size() ? edge(EdgeId{note.row}) : Span{};
    case WhyNote::About::condition: return condition(note.row);
    case WhyNote::About::state: return model_.states[StateId{note.row}].name.span;
    case WhyNote::About::provider: return model_.providers[ProviderId{note.row}].span;
    }
    return {};
  }

private:
  /// The place of the request, or of the need, in the active provider of its requester, otherwise where it is declared
  /// first.
  Span edge(EdgeId id) const {
    const Edge& edge = model_.edges[id];
    const Index active = edge.requester ? view_.assignment[edge.requester->value].active : nil;
    if (active == nil) return edge.span;
    const Provider& provider = model_.providers[ProviderId{active}];
    if (!view_.requested(static_cast<Index>(id.value))) {
      for (const Use<GroupId>& need : provider.needs) {
        if (need.id == edge.target) return need.span;
      }
    }
    const std::ptrdiff_t requested = count_requested(*edge.requester);
    for (const bool whole : {true, false}) {
      for (const Pack& pack : provider.packs) {
        if (whole && !is_requested(pack, requested)) continue;
        for (const Task& task : pack.tasks) {
          if (task.edge == id && (whole || has_level(task))) return task.span;
        }
      }
    }
    return edge.span;
  }

  /// Whether the task may be requested at the level at which it is; if it is not requested, at any.
  bool has_level(const Task& task) const {
    const auto row = static_cast<Index>(task.edge.value);
    if (!view_.requested(row)) return true;
    const Index level = view_.request[row].level - tables_.edges[row].levels.begin;
    return std::any_of(task.levels.begin(), task.levels.end(),
                       [&](const Task::NamedLevel& each) { return each.level == level; });
  }

  /// How many tasks the group requests.
  std::ptrdiff_t count_requested(GroupId requester) const {
    const std::vector<EdgeId>& edges = model_.groups[requester].edges;
    return std::count_if(edges.begin(), edges.end(),
                         [&](EdgeId id) { return view_.requested(static_cast<Index>(id.value)); });
  }

  /// Whether this pack is what its group requests, which are so many tasks. A pack has a task once.
  bool is_requested(const Pack& pack, std::ptrdiff_t count) const {
    for (const Task& task : pack.tasks) {
      const bool requested = view_.requested(static_cast<Index>(task.edge.value));
      if (requested && has_level(task)) --count;
      if (!requested && !model_.may_be_left_out(task)) return false;
    }
    return count == 0;
  }

  /// The place of the condition in the waiting provider, otherwise of its state.
  Span condition(Index row) const {
    const ConditionId id = lowered_.condition_ids[row];
    if (because_.provider != nil) {
      for (const ConditionUse& use : model_.providers[ProviderId{because_.provider}].when) {
        if (use.id == id) return use.span;
      }
    }
    return model_.states[model_.conditions[id].state].name.span;
  }

  const View& view_;
  const Because& because_;
  const Model& model_;
  const Lowered& lowered_;
  const Tables& tables_;
};

std::string place(const Span& span, const dsl::Sources& sources) {
  const dsl::SourceFile& file = sources[span.file];
  return fmt::format("{}:{}", file.path(), file.place(span.begin).line);
}

} // namespace

Reasoning reason_why(const View& view, GroupId group, const Model& model, const Lowered& lowered) {
  return reason_why(view, why(view, static_cast<Index>(group.value)), model, lowered, RowNames(model, lowered).names());
}

std::string text_why(const View& view, GroupId group, const Model& model, const Lowered& lowered) {
  return director::to_text(why(view, static_cast<Index>(group.value)), RowNames(model, lowered).names());
}

std::string text_why(const View& view, EdgeId request, const Model& model, const Lowered& lowered) {
  return director::to_text(why_refused(view, static_cast<Index>(request.value)), RowNames(model, lowered).names());
}

Reasoning reason_why(const View& view, const Because& because, const Model& model, const Lowered& lowered,
                     const director::Names& names) {
  Reasoning out;
  out.group = model.groups[GroupId{because.asked}].name.value;
  out.kind = name_of(because.kind);
  out.text = director::to_text(because, names);
  const Places places(view, because, model, lowered);
  for (WhyNote& note : why_notes(view, because, names)) {
    const Span span = places.of(note);
    out.notes.push_back({std::move(note.text), span});
  }
  return out;
}

std::string to_text(const Reasoning& reasoning, const dsl::Sources& sources, bool has_colours) {
  std::string out = dsl::painted(dsl::harmless(reasoning.text), dsl::colours::bold, has_colours) + "\n";
  for (const Reasoning::Note& note : reasoning.notes)
    out += fmt::format("  {} ({})\n", dsl::harmless(note.text),
                       dsl::painted(dsl::harmless(place(note.span, sources)), dsl::colours::cyan, has_colours));
  return out;
}

Json to_json(const Reasoning& reasoning, const dsl::Sources& sources) {
  Json notes = Json::list({});
  for (const Reasoning::Note& note : reasoning.notes)
    notes.add(Json::object({{"text", Json::text(note.text)}, {"place", Json::text(place(note.span, sources))}}));
  return Json::object({{"group", Json::text(reasoning.group)},
                       {"kind", Json::text(reasoning.kind)},
                       {"text", Json::text(reasoning.text)},
                       {"notes", std::move(notes)}});
}

} // namespace director::compiler
