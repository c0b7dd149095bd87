// Header: compiler/page/ranks.hpp. Test: tests/compiler/page/ranks_test.cpp. Schema: schemas/graph.schema.json.
// SPDX-License-Identifier: MIT
//
// Two groups mostly part at the same few requesters as others do, and in the same ways, so what decides is written
// once, each list of it once, and of each two groups only which list.
#include "compiler/page/ranks.hpp"

#include "compiler/graph/graph.hpp"
#include "compiler/lower/contention.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <map>

namespace director::compiler {

namespace {

/// What two edges of one requester have to do with each other.
struct Company {
  bool at_once = false; ///< some pack, with the needs of its provider, holds both
  bool unit = false;    ///< granted together, or not at all
  bool loose = false;   ///< both are asked for by some pack, and neither are they of one unit nor is one a need
  bool first_needed = false, second_needed = false; ///< by a provider that asks for the other one
};

/// A decision between two edges to one group. Where one of them is the sibling itself, and the other one lies below the
/// other sibling, priorities do not always decide: a unit is granted whole before anything below it, and a requester
/// runs only with what it needs.
struct Ruling {
  enum class Held : std::uint8_t { by_rank, in_unit, as_need };
  Decision decision;
  Held first = Held::by_rank, second = Held::by_rank; ///< at most one of them is not
  auto operator<=>(const Ruling&) const = default;

  int order() const { return first != Held::by_rank ? -1 : second != Held::by_rank ? 1 : order_of(decision); }
};

class RankWriter {
public:
  explicit RankWriter(const Model& model) : model_(model), contentions_(model), reaches_(model.groups.size()) {}

  Json write() {
    Json contended = Json::list({});
    for (const GroupId id : model_.groups.ids()) {
      if (model_.groups[id].requesters.size() > 1) contended.add(contended_json(id));
    }
    const std::size_t count = model_.groups.size();
    Json pairs = Json::list({});
    if (count <= most_compared) {
      const Arrows claims = make_graph(model_).claims;
      for (const GroupId id : model_.groups.ids()) reaches_[id] = reachable(claims, id.value);
      for (const GroupId first : model_.groups.ids()) {
        Json row = Json::list({});
        for (std::uint32_t i = 0; i <= first.value; ++i) row.add(Json::number(answer(first, GroupId{i})));
        pairs.add(std::move(row));
      }
    }
    Json out = Json::object({});
    std::string left_out;
    if (count > most_compared)
      left_out =
          fmt::format("Not every two of {} groups are compared here, as there are more than {}; those that several "
                      "ask for are.",
                      count, most_compared);
    if (!contentions_.complete())
      left_out += fmt::format("{}After {} pairs of tasks, or {} steps round circles of requests, no more was looked "
                              "at, so there may be more.",
                              left_out.empty() ? "" : " ", most_edge_pairs, most_circle_steps);
    if (!left_out.empty()) out.add("left_out", Json::text(left_out));
    out.add("decisions", std::move(decisions_));
    out.add("contended", std::move(contended));
    out.add("answers", std::move(answers_));
    out.add("pairs", std::move(pairs));
    return out;
  }

private:
  const std::string& name(GroupId id) const { return model_.groups[id].name.value; }

  Json contended_json(GroupId id) {
    Json rivals = Json::list({});
    for (const Contention& contention : contentions_.at(id)) {
      if (contention.decisions.empty()) continue;
      Json row = Json::object({});
      for (const auto& [key, edge] : {std::pair("first", contention.first), std::pair("second", contention.second)}) {
        if (const std::optional<GroupId>& by = model_.edges[edge].requester) row.add(key, Json::text(name(*by)));
      }
      row.add("decisions", numbers(rulings(contention)));
      rivals.add(std::move(row));
    }
    return Json::object({{"group", Json::text(name(id))}, {"rivals", std::move(rivals)}});
  }

  static std::vector<Ruling> by_rank(const std::vector<Decision>& decisions) {
    std::vector<Ruling> out;
    for (const Decision& each : decisions) out.push_back({each});
    return out;
  }

  std::vector<Ruling> rulings(const Contention& contention) const {
    using Held = Ruling::Held;
    std::vector<Ruling> out;
    for (const Decision& each : contention.decisions) {
      const bool first = each.first_sibling == contention.first, second = each.second_sibling == contention.second;
      const Company both = company(each);
      if (first == second || !each.requester) {
        out.push_back({each});
        continue;
      }
      const bool needed = first ? both.first_needed : both.second_needed;
      const auto held = [&](Held how) {
        out.push_back({each, first ? how : Held::by_rank, second ? how : Held::by_rank});
      };
      if (both.unit) held(Held::in_unit);
      if (needed) held(Held::as_need);
      // What the other one has as a need it may have since before there was a unit.
      const bool is_plan = edge(first ? contention.second : contention.first).needed;
      if (both.loose || is_plan || (!both.unit && !needed)) out.push_back({each});
    }
    return out;
  }

