// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/ranks/order_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares the orders that decide what is pushed (semantics.md, 4.4, "Refuse"): of chains of equal length the one that
// is declared earlier is taken, and of what a task lacks the first condition is served first. Each of them decides
// something only between providers that one task may push: these are computed where an order has changed.
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/base/list_of.hpp"
#include "compiler/diff/meaning.hpp"
#include "compiler/diff/side.hpp"
#include "compiler/model/causers.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace director::compiler::diff {

namespace {

using Texts = std::vector<std::string>;

/// A condition by its meaning: "`Phase == ready|set`".
std::string key_of(const Model& model, ConditionId id) {
  const Condition& condition = model.conditions[id];
  const State& state = model.states[condition.state];
  return ticked(state.name.value + " == " + to_text(values_of(state, condition.accepts)));
}

Texts keys_of(const Model& model, const std::vector<ConditionUse>& uses) {
  Texts out;
  for (const ConditionUse& use : uses) {
    std::string key = key_of(model, use.id);
    if (std::find(out.begin(), out.end(), key) == out.end()) out.push_back(std::move(key));
  }
  return out;
}

/// Pairs of elements of both that are in another order.
std::set<std::pair<std::string, std::string>> flipped_pairs(const Texts& was, const Texts& is) {
  std::set<std::pair<std::string, std::string>> out;
  if (!is_reordered(was, is)) return out;
  std::map<std::string_view, std::size_t> before;
  for (std::size_t i = 0; i < was.size(); ++i) before.emplace(was[i], i);
  for (std::size_t i = 0; i < is.size(); ++i) {
    const auto first = before.find(is[i]);
    for (std::size_t k = i + 1; k < is.size() && first != before.end(); ++k) {
      const auto second = before.find(is[k]);
      if (second != before.end() && second->second < first->second) out.emplace(is[i], is[k]);
    }
  }
  return out;
}

/// What tasks of one side may push, and for what.
class Pushing {
public:
  Pushing(const Checked& checked, const Possible& possible)
      : model_(checked.model),
        graph_(checked.graph),
        facts_(possible.facts()),
        causers_(find_causers(checked.model)),
        pushes_(possible.pushes()) {}

  /// The groups whose task may push either provider for this condition.
  std::set<std::string> waiters(const std::string& condition, ProviderId one, ProviderId other) {
    std::set<std::string> out;
    for (const auto& [waiter, pushed] : pushes_) {
      if (!pushed.contains(one) || !pushed.contains(other)) continue;
      const std::vector<ConditionId> all = awaited(waiter);
      if (std::any_of(all.begin(), all.end(), [&](ConditionId id) { return key_of(model_, id) == condition; }))
        out.insert(name_of(model_, waiter));
    }
    return out;
  }

  /// The groups of which other providers are pushed for the ones of these conditions than for the others, where some
  /// task may lack both: conditions of one provider, in its `when` or by its needs.
  std::set<std::string> contended(ProviderId of, const std::vector<ConditionId>& ones,
                                  const std::vector<ConditionId>& others) {
    std::set<std::string> out;
    for (const auto& [waiter, pushed] : pushes_) {
      const bool by_itself = providers_of(waiter).contains(of);
      if (!by_itself && !awaited_providers(waiter).contains(of)) continue;
      const std::set<ProviderId> first = towards(waiter, ones), second = towards(waiter, others);
      for (const ProviderId one : first) {
        for (const ProviderId other : second) {
          const GroupId group = model_.providers[one].group, rival = model_.providers[other].group;
          if (one == other || (by_itself && group != rival)) continue;
          // Of what is pushed itself, only the first condition that it lacks is served at a time.
          out.insert({name_of(model_, group), name_of(model_, rival)});
        }
      }
    }
    return out;
  }

  /// All conditions of the plans for a need.
  std::vector<ConditionId> conditions_of(GroupId need) const {
    std::vector<ConditionId> out;
    for (const auto& [provider, use] : analysis::waited_conditions(model_, facts_, need)) out.push_back(use.id);
    return out;
  }

private:
  /// Of the group, and of every group that their plans may hold.
  const std::set<ProviderId>& providers_of(GroupId waiter) const {
    const auto [at, fresh] = providers_.try_emplace(waiter);
    std::set<ProviderId>& out = at->second;
    if (!fresh) return out;
    std::vector<bool> held = reachable(graph_.needs, waiter.value);
    held[waiter.value] = true;
    for (const ProviderId id : model_.providers.ids()) {
      if (held[model_.providers[id].group.value]) out.insert(id);
    }
    return out;
  }

