// Header: compiler/transitions/way.hpp. Test: tests/compiler/transitions/way_test.cpp.
// SPDX-License-Identifier: MIT
//
// A `when` is a conjunction of conditions on one state each, so a choice of providers needs a set of values for each
// state, and the first value of each set is used. A preferred provider that would run instead of the chosen one
// requires more: one of its conditions has to be false, which is searched. So are the providers of the groups that are
// needed, and of the other tasks of a unit, which are granted together with the task on the way or not at all. Whether
// all of these can be had together, and whether a preferred provider really prevents the chosen one, the engine
// decides: each choice that has other values is one to try.
#include "compiler/transitions/way.hpp"

#include "compiler/analysis/states/sources.hpp"
#include "compiler/model/causers.hpp"

#include <algorithm>
#include <deque>

namespace director::compiler::transitions {

namespace {

constexpr std::size_t most_ways = 32;    ///< limit for the choices of providers that are tried for one group
constexpr std::size_t most_steps = 1000; ///< limit for the beginnings of such choices

/// By group: its first requester, breadth first from the program.
struct FirstRequest {
  bool reached = false;
  std::optional<GroupId> by; ///< empty: the program
};

IdTable<GroupId, FirstRequest> find_first_requests(const Model& model) {
  IdTable<GroupId, FirstRequest> out(model.groups.size());
  std::deque<GroupId> open;
  const auto reach = [&](GroupId group, std::optional<GroupId> by) {
    if (out[group].reached) return;
    out[group] = {true, by};
    open.push_back(group);
  };
  for (const Task& task : model.roots) reach(task.target, {});
  for (; !open.empty(); open.pop_front()) {
    const GroupId group = open.front();
    for (const EdgeId edge : model.groups[group].edges) {
      if (!model.edges[edge].levels.empty()) reach(model.edges[edge].target, group);
    }
  }
  return out;
}

/// From the first group below the program to this one. A group has no chain to itself.
std::vector<GroupId> chain_to(const IdTable<GroupId, FirstRequest>& first_requests, GroupId group) {
  std::vector<GroupId> out{group};
  while (first_requests[out.back()].by) out.push_back(*first_requests[out.back()].by);
  std::reverse(out.begin(), out.end());
  return out;
}

/// Which packs of a provider that lead to a task are tried.
enum class Packs : bool { first, all };

std::vector<Link> links_between(const Model& model, GroupId from, GroupId to, Packs which) {
  std::vector<Link> out;
  for (const ProviderId id : model.groups[from].providers) {
    const std::vector<Pack>& packs = model.providers[id].packs;
    for (std::size_t i = 0; i < packs.size(); ++i) {
      const auto task = std::find_if(packs[i].tasks.begin(), packs[i].tasks.end(),
                                     [&](const Task& each) { return each.target == to; });
      if (task == packs[i].tasks.end()) continue;
      out.push_back({id, i, &*task});
      if (which == Packs::first) break;
    }
  }
  return out;
}

const Task* root_to(const Model& model, GroupId group) {
  const auto at =
      std::find_if(model.roots.begin(), model.roots.end(), [&](const Task& task) { return task.target == group; });
  return at == model.roots.end() ? nullptr : &*at;
}

/// Every choice of providers along this chain that is not there yet.
void add_ways(const Model& model, const std::vector<GroupId>& chain, Packs which, std::vector<Way>& out) {
  const std::vector<Way> known = out;
  std::vector<Way> ways{{root_to(model, chain.front()), {}, chain.back(), {}}};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    std::vector<Way> longer;
    for (const Way& way : ways) {
      for (const Link& link : links_between(model, chain[i], chain[i + 1], which)) {
        if (longer.size() >= most_ways) break;
        longer.push_back(way);
        longer.back().links.push_back(link);
      }
    }
    ways = std::move(longer);
  }
  for (const Way& way : ways) {
    for (const ProviderId id : model.groups[chain.back()].providers) {
      if (out.size() >= most_ways) return;
      Way whole = way;
      whole.runs = id;
      if (std::find(known.begin(), known.end(), whole) == known.end()) out.push_back(std::move(whole));
    }
  }
}

class Wants {
public:
  Wants(const Model& model, const PossibleValues& possible, Assume assume)
      : model_(model),
        possible_(possible),
        assume_(assume) {}

