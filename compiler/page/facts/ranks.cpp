// Header: compiler/page/facts/ranks.hpp. Test: tests/compiler/page/facts/ranks_test.cpp. Schema:
// schemas/graph.schema.json. SPDX-License-Identifier: MIT
//
// Most pairs of groups part at the same few requesters, and in the same ways, so each decision is written once, each
// list of decisions once, and for each two groups only the number of the list.
#include "compiler/page/facts/ranks.hpp"

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/page/facts/ruling.hpp"
#include "compiler/page/facts/task_relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace director::compiler {

namespace {

/// How the chain of one side continues below the sibling.
struct Below {
  bool itself = false, needs = false, asks = false;
  bool comes_along() const { return itself || needs; } ///< with the sibling's grant
};

class RankWriter {
public:
  RankWriter(const Model& model, std::size_t most_decisions)
      : model_(model),
        most_decisions_(most_decisions),
        contentions_(model),
        leaders_(model),
        ways_(model),
        reaches_(model.groups.size()) {}

  Json write() {
    Json contended = Json::list({});
    std::size_t rivals = 0, decided = 0;
    std::vector<std::string> crowded;
    for (const GroupId id : model_.groups.ids()) {
      const std::size_t requesters = model_.groups[id].requesters.size();
      if (requesters <= 1) continue;
      const std::size_t more = requesters * (requesters - 1) / 2;
      std::size_t decisions = 0;
      for (const analysis::Contention& each : contentions_.at(id)) decisions += each.decisions.size();
      if (rivals + more > most_rivals || decided + decisions > most_listed) {
        crowded.push_back(name(id));
        continue;
      }
      rivals += more;
      decided += decisions;
      contended.add(contended_json(id));
    }
    const std::size_t count = model_.groups.size(), of_contended = known_.size();
    Json pairs = count <= most_compared ? pairs_json() : Json::list({});
    Json out = Json::object({});
    std::string left_out;
    if (count > most_compared)
      left_out =
          fmt::format("Not every two of {} groups are compared here, as there are more than {}; those that several "
                      "request are.",
                      count, most_compared);
    if (listed_ > most_decisions_) {
      left_out =
          fmt::format("Not every two groups are compared here, as there are more than {} decisions between them; "
                      "those that several request are.",
                      most_decisions_);
      pairs = answers_ = Json::list({});
      const std::vector<Json>& all = decisions_.items();
      decisions_ = Json::list({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(of_contended)});
    }
    if (!crowded.empty())
      left_out += fmt::format("{}The requesters of {} are not compared with each other, as there would be more than {} "
                              "pairs, or more than {} decisions between them.",
                              left_out.empty() ? "" : " ", analysis::few_of(crowded), most_rivals, most_listed);
    if (!contentions_.complete())
      left_out += fmt::format(
          "{}After {} pairs of tasks, {} places where their chains part, or {} steps through cycles "
          "of requests, no more was looked at, so there may be more.",
          left_out.empty() ? "" : " ", analysis::most_edge_pairs, analysis::most_partings, analysis::most_cycle_steps);
    if (!left_out.empty()) out.add("left_out", Json::text(left_out));
    out.add("decisions", std::move(decisions_));
    out.add("contended", std::move(contended));
    out.add("answers", std::move(answers_));
    out.add("pairs", std::move(pairs));
    return out;
  }

private:
  const std::string& name(GroupId id) const { return model_.groups[id].name.value; }

  /// Incomplete if more are listed than allowed.
  Json pairs_json() {
    const Arrows claims = make_graph(model_).claims;
    for (const GroupId id : model_.groups.ids()) reaches_[id] = reachable(claims, id.value);
    Json pairs = Json::list({});
    for (const GroupId first : model_.groups.ids()) {
      Json row = Json::list({});
      for (std::uint32_t i = 0; i <= first.value && listed_ <= most_decisions_; ++i)
        row.add(Json::number(answer(first, GroupId{i})));
      pairs.add(std::move(row));
    }
    return pairs;
  }

