// Header: compiler/page/facts/ruling.hpp. Test: tests/compiler/page/facts/ranks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/facts/ruling.hpp"

#include "compiler/analysis/words/words.hpp"
#include "compiler/page/facts/task_relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace director::compiler {

namespace {

const std::string& target_name(const Model& model, EdgeId id) {
  return model.groups[model.edges[id].target].name.value;
}

/// `Kick (priority 20)`
std::string request_words(const Model& model, EdgeId id, const analysis::SideRank& rank) {
  const std::vector<Level>& levels = model.edges[id].levels;
  const bool itself = std::any_of(levels.begin(), levels.end(), [&](const Level& level) {
    return level.optional && level.priority == rank.priority;
  });
  return fmt::format("{} ({}{})", target_name(model, id),
                     levels.empty() ? "needed" : fmt::format("priority {}", rank.priority),
                     !rank.optional ? ""
                     : itself       ? ", optional"
                                    : ", something below it optional");
}

/// For equals.
std::string requested_first(const Model& model, EdgeId member, const Ruling::Side& side) {
  if (side.leaders.empty()) return "";
  const std::string& task = target_name(model, member);
  return fmt::format("; of two that request it, {} goes first where {}{}",
                     side.needs ? "what " + task + " needs" : task, side.needs ? task + " is " : "",
                     together_words(model, side.leaders));
}

/// `Play runs only with it`; of a group some of whose providers do not need it, `Play.near and Play.far run ...`.
std::string needs_it(const Model& model, GroupId requester, GroupId needed) {
  const Group& group = model.groups[requester];
  std::vector<std::string> those;
  for (const ProviderId id : group.providers) {
    if (model.providers[id].needs_group(needed))
      those.push_back(fmt::format("{}.{}", group.name.value, model.providers[id].name));
  }
  if (those.size() == group.providers.size()) those = {group.name.value};
  return fmt::format("{} {} only with it", analysis::few_of(those), those.size() == 1 ? "runs" : "run");
}

} // namespace

std::string together_words(const Model& model, const std::vector<Leader>& leaders) {
  std::string out;
  for (const Leader& each : leaders)
    out += fmt::format("{}{} (priority {}{})", out.empty() ? "" : " or ", target_name(model, each.edge), each.priority,
                       each.if_older ? ", if older" : "");
  return "granted together with " + out;
}

std::string words_of(const Model& model, const Ruling& ruling) {
  constexpr std::string_view never_both = ", never both at once";
  const analysis::Decision& decision = ruling.decision;
  const TaskRelation both = relation_of(model, decision);
  const int order = ruling.order();
  const std::string requester = decision.requester ? model.groups[*decision.requester].name.value : "the program";
  std::string first = request_words(model, decision.first_sibling, decision.first);
  std::string second = request_words(model, decision.second_sibling, decision.second);
  EdgeId ahead = decision.first_sibling, behind = decision.second_sibling;
  if (order > 0) std::swap(first, second), std::swap(ahead, behind);
  const Ruling::Side &winner = order > 0 ? ruling.second : ruling.first,
                     &loser = order > 0 ? ruling.first : ruling.second;
  const auto part = [](const std::string& task, const Ruling::Side& side) {
    return side.needs ? "what " + task + " needs" : side.asks ? "what " + task + " requests" : task;
  };
  const std::string held = part(first, winner), rest = part(second, loser);
  switch (winner.held) {
  case Ruling::Held::in_unit:
    return fmt::format("{}: {} before {}, as both are granted together", requester, held, rest);
  case Ruling::Held::as_need:
    return fmt::format("{}: {} before {}, as {}{}", requester, held, rest,
                       needs_it(model, *decision.requester, model.edges[ahead].target),
                       (order > 0 ? both.second_own : both.first_own) ? "" : never_both);
  case Ruling::Held::by_leader:
    return fmt::format("{}: {} before {}, as {} is {}", requester, held, second, target_name(model, ahead),
                       together_words(model, winner.leaders));
  case Ruling::Held::by_rank: break;
  }
  std::string out = fmt::format("{}: {} {} {}{}{}{}", requester, first, order == 0 ? "and" : "before", second,
                                order == 0 ? " are equal" : "", both.unit ? ", together or not at all" : "",
                                both.at_once ? "" : never_both);
  if (order != 0 && !loser.leaders.empty())
    out += ", unless " + target_name(model, behind) + " is " + together_words(model, loser.leaders);
  if (order == 0) out += requested_first(model, ahead, winner) + requested_first(model, behind, loser);
  return out;
}

} // namespace director::compiler