  /// First without what the other tasks of the units want: it may come by a push. Last also with what those want that
  /// can be pushed.
  std::vector<Outside> find(const Way& way) {
    for (const auto& [with_units, with_causers] :
         {std::pair(false, false), {true, false}, {false, true}, {true, true}}) {
      with_causers_ = with_causers;
      if (with_causers && causers_.empty()) causers_ = find_causers(model_);
      wanted_.clear();
      open_.clear();
      avoided_.clear();
      tried_ = choices_ = steps_ = 0;
      bool possible = true;
      for (const Link& link : way.links) {
        possible = add(link.provider) && possible;
        if (with_units) add_unit(link);
      }
      possible = add(way.runs) && possible;
      // What one provider requires holds in every choice: it is required before there is a choice.
      std::stable_partition(open_.begin(), open_.end(),
                            [](const std::vector<ProviderId>& choice) { return choice.size() <= 1; });
      if (possible) choose(0);
    }
    std::vector<Outside> out = std::move(strict_);
    for (Outside& each : loose_) add_new(std::move(each), out);
    return out;
  }

private:
  bool may_choose(const State& state) const { return state.external || assume_ == Assume::inside; }
  /// A state that only bodies set may begin with a value that it can get.
  ValueSet choices_of(StateId id) const {
    return model_.states[id].external ? model_.states[id].domain() : possible_[id];
  }

  /// False: no value meets all conditions.
  bool want(const std::vector<ConditionUse>& uses) {
    bool possible = true;
    for (const ConditionUse& use : uses) {
      const Condition& condition = model_.conditions[use.id];
      const State& state = model_.states[condition.state];
      if (!may_choose(state)) {
        if (with_causers_ && !(state.initial && condition.accepts.contains(*state.initial))) open(causers_[use.id]);
        continue;
      }
      ValueSet& set = wanted_.try_emplace(condition.state, choices_of(condition.state)).first->second;
      set = set.intersected(condition.accepts);
      possible = possible && !set.empty();
    }
    return possible;
  }

  /// One of these has to be chosen too.
  void open(const std::vector<ProviderId>& choice) {
    if (!choice.empty() && std::find(open_.begin(), open_.end(), choice) == open_.end()) open_.push_back(choice);
  }

  void open_needs(const Provider& provider) {
    for (const Use<GroupId>& need : provider.needs) open(model_.groups[need.id].providers);
  }

  /// A provider of the way, which has to be the one that runs.
  bool add(ProviderId id) {
    const Provider& provider = model_.providers[id];
    for (const ProviderId preferred : model_.groups[provider.group].providers) {
      if (preferred == id) break;
      if (std::find(avoided_.begin(), avoided_.end(), preferred) == avoided_.end()) avoided_.push_back(preferred);
    }
    open_needs(provider);
    return want(provider.when);
  }

  /// Of plain tasks the body requests only the one on the way.
  void add_unit(const Link& link) {
    const Provider& provider = model_.providers[link.provider];
    if (!provider.has_packs || !model_.is_usually_member(*link.next)) return;
    for (const Task& task : provider.packs[link.pack].tasks) {
      if (task.edge != link.next->edge && model_.is_usually_member(task)) open(model_.groups[task.target].providers);
    }
  }

  /// Every choice of providers for the open groups from this one on.
  void choose(std::size_t at) {
    if (choices_ >= most_ways || strict_.size() >= most_outsides || ++steps_ > most_steps) return;
    if (at == open_.size()) return keep();
    const std::vector<ProviderId> choice = open_[at];
    for (const ProviderId id : choice) {
      const std::map<StateId, ValueSet> before = wanted_;
      const std::size_t opened = open_.size();
      if (want(model_.providers[id].when)) {
        open_needs(model_.providers[id]);
        choose(at + 1);
      }
      wanted_ = before;
      open_.resize(opened);
    }
  }

  void keep() {
    ++choices_;
    const std::map<StateId, ValueSet> before = wanted_;
    tried_ = 0;
    const bool avoided = avoid(0);
    add_new(outside(), avoided ? strict_ : loose_);
    wanted_ = before;
  }

  static void add_new(Outside outside, std::vector<Outside>& out) {
    const bool known = std::any_of(out.begin(), out.end(), [&](const Outside& each) {
      return each.values == outside.values && each.given == outside.given;
    });
    if (!known && out.size() < most_outsides) out.push_back(std::move(outside));
  }

