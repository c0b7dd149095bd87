// Header: compiler/transitions/player.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/player.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::transitions {

namespace {

Lowered with_stops(Lowered lowered) {
  for (director::Group& group : lowered.groups) group.stop = true;
  return lowered;
}

} // namespace

Player::Player(const Model& model, const Lowered& lowered, const std::string& behaviour)
    : model_(model),
      lowered_(with_stops(lowered)),
      head_(fmt::format("scenario: transition\nbehaviour: {}\n", behaviour)) {}

Play Player::play(Script script, std::string steps, std::uint32_t from, const Way& way) const {
  std::string text = head_ + (script.empty() ? "" : "script:\n");
  for (const auto& [id, cases] : script) text += entry_text(model_, id, cases);
  work_ += text.size() + steps.size() + model_.groups.size();
  Trial trial = play_trial(text + steps, model_, lowered_, from, way);
  work_ += trial.work / 5; // it takes a fifth of the time of a character
  return {std::move(script), std::move(steps), std::move(trial)};
}

std::string Player::beginning(const Way& way, const Outside& outside) const {
  return given_text(model_, outside.given) + "steps:\n" + request_step(model_, way, outside.values);
}

std::vector<GroupId> Player::lost(const Beginning& row, const Rest& rest) const {
  const EdgeId edge = row.way.last().edge;
  std::vector<GroupId> out;
  for (const GroupId id : model_.groups.ids()) {
    const Rest::Held& before = row.rest.groups[id.value];
    if (!before.active || !row.rest.is_under(model_, id, edge)) continue;
    // What has stopped may be held for a need, and by the same edge.
    if (!rest.is_under(model_, id, edge) || (before.granted && !rest.groups[id.value].granted)) out.push_back(id);
  }
  return out;
}

std::vector<GroupId> Player::needs_taken(const Beginning& row, const Trial& trial) const {
  const EdgeId edge = row.way.last().edge;
  const auto is_taken = [&](GroupId id) {
    return std::any_of(trial.events.begin(), trial.events.end(), [&](const Event& event) {
      return event.kind == Event::Kind::grant && event.group == id.value && event.other != nil &&
             EdgeId{event.other} == row.rest.groups[id.value].by;
    });
  };
  std::vector<GroupId> out;
  for (const GroupId id : model_.groups.ids()) {
    const Rest::Held& before = row.rest.groups[id.value];
    if (before.by && !before.active && row.rest.is_under(model_, id, edge) && trial.rest.groups[id.value].by &&
        !trial.rest.is_under(model_, id, edge) && is_taken(id))
      out.push_back(id);
  }
  return out;
}

std::vector<GroupId> Player::interrupted(const Beginning& row, const Trial& trial) const {
  const EdgeId edge = row.way.last().edge;
  std::vector<GroupId> out;
  for (const GroupId id : model_.groups.ids()) {
    if (row.rest.groups[id.value].granted && row.rest.is_under(model_, id, edge) && has_stopped(trial, id) &&
        trial.rest.groups[id.value].granted)
      out.push_back(id);
  }
  return out;
}

bool Player::ends_by(const Beginning& row, const Beginning& column, const Values& change,
                     const std::vector<GroupId>& all) const {
  if (change.empty()) return false;
  // What the values let run on the way to the column answers as in the play of both.
  if (!ends_with(row, column, column.way, change, all)) return false;
  // Where it may go on requesting the row's task instead, its body ends that, and not the values.
  const std::optional<Way> kept = way_on(row.way, column.way);
  return !kept || ends_with(row, column, *kept, change, all);
}

std::optional<Way> Player::way_on(const Way& row, const Way& column) const {
  for (std::size_t i = 0; i < std::min(row.links.size(), column.links.size()); ++i) {
    const Link &first = row.links[i], &second = column.links[i];
    if (row.group(i) != column.group(i)) return {};
    if (first.provider == second.provider) continue;
    const std::vector<Pack>& packs = model_.providers[second.provider].packs;
    for (std::size_t pack = 0; pack < packs.size(); ++pack) {
      for (const Task& task : packs[pack].tasks) {
        if (task.edge != first.next->edge) continue;
        Way out = row;
        out.links[i] = {second.provider, pack, &task};
        return out;
      }
    }
    return {};
  }
  return {};
}

bool Player::ends_with(const Beginning& row, const Beginning& column, const Way& then, const Values& change,
                       const std::vector<GroupId>& all) const {
  const std::string steps = beginning(row.way, row.outside) + settings_step(model_, change);
  // A promise that undid the values would hide what they end.
  const Until until = row.until(change);
  Script script = script_of(model_, row.way, until);
  const Script both = script_of(model_, row.way, then, until);
  for (const Link& link : then.links) {
    const auto same = [&](const Link& each) { return each.provider == link.provider; };
    if (std::none_of(row.way.links.begin(), row.way.links.end(), same)) script[link.provider] = both.at(link.provider);
  }
  const Play alone = play(std::move(script), steps, 2, row.way);
  if (!alone.trial.good) return false;
  // The values may let the column run too: then it takes what is blocked, and not the values.
  if (runs_at_all(alone.trial.rest, column.way) && !runs_at_all(row.rest, column.way) &&
      is_blocked(row, alone.trial.rest, all))
    return false;
  if (!runs(alone.trial.rest, row.way)) return true;
  std::vector<GroupId> ended = lost(row, alone.trial.rest);
  const std::vector<GroupId> again = interrupted(row, alone.trial);
  ended.insert(ended.end(), again.begin(), again.end());
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](GroupId id) {
    return std::find(ended.begin(), ended.end(), id) != ended.end();
  });
}

bool Player::is_blocked(const Beginning& row, const Rest& rest, const std::vector<GroupId>& all) const {
  const auto blocked = [&](EdgeId edge) { return rest.blocked[edge.value]; };
  if (!runs(rest, row.way))
    return std::any_of(row.way.links.begin(), row.way.links.end(), // nothing else is requested at root
                       [&](const Link& link) { return blocked(link.next->edge); });
  return std::any_of(all.begin(), all.end(), [&](GroupId id) {
    const std::optional<EdgeId> by = row.rest.groups[id.value].by;
    return by && blocked(*by);
  });
}

bool runs(const Rest& rest, const Way& way) { return rest.running[way.last().edge.value]; }

bool runs_at_all(const Rest& rest, const Way& way) { return rest.groups[way.target.value].granted; }

} // namespace director::compiler::transitions