  /// Of the task itself, and of what it may push.
  std::set<ProviderId> awaited_providers(GroupId waiter) const {
    std::set<ProviderId> out = providers_of(waiter);
    for (const ProviderId id : pushes_.at(waiter)) {
      out.insert(id);
      for (const Use<GroupId>& need : model_.providers[id].needs) {
        const std::set<ProviderId>& below = providers_of(need.id);
        out.insert(below.begin(), below.end());
      }
    }
    return out;
  }
  std::vector<ConditionId> awaited(GroupId waiter) const {
    std::vector<ConditionId> out;
    for (const ProviderId id : awaited_providers(waiter)) {
      for (const ConditionUse& use : model_.providers[id].when) out.push_back(use.id);
    }
    return out;
  }

  /// What the task may push for one of these conditions, or for what such a provider lacks, and so on.
  std::set<ProviderId> towards(GroupId waiter, std::vector<ConditionId> open) const {
    const std::set<ProviderId>& pushed = pushes_.at(waiter);
    std::set<ProviderId> out;
    while (!open.empty()) {
      const ConditionId id = open.back();
      open.pop_back();
      for (const ProviderId causer : causers_[id]) {
        if (!pushed.contains(causer) || !out.insert(causer).second) continue;
        for (const ConditionUse& use : model_.providers[causer].when) open.push_back(use.id);
        for (const Use<GroupId>& need : model_.providers[causer].needs) {
          for (const ConditionId each : conditions_of(need.id)) open.push_back(each);
        }
      }
    }
    return out;
  }

  const Model& model_;
  const Graph& graph_;
  const analysis::Facts& facts_;
  const Causers causers_;
  const std::map<GroupId, std::set<ProviderId>>& pushes_;     ///< by the group that waits
  mutable std::map<GroupId, std::set<ProviderId>> providers_; ///< a cache of providers_of()
};

class PushOrders {
public:
  PushOrders(const Pair& pair, Changes& changes) : pair_(pair), changes_(changes) {}