  Outside outside() const {
    Outside out;
    for (const auto& [state, values] : wanted_) {
      const State& row = model_.states[state];
      if (row.external) out.wanted.emplace(state, values);
      if (row.initial && values.contains(*row.initial)) continue;
      (row.external ? out.values : out.given).emplace(state, values.intervals().front().low);
    }
    return out;
  }

  std::optional<std::int64_t> value_of(StateId id) const {
    const State& state = model_.states[id];
    const auto wanted = wanted_.find(id);
    if (wanted == wanted_.end() || (state.initial && wanted->second.contains(*state.initial))) return state.initial;
    return wanted->second.intervals().front().low;
  }

  bool would_run(ProviderId id) const {
    const std::vector<ConditionUse>& when = model_.providers[id].when;
    return std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) {
      const Condition& condition = model_.conditions[use.id];
      const std::optional<std::int64_t> value = value_of(condition.state);
      return value && condition.accepts.contains(*value);
    });
  }

  /// Makes sure that from this one on no preferred provider would run.
  bool avoid(std::size_t at) {
    while (at < avoided_.size() && !would_run(avoided_[at])) ++at;
    if (at == avoided_.size()) return true;
    if (++tried_ > most_ways) return false;
    for (const ConditionUse& use : model_.providers[avoided_[at]].when) {
      const Condition& condition = model_.conditions[use.id];
      const State& state = model_.states[condition.state];
      if (!may_choose(state)) continue;
      const std::map<StateId, ValueSet> before = wanted_;
      ValueSet& set = wanted_.try_emplace(condition.state, choices_of(condition.state)).first->second;
      set = set.without(condition.accepts);
      if (!set.empty() && avoid(0)) return true;
      wanted_ = before;
    }
    return false;
  }

  const Model& model_;
  const PossibleValues& possible_;
  const Assume assume_;
  std::vector<ProviderId> avoided_;
  std::vector<std::vector<ProviderId>> open_;
  std::map<StateId, ValueSet> wanted_;
  bool with_causers_ = false; ///< conditions are also met by pushes
  Causers causers_;           ///< only then
  std::size_t tried_ = 0, choices_ = 0, steps_ = 0;
  std::vector<Outside> strict_; ///< no preferred provider would run
  std::vector<Outside> loose_;  ///< one would if its needs can be met
};

} // namespace

bool Way::passes(GroupId id) const {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (group(i) == id) return true;
  }
  return false;
}

IdSet<GroupId> find_led_to(const Model& model) {
  const IdTable<GroupId, FirstRequest> first_requests = find_first_requests(model);
  IdSet<GroupId> out(model.groups.size());
  for (const GroupId id : model.groups.ids()) {
    if (first_requests[id].reached && !model.groups[id].providers.empty()) out.add(id);
  }
  return out;
}

std::vector<Way> find_ways(const Model& model, GroupId target) {
  const IdTable<GroupId, FirstRequest> first_requests = find_first_requests(model);
  std::vector<Way> out;
  if (!first_requests[target].reached) return out;
  std::vector<std::vector<GroupId>> chains{chain_to(first_requests, target)};
  for (const EdgeId id : model.groups[target].requesters) {
    const Edge& edge = model.edges[id];
    if (edge.levels.empty() || edge.requester == first_requests[target].by) continue;
    std::vector<GroupId> chain{target};
    if (edge.requester) {
      if (!first_requests[*edge.requester].reached) continue;
      chain = chain_to(first_requests, *edge.requester);
      if (std::find(chain.begin(), chain.end(), target) != chain.end()) continue;
      chain.push_back(target);
    }
    chains.push_back(std::move(chain));
  }
  for (const Packs which : {Packs::first, Packs::all}) {
    for (const std::vector<GroupId>& chain : chains) add_ways(model, chain, which, out);
  }
  return out;
}

PossibleValues find_possible_values(const Model& model) {
  const IdTable<StateId, std::vector<analysis::Source>> sources = analysis::find_sources(model);
  PossibleValues out(model.states.size());
  for (const StateId id : model.states.ids()) {
    for (const analysis::Source& source : sources[id]) out[id] = out[id].united(source.values);
  }
  return out;
}

std::vector<Outside> outsides_for(const Model& model, const PossibleValues& possible, const Way& way, Assume assume) {
  return Wants(model, possible, assume).find(way);
}

} // namespace director::compiler::transitions