  /// Two chains to one group.
  std::vector<Ruling> rulings(GroupId group) {
    std::vector<Ruling> out;
    for (const Contention& each : contentions_.at(group)) {
      const std::vector<Ruling> some = rulings(each);
      out.insert(out.end(), some.begin(), some.end());
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  /// Twice the place in `decisions`, and one more where the first group is on the side of the decision's second task.
  Json numbers(const std::vector<Ruling>& rulings) {
    Json out = Json::list({});
    for (Ruling each : rulings) {
      Decision& decision = each.decision;
      const bool turned = decision.second_sibling < decision.first_sibling;
      if (turned) {
        std::swap(decision.first_sibling, decision.second_sibling);
        std::swap(decision.first, decision.second);
        std::swap(each.first, each.second);
      }
      const auto [at, fresh] = known_.try_emplace(each, known_.size());
      if (fresh) decisions_.add(decision_json(each));
      out.add(Json::number(static_cast<std::int64_t>(2 * at->second + (turned ? 1 : 0))));
    }
    return out;
  }

  std::int64_t answer(GroupId first, GroupId second) {
    Json all = Json::object({});
    if (reaches_[first][second.value] && first != second) all.add("leads", Json::text("first"));
    if (reaches_[second][first.value] && first != second) all.add("leads", Json::text("second"));
    all.add("decisions", numbers(first == second ? rulings(first) : by_rank(contentions_.between(first, second))));
    const auto [at, fresh] = answer_places_.try_emplace(to_line(all), answer_places_.size());
    if (fresh) answers_.add(std::move(all));
    return static_cast<std::int64_t>(at->second);
  }

  Json decision_json(const Ruling& ruling) const {
    const Decision& decision = ruling.decision;
    const int order = ruling.order();
    Json out = Json::object({});
    if (decision.requester) out.add("requester", Json::text(name(*decision.requester)));
    out.add("first", Json::text(name(model_.edges[decision.first_sibling].target)));
    out.add("second", Json::text(name(model_.edges[decision.second_sibling].target)));
    out.add("goes_first", Json::text(order < 0 ? "first" : order > 0 ? "second" : "equal"));
    out.add("words", Json::text(words(ruling)));
    return out;
  }

  const Edge& edge(EdgeId id) const { return model_.edges[id]; }

  /// `Kick (priority 20)`
  std::string asked(EdgeId id, const Standing& standing) const {
    const std::vector<Level>& levels = edge(id).levels;
    const bool itself = std::any_of(levels.begin(), levels.end(), [&](const Level& level) {
      return level.optional && level.priority == standing.priority;
    });
    return fmt::format("{} ({}{})", name(edge(id).target),
                       levels.empty() ? "needed" : fmt::format("priority {}", standing.priority),
                       !standing.optional ? ""
                       : itself           ? ", optional"
                                          : ", something below it optional");
  }

  /// The one that goes first stands first.
  std::string words(const Ruling& ruling) const {
    const Decision& decision = ruling.decision;
    const int order = ruling.order();
    std::string first = asked(decision.first_sibling, decision.first);
    std::string second = asked(decision.second_sibling, decision.second);
    if (order > 0) std::swap(first, second);
    const Ruling::Held held = order < 0 ? ruling.first : ruling.second;
    if (held != Ruling::Held::by_rank)
      return fmt::format("{}: {} before what {} asks for, as {}", name(*decision.requester), first, second,
                         held == Ruling::Held::in_unit ? "both are granted together"
                                                       : name(*decision.requester) + " runs only with it");
    const Company both = company(decision);
    return fmt::format("{}: {} {} {}{}{}{}", decision.requester ? name(*decision.requester) : "the program", first,
                       order == 0 ? "and" : "before", second, order == 0 ? " are equal" : "",
                       both.unit ? ", together or not at all" : "", both.at_once ? "" : ", never both at once");
  }

  static const Task* entry(const std::vector<Task>& tasks, EdgeId edge) {
    const auto at = std::find_if(tasks.begin(), tasks.end(), [&](const Task& task) { return task.edge == edge; });
    return at == tasks.end() ? nullptr : &*at;
  }

  /// At some level of this priority, as a member of the unit of its pack, or not.
  bool may_be(const Task& task, const Standing& standing, bool in_unit) const {
    return std::any_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
      const Level& level = edge(task.edge).levels[named.level];
      return level.priority == standing.priority && (!level.optional && !level.apart) == in_unit;
    });
  }

  Company company(const Decision& decision) const {
    if (!decision.requester) return {true, false};
    Company out;
    for (const ProviderId id : model_.groups[*decision.requester].providers) {
      const Provider& provider = model_.providers[id];
      const auto is_needed = [&](EdgeId edge_id) {
        return std::any_of(provider.needs.begin(), provider.needs.end(),
                           [&](const Use<GroupId>& need) { return need.id == edge(edge_id).target; });
      };
      const bool first_needed = is_needed(decision.first_sibling), second_needed = is_needed(decision.second_sibling);
      out.at_once = out.at_once || (first_needed && second_needed);
      out.first_needed = out.first_needed || (first_needed && second_needed);
      out.second_needed = out.second_needed || (first_needed && second_needed);
      for (const Pack& pack : provider.packs) {
        const Task* const first = entry(pack.tasks, decision.first_sibling);
        const Task* const second = entry(pack.tasks, decision.second_sibling);
        out.at_once = out.at_once || ((first != nullptr || first_needed) && (second != nullptr || second_needed));
        if (first != nullptr && second != nullptr) {
          out.unit = out.unit || (may_be(*first, decision.first, true) && may_be(*second, decision.second, true));
          const bool loose = may_be(*first, decision.first, false) || may_be(*second, decision.second, false);
          out.loose = out.loose || (loose && !first_needed && !second_needed);
        }
        out.first_needed = out.first_needed || (first_needed && second != nullptr);
        out.second_needed = out.second_needed || (second_needed && first != nullptr);
      }
    }
    return out;
  }

  const Model& model_;
  Contentions contentions_;
  IdTable<GroupId, std::vector<bool>> reaches_;
  std::map<Ruling, std::size_t> known_;
  std::map<std::string, std::size_t> answer_places_;
  Json decisions_ = Json::list({}), answers_ = Json::list({});
};

} // namespace

Json ranks_json(const Model& model) { return RankWriter(model).write(); }

} // namespace director::compiler
