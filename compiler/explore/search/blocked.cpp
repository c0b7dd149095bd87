// Header: compiler/explore/search/blocked.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/search/blocked.hpp"

#include "compiler/explore/search/watch.hpp"

#include <fmt/format.h>

#include <string_view>

namespace director::compiler {

namespace {

/// `Sonar`, in backquotes.
std::string target_of(Index edge, const Model& model) {
  return fmt::format("`{}`", model.groups[model.edges[EdgeId{edge}].target].name.value);
}

/// Likewise; the program requests what has no requester. `wanted`: by the group; it is above a side that it wants.
/// `where`: it is, as seen from the side, unless it is the side.
std::string with_side(std::optional<GroupId> group, GroupId wanted, GroupId side, const Model& model,
                      std::string_view where = "below") {
  if (!group) return "the program";
  const std::string name = fmt::format("`{}`", model.groups[*group].name.value);
  if (*group == side || wanted == side) return name;
  return fmt::format("{}, {} `{}`,", name, where, model.groups[side].name.value);
}

} // namespace

std::optional<Blocked> blocked_by(const Engine& engine, Index edge, Index loser) {
  const Tables& t = engine.tables();
  Blocked out{why_refused(view_of(engine), edge)};
  const Because& because = out.because;
  const bool is_held = because.kind == Because::Kind::lost || because.kind == Because::Kind::need_held;
  if (!is_held || because.holder >= t.edges.size()) return {};
  if (because.group != loser && !under(engine, because.holder, loser)) return {};
  for (Index at = because.member; at < t.edges.size() && out.optional == nil;) {
    const Index level = engine.memory().request[at].level;
    if (level != nil && t.levels[level].optional) out.optional = at;
    const Index requester = t.edges[at].requester;
    at = requester == nil || requester == because.rivalry.common ? nil : engine.holder(requester);
  }
  return out;
}

std::string words_of(const Blocked& blocked, const Assertion& beats, const Model& model) {
  const Because& because = blocked.because;
  const Edge &wanted = model.edges[EdgeId{because.member}], &held = model.edges[EdgeId{because.holder}];
  const bool is_need = because.kind == Because::Kind::need_held;
  const GroupId group{because.group};
  const GroupId loser = beats.groups.front().id, winner = beats.groups.back().id;
  // A task that is requested in one unit with the loser is not below it, nor is the requester of both.
  const bool is_beside = because.member != because.edge && model.edges[EdgeId{because.edge}].target == loser;
  const std::string who = is_need
                              ? with_side(wanted.target, group, loser, model, is_beside ? "requested with" : "below")
                              : with_side(wanted.requester, wanted.target, loser, model, is_beside ? "above" : "below");
  const std::string by = held.requester ? with_side(held.requester, held.target, winner, model) + " holds"
                                        : std::string("runs for the program");
  return fmt::format("{} does not get `{}`, which {}", who, model.groups[group].name.value, by);
}

std::vector<dsl::Note> notes_of(const Blocked& blocked, const Model& model) {
  const Because& because = blocked.because;
  const Rivalry& rivalry = because.rivalry;
  std::vector<dsl::Note> out;
  const auto add = [&](Index edge, std::string words) {
    dsl::Note note;
    note.span = model.edges[EdgeId{edge}].span;
    note.message = std::move(words);
    out.push_back(std::move(note));
  };
  if (const std::optional<GroupId> holder = model.edges[EdgeId{because.holder}].requester)
    add(because.holder,
        fmt::format("`{}` holds {}", model.groups[*holder].name.value, target_of(because.holder, model)));
  if (rivalry.ours == nil || rivalry.theirs == nil) return out;
  const std::string ours = target_of(rivalry.ours, model), theirs = target_of(rivalry.theirs, model);
  switch (rivalry.won_by) {
  case Precedence::above: break;
  case Precedence::optional:
    if (blocked.optional == nil) break;
    add(blocked.optional, fmt::format("{} is optional here, so it goes after all that is mandatory, whatever the "
                                      "priorities are",
                                      target_of(blocked.optional, model)));
    break;
  case Precedence::priority:
    add(rivalry.theirs, fmt::format("{}, with priority {}, goes before {}, with priority {}", theirs,
                                    rivalry.their_priority, ours, rivalry.our_priority));
    break;
  case Precedence::equal:
    add(rivalry.theirs, fmt::format("{} and {} are equal, so neither takes anything from the other", theirs, ours));
    break;
  }
  return out;
}

} // namespace director::compiler