  Json contended_json(GroupId id) {
    Json rivals = Json::list({});
    for (const analysis::Contention& contention : contentions_.at(id)) {
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

  Below below(EdgeId sibling, GroupId group) {
    const GroupId from = edge(sibling).target;
    return {from == group, from != group && ways_.needs(from, group), ways_.asks(from, group)};
  }
  Below below(EdgeId sibling, EdgeId last) {
    if (sibling == last) return {true, false, false};
    const GroupId from = edge(sibling).target, to = *edge(last).requester;
    const bool passes = ways_.needs(from, to), asks = ways_.asks(from, to);
    return {false, edge(last).needed && passes, asks || (!edge(last).levels.empty() && passes)};
  }

  /// By rank, unless a unit is tried earlier than its member's place.
  void add_ranked(const analysis::Decision& decision, const Below& of_first, const Below& of_second,
                  std::vector<Ruling>& out) {
    Ruling ranked{decision, {}, {}};
    std::optional<Ruling> led;
    bool may_be_ranked = true;
    for (const bool first : {true, false}) {
      const Leaders& leaders = leaders_.of(decision, first);
      if (leaders.all.empty()) continue;
      const Below& how = first ? of_first : of_second;
      if (!how.itself && !how.needs) continue;
      Ruling::Side& side = first ? ranked.first : ranked.second;
      side.needs = !how.itself;
      if (!how.asks || analysis::order_of(decision) == 0) side.leaders = leaders.all;
      if (analysis::order_of(decision) == 0) continue;
      led = Ruling{decision, {}, {}};
      (first ? led->first : led->second) = {Ruling::Held::by_leader, side.needs, false, leaders.all};
      may_be_ranked = how.asks || !leaders.always;
    }
    if (may_be_ranked) out.push_back(std::move(ranked));
    if (led) out.push_back(std::move(*led));
  }

  /// What is granted with a unit goes before what another member requests, and what is granted with a need of the
  /// requester before everything else of the other one. `ranked`: ranks decide too, however the two sides are held.
  void add_decided(const analysis::Decision& decision, const Below& first, const Below& second, bool ranked,
                   std::vector<Ruling>& out) {
    using Held = Ruling::Held;
    if (!decision.requester || (!first.comes_along() && !second.comes_along()))
      return add_ranked(decision, first, second, out);
    const TaskRelation both = relation_of(model_, decision);
    // If both request it, or both are granted with it: one may have held it as a need since before there was a unit.
    ranked = ranked || (first.asks && second.asks) || (first.comes_along() && second.comes_along());
    for (const bool of_first : {true, false}) {
      const Below &ahead = of_first ? first : second, &behind = of_first ? second : first;
      if (!ahead.comes_along()) continue;
      const bool needed = of_first ? both.first_needed : both.second_needed;
      const auto held = [&](Held how, Ruling::Side other) {
        Ruling::Side side;
        side.held = how;
        side.needs = !ahead.itself;
        out.push_back({decision, of_first ? side : other, of_first ? other : side});
      };
      Ruling::Side asks, needs, itself;
      asks.asks = needs.needs = true;
      if (behind.asks && both.unit) held(Held::in_unit, asks);
      if (behind.asks && needed) held(Held::as_need, asks);
      const bool alone = of_first ? both.first_alone : both.second_alone;
      if (behind.needs && alone) held(Held::as_need, needs);
      if (behind.itself && alone) held(Held::as_need, itself);
      if (behind.asks) ranked = ranked || (of_first ? both.first_loose : both.second_loose) || (!both.unit && !needed);
    }
    if (ranked) add_ranked(decision, first, second, out);
  }

  std::vector<Ruling> rulings(const analysis::Contention& contention) {
    std::vector<Ruling> out;
    for (const analysis::Decision& each : contention.decisions)
      add_decided(each, below(each.first_sibling, contention.first), below(each.second_sibling, contention.second),
                  false, out);
    return out;
  }

  /// Two requested groups are always compared by rank.
  std::vector<Ruling> rulings(GroupId first, GroupId second) {
    std::vector<Ruling> out;
    for (const analysis::Decision& each : contentions_.between(first, second))
      add_decided(each, below(each.first_sibling, first), below(each.second_sibling, second), true, out);
    return out;
  }

  /// Two chains to one group. If they are more than allowed, only some.
  std::vector<Ruling> rulings(GroupId group) {
    std::vector<Ruling> out;
    const auto unite = [&] {
      std::sort(out.begin(), out.end());
      out.erase(std::unique(out.begin(), out.end()), out.end());
    };
    std::size_t full = 2 * most_decisions_;
    for (const analysis::Contention& each : contentions_.at(group)) {
      const std::vector<Ruling> some = rulings(each);
      out.insert(out.end(), some.begin(), some.end());
      if (out.size() <= full) continue;
      unite();
      if (out.size() > most_decisions_) break;
      full = 2 * most_decisions_ + out.size();
    }
    unite();
    return out;
  }

  /// Twice the index in `decisions`, and one more if the first group is on the side of the decision's second task.
  Json numbers(const std::vector<Ruling>& rulings) {
    Json out = Json::list({});
    for (Ruling each : rulings) {
      analysis::Decision& decision = each.decision;
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
    const std::vector<Ruling> found = first == second ? rulings(first) : rulings(first, second);
    if (found.size() > most_decisions_) {
      listed_ = found.size();
      return 0;
    }
    Json all = Json::object({});
    if (reaches_[first][second.value] && first != second) all.add("leads", Json::text("first"));
    if (reaches_[second][first.value] && first != second) all.add("leads", Json::text("second"));
    all.add("decisions", numbers(found));
    const auto [at, fresh] = answer_places_.try_emplace(to_line(all), answer_places_.size());
    if (fresh) {
      listed_ += all["decisions"].items().size();
      answers_.add(std::move(all));
    }
    return static_cast<std::int64_t>(at->second);
  }

  Json decision_json(const Ruling& ruling) const {
    const analysis::Decision& decision = ruling.decision;
    const int order = ruling.order();
    Json out = Json::object({});
    if (decision.requester) out.add("requester", Json::text(name(*decision.requester)));
    out.add("first", Json::text(name(model_.edges[decision.first_sibling].target)));
    out.add("second", Json::text(name(model_.edges[decision.second_sibling].target)));
    out.add("goes_first", Json::text(order < 0 ? "first" : order > 0 ? "second" : "equal"));
    out.add("words", Json::text(words_of(model_, ruling)));
    return out;
  }

  const Edge& edge(EdgeId id) const { return model_.edges[id]; }

  const Model& model_;
  std::size_t most_decisions_;
  std::size_t listed_ = 0; ///< decisions in `answers_`
  analysis::Contentions contentions_;
  LeaderFinder leaders_;
  Ways ways_;
  IdTable<GroupId, std::vector<bool>> reaches_;
  std::map<Ruling, std::size_t> known_;
  std::map<std::string, std::size_t> answer_places_;
  Json decisions_ = Json::list({}), answers_ = Json::list({});
};

} // namespace

Json ranks_json(const Model& model, std::size_t most_decisions) { return RankWriter(model, most_decisions).write(); }

} // namespace director::compiler