  void compare() {
    for (const ProviderId after : pair_.new_model.providers.ids()) {
      const auto group = pair_.old_model.find_group(pair_.new_model.group_of(after).name.value);
      if (!group) continue;
      const auto before =
          find_provider(pair_.old_model, pair_.old_model.groups[*group], pair_.new_model.providers[after].name);
      if (!before) continue;
      conditions(*before, after);
      needs(*before, after);
    }
    causers();
  }

private:
  struct Causing {
    ConditionId condition{};
    std::vector<ProviderId> causers; ///< in order
  };
  static std::map<std::string, Causing> causing_of(const Model& model) {
    const Causers all = find_causers(model);
    std::map<std::string, Causing> out;
    for (const ConditionId id : model.conditions.ids()) {
      if (all[id].size() > 1) out.try_emplace(key_of(model, id), Causing{id, all[id]});
    }
    return out;
  }
  static Texts names_of(const Model& model, const std::vector<ProviderId>& providers) {
    Texts out;
    for (const ProviderId id : providers) out.push_back(model.full_name(id));
    return out;
  }
  static ProviderId id_of(const Model& model, const std::vector<ProviderId>& all, const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](ProviderId id) { return model.full_name(id) == name; });
  }

  /// Of providers of different groups that cause one condition. Those of one group are compared with their group.
  void causers() {
    const std::map<std::string, Causing> was = causing_of(pair_.old_model), is = causing_of(pair_.new_model);
    std::map<std::tuple<Texts, Texts, std::set<std::string>>, Texts> told; // conditions with the same outcome
    for (const auto& [key, now] : is) {
      const auto old = was.find(key);
      if (old == was.end()) continue;
      const Texts before = names_of(pair_.old_model, old->second.causers),
                  after = names_of(pair_.new_model, now.causers);
      std::set<std::string> waiting, flipped;
      for (const auto& [one, other] : flipped_pairs(before, after)) {
        const ProviderId first = id_of(pair_.new_model, now.causers, one),
                         second = id_of(pair_.new_model, now.causers, other);
        if (pair_.new_model.providers[first].group == pair_.new_model.providers[second].group) continue;
        const std::set<std::string> then = before_pushes().waiters(
            key, id_of(pair_.old_model, old->second.causers, one), id_of(pair_.old_model, old->second.causers, other));
        for (const std::string& waiter : after_pushes().waiters(key, first, second)) {
          if (!then.contains(waiter)) continue;
          waiting.insert(waiter);
          flipped.insert({one, other});
        }
      }
      if (waiting.empty()) continue;
      told[{only(after, flipped), only(before, flipped), waiting}].push_back(key);
    }
    for (const auto& [outcome, conditions] : told) {
      const auto& [order, before, waiting] = outcome;
      changes_.add(
          ChangeKind::preference, order.front(),
          fmt::format(
              "the order of what causes {} is {}, before {}: where several of them serve {} in equally many steps, "
              "the first one is pushed",
              analysis::few_of(conditions, "or"), ticked_list(order), ticked_list(before), few(waiting, "or")),
          span_of(pair_.old_model, before.front()), span_of(pair_.new_model, order.front()));
    }
  }

  void conditions(ProviderId before, ProviderId after) {
    const std::vector<ConditionUse>&old_when = pair_.old_model.providers[before].when,
          &when = pair_.new_model.providers[after].when;
    const Texts was = keys_of(pair_.old_model, old_when), is = keys_of(pair_.new_model, when);
    std::set<std::string> groups, flipped;
    for (const auto& [one, other] : flipped_pairs(was, is)) {
      const auto contended = [&](Pushing& side, const Model& model, ProviderId id,
                                 const std::vector<ConditionUse>& uses) {
        return side.contended(id, {find(model, uses, one)}, {find(model, uses, other)});
      };
      const std::set<std::string> now = contended(after_pushes(), pair_.new_model, after, when);
      if (now.empty() || contended(before_pushes(), pair_.old_model, before, old_when).empty()) continue;
      groups.insert(now.begin(), now.end());
      flipped.insert({one, other});
    }
    if (flipped.empty()) return;
    add(before, after,
        fmt::format(
            "the conditions of `{}` are in the order {}, before {}: the first of them that it lacks decides how "
            "{} is pushed",
            pair_.new_model.full_name(after), list_of(only(is, flipped)), list_of(only(was, flipped)),
            few(groups, "or")));
  }

  /// A need with a choice is compared with its provider: there the order decides more.
  void needs(ProviderId before, ProviderId after) {
    const std::vector<Use<GroupId>>&old_needs = pair_.old_model.providers[before].needs,
          &needs = pair_.new_model.providers[after].needs;
    Texts was, is;
    for (const Use<GroupId>& need : old_needs) was.push_back(name_of(pair_.old_model, need.id));
    for (const Use<GroupId>& need : needs) is.push_back(name_of(pair_.new_model, need.id));
    std::set<std::string> groups, flipped;
    for (const auto& [one, other] : flipped_pairs(was, is)) {
      const auto contended = [&](Pushing& side, const Model& model, ProviderId id) {
        return side.contended(id, side.conditions_of(*model.find_group(one)),
                              side.conditions_of(*model.find_group(other)));
      };
      const std::set<std::string> now = contended(after_pushes(), pair_.new_model, after);
      if (now.empty() || contended(before_pushes(), pair_.old_model, before).empty()) continue;
      groups.insert(now.begin(), now.end());
      flipped.insert({one, other});
    }
    if (flipped.empty()) return;
    const auto listed = [&](const Texts& names) { return ticked_list(only(names, flipped)); };
    add(before, after,
        fmt::format("the needs of `{}` are in the order {}, before {}: the first condition of theirs that is lacking "
                    "decides how {} is pushed",
                    pair_.new_model.full_name(after), listed(is), listed(was), few(groups, "or")));
  }

  void add(ProviderId before, ProviderId after, const std::string& message) {
    changes_.add(ChangeKind::preference, pair_.new_model.full_name(after), message,
                 pair_.old_model.providers[before].span, pair_.new_model.providers[after].span);
  }

  static ConditionId find(const Model& model, const std::vector<ConditionUse>& uses, const std::string& key) {
    return std::find_if(uses.begin(), uses.end(), [&](const ConditionUse& use) { return key_of(model, use.id) == key; })
        ->id;
  }
  static Span span_of(const Model& model, const std::string& full_name) {
    const std::vector<ProviderId> all = model.providers.ids();
    return model.providers[id_of(model, all, full_name)].span;
  }
  static Texts only(const Texts& all, const std::set<std::string>& wanted) {
    Texts out;
    for (const std::string& each : all) {
      if (wanted.contains(each)) out.push_back(each);
    }
    return out;
  }

  Pushing& before_pushes() {
    if (!was_) was_ = std::make_unique<Pushing>(pair_.before, pair_.possible_before);
    return *was_;
  }
  Pushing& after_pushes() {
    if (!is_) is_ = std::make_unique<Pushing>(pair_.after, pair_.possible_after);
    return *is_;
  }

  const Pair& pair_;
  Changes& changes_;
  std::unique_ptr<Pushing> was_, is_; ///< computed where an order has changed
};

} // namespace

void compare_pushes(const Pair& pair, Changes& changes) {
  if (pair.old_model.deployment && pair.new_model.deployment) PushOrders(pair, changes).compare();
}

} // namespace director::compiler::diff
