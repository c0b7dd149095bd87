// Door: compiler/play/why.hpp. Test: tests/compiler/cli/why_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/why.hpp"

#include "compiler/lower/row_names.hpp"
#include "dsl/colours.hpp"
#include "runtime/core/inspect/why_text.hpp"

#include <fmt/format.h>

#include <array>

namespace director::compiler {

namespace {

constexpr std::array<std::string_view, 11> kinds{"running",   "not_requested", "no_provider", "lost",
                                                 "need_held", "together",      "condition",   "outdated",
                                                 "deferred",  "reserved",      "limbo"};

class Reasoner {
public:
  Reasoner(const View& view, const Model& model, const Lowered& lowered)
      : v_(view),
        t_(*view.tables),
        model_(model),
        lowered_(lowered) {}

  std::vector<Reasoning::Note> notes(const Because& because) {
    switch (because.kind) {
    case Because::Kind::condition: condition(because); break;
    case Because::Kind::lost:
    case Because::Kind::need_held: chain(because.holder, "it is held for"); break;
    case Because::Kind::running: chain(because.edge, "it runs for"); break;
    case Because::Kind::reserved: chain(because.holder, "it is held for"); break;
    case Because::Kind::no_provider: disabled(because.group); break;
    case Because::Kind::not_requested: requesters(because.asked); break;
    default: break;
    }
    return std::move(notes_);
  }

private:
  void say(std::string text, const Span& span) { notes_.push_back({std::move(text), span}); }

  /// Who requested what, up to the program.
  void chain(Index edge, std::string_view word) {
    std::string text(word);
    const Span span = edge < t_.edges.size() ? model_.edges[EdgeId{edge}].span : Span{};
    for (std::string_view between = " "; edge != nil && !v_.is_limbo(edge); between = ", that for ") {
      const Index requester = t_.edges[edge].requester;
      if (requester == nil) {
        text += fmt::format("{}the program, priority {}", between, priority(edge));
        break;
      }
      text += fmt::format("{}{}, priority {}", between, model_.groups[GroupId{requester}].name.value, priority(edge));
      edge = v_.holder(requester);
    }
    say(std::move(text), span);
  }

  std::int32_t priority(Index edge) const {
    if (v_.requested(edge)) return t_.levels[v_.request[edge].level].priority;
    const Range levels = t_.edges[edge].levels;
    return levels.empty() ? 0 : t_.levels[levels.begin].priority;
  }

  void condition(const Because& because) {
    const ConditionId id = lowered_.condition_ids[because.condition];
    const Condition& condition = model_.conditions[id];
    const State& state = model_.states[condition.state];
    const std::int32_t value = v_.values[condition.state.value].value;
    Span span = state.name.span;
    if (because.provider != nil) {
      const Provider& waiting = model_.providers[ProviderId{because.provider}];
      for (const ConditionUse& use : waiting.when) {
        if (use.id == id) span = use.span;
      }
    }
    say(value == unset ? fmt::format("{} is unset", state.name.value)
                       : fmt::format("{} is {}", state.name.value, state.value_text(value)),
        span);
    for (const Index row : causers(t_, because.condition)) causer(ProviderId{row}, because);
    if (state.external) say(fmt::format("the outside may set {}", state.name.value), state.name.span);
  }

  /// What a provider that promises the condition does about it.
  void causer(ProviderId id, const Because& because) {
    const Index group = model_.providers[id].group.value;
    const GroupAssignment& standing = v_.assignment[group];
    const std::string name = model_.full_name(id);
    std::string text;
    if (v_.enabled[id.value] == 0) {
      text = fmt::format("{} could cause it, and is disabled", name);
    } else if (standing.active == id.value && (standing.flags & flag::in_force) != 0) {
      text = fmt::format("{} is to cause it: pushed for {}", name, model_.edge_name(EdgeId{standing.push.edge}));
    } else if (standing.active == id.value) {
      text = fmt::format("{} could cause it, and runs", name);
    } else if (!is_requested(group)) {
      text = fmt::format("{} could cause it, but nobody asks for {}", name, model_.groups[GroupId{group}].name.value);
    } else if (!standing.granted()) {
      text = fmt::format("{} could cause it, but {} waits itself", name, model_.groups[GroupId{group}].name.value);
    } else {
      text = fmt::format("{} could cause it, and is not pushed for {}", name, model_.edge_name(EdgeId{because.edge}));
    }
    say(std::move(text), model_.providers[id].span);
  }

  bool is_requested(Index group) const {
    for (const Index edge : t_.list(t_.groups[group].requesters)) {
      if (v_.requested(edge)) return true;
    }
    return false;
  }

  void disabled(Index group) {
    for (const ProviderId id : model_.groups[GroupId{group}].providers) {
      if (v_.enabled[id.value] == 0)
        say(fmt::format("{} is disabled", model_.full_name(id)), model_.providers[id].span);
    }
  }

  void requesters(Index group) {
    for (const Index edge : t_.list(t_.groups[group].requesters)) {
      const Index requester = t_.edges[edge].requester;
      const Span span = model_.edges[EdgeId{edge}].span;
      if (requester == nil) {
        say("the program may", span);
      } else {
        const std::string& name = model_.groups[GroupId{requester}].name.value;
        const bool lives = v_.assignment[requester].active != nil;
        say(fmt::format("{} may, {}", name, lives ? "and does not ask now" : "and does not run"), span);
      }
    }
  }

  const View& v_;
  const Tables& t_;
  const Model& model_;
  const Lowered& lowered_;
  std::vector<Reasoning::Note> notes_;
};

std::string place(const Span& span, const dsl::Sources& sources) {
  const dsl::SourceFile& file = sources[span.file];
  return fmt::format("{}:{}", file.path(), file.place(span.begin).line);
}

} // namespace

Reasoning reason_why(const View& view, GroupId group, const Model& model, const Lowered& lowered) {
  const Because because = why(view, static_cast<Index>(group.value));
  const RowNames names(model, lowered);
  std::string buffer(4096, '\0');
  Reasoning out;
  out.group = model.groups[group].name.value;
  out.kind = kinds[static_cast<std::size_t>(because.kind)];
  out.text = to_text(because, names.names(), buffer);
  out.notes = Reasoner(view, model, lowered).notes(because);
  return out;
}

std::string to_text(const Reasoning& reasoning, const dsl::Sources& sources, bool has_colours) {
  std::string out = dsl::painted(reasoning.text, dsl::colours::bold, has_colours) + "\n";
  for (const Reasoning::Note& note : reasoning.notes)
    out +=
        fmt::format("  {} ({})\n", note.text, dsl::painted(place(note.span, sources), dsl::colours::cyan, has_colours));
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
