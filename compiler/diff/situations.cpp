// Header: compiler/diff/situations.hpp. Test: tests/compiler/diff/situations_test.cpp.
// SPDX-License-Identifier: MIT
//
// The definition of a group is a text with the names of what it refers to, and of the states in its conditions. Two
// texts that differ only in spelling count as a change: then something is played in vain, and nothing is reported.
#include "compiler/diff/situations.hpp"

#include "compiler/model/causers.hpp"
#include "compiler/transitions/way.hpp"

#include <fmt/format.h>

#include <deque>
#include <map>

namespace director::compiler::diff {

namespace {

using transitions::Link;
using transitions::Way;

class Words {
public:
  Words(const Model& model, const Causers& causers) : model_(model), causers_(causers) {}

  std::string of(GroupId id) {
    const Group& group = model_.groups[id];
    for (const EdgeId edge : group.requesters) {
      if (!model_.edges[edge].requester) add("program", levels(edge));
    }
    add("start", group.start);
    add("stop", group.stop);
    for (const ProviderId provider : group.providers) add(model_.providers[provider]);
    // The order of states, like that of groups, makes no other situation.
    std::map<std::string_view, StateId> states;
    for (const StateId state : states_) states.emplace(model_.states[state].name.value, state);
    for (const auto& [name, state] : states) add(state);
    return std::move(out_);
  }

private:
  void add(std::string_view what, std::string_view text) { out_ += fmt::format("{} {}\n", what, text); }

  void add(std::string_view which, const std::optional<Handler>& handler) {
    if (!handler) return;
    add(which, "");
    add("sets", handler->sets);
  }

  void add(std::string_view what, const std::vector<ConditionUse>& uses) {
    for (const ConditionUse& use : uses) {
      const Condition& condition = model_.conditions[use.id];
      states_.insert(condition.state);
      add(what, fmt::format("{} {}", condition.text, use.within.value_or(0)));
    }
  }

  /// Of providers of several groups that can be pushed for a condition, the first one is.
  void add(ConditionId id) {
    const std::vector<ProviderId>& causers = causers_[id];
    const auto is_other = [&](ProviderId other) {
      return model_.providers[other].group != model_.providers[causers.front()].group;
    };
    if (std::none_of(causers.begin(), causers.end(), is_other)) return;
    for (const ProviderId causer : causers) add("caused by", model_.full_name(causer));
  }

  std::string levels(EdgeId id) const {
    std::string out;
    for (const Level& level : model_.edges[id].levels)
      out += fmt::format(" {}{}{}", level.priority, level.optional ? "o" : "", level.apart ? "a" : "");
    return out;
  }

  void add(const Provider& provider) {
    add("provider", provider.name);
    add("when", provider.when);
    for (const ConditionUse& use : provider.when) add(use.id);
    add("stay", provider.stay);
    add("causing", provider.causing);
    add("sets", provider.sets);
    for (const Use<GroupId>& need : provider.needs) add("needs", name_of(model_, need.id));
    for (const Use<TriggerId>& use : provider.triggers) add("trigger", model_.triggers[use.id].name);
    add("every", std::to_string(provider.every.value_or(0)));
    for (const Pack& pack : provider.packs) {
      add("pack", pack.name);
      for (const Task& task : pack.tasks) {
        add("task", name_of(model_, task.target) + levels(task.edge));
        for (const Task::NamedLevel& level : task.levels) add(level.name, std::to_string(level.level));
      }
    }
  }

  void add(StateId id) {
    const State& state = model_.states[id];
    add("state", fmt::format("{} {} {}..{} {}", state.name.value, fmt::join(state.values.words(), "|"), state.low,
                             state.high, state.external));
    for (const std::int64_t value : state.unordered) add("unordered", state.value_text(value));
    if (state.initial) add("initial", state.value_text(*state.initial));
    if (state.of) add("of", name_of(model_, state.of->id));
    if (!state.expires) return;
    add("expires", std::to_string(state.expires->after));
    if (state.expires->to) add("to", state.value_text(*state.expires->to));
  }

  const Model& model_;
  const Causers& causers_;
  std::string out_;
  std::set<StateId> states_;
};

std::map<std::string, std::string> words_of_all(const Model& model) {
  const Causers causers = find_causers(model);
  std::map<std::string, std::string> out;
  for (const GroupId id : model.groups.ids()) out.emplace(name_of(model, id), Words(model, causers).of(id));
  return out;
}

/// Groups whose definition has changed, or that only one side has.
std::set<std::string> changed_groups(const Pair& pair) {
  const std::map<std::string, std::string> was = words_of_all(pair.old_model), is = words_of_all(pair.new_model);
  std::set<std::string> out;
  for (const auto& [mine, others] : {std::pair(&was, &is), std::pair(&is, &was)}) {
    for (const auto& [name, words] : *mine) {
      const auto other = others->find(name);
      if (other == others->end() || other->second != words) out.insert(name);
    }
  }
  return out;
}

/// By group: whether it has changed, or something that it may request or need, at any depth.
IdSet<GroupId> changed_below(const Model& model, const std::set<std::string>& changed) {
  IdSet<GroupId> out(model.groups.size());
  std::deque<GroupId> open;
  for (const GroupId id : model.groups.ids()) {
    if (!changed.contains(name_of(model, id))) continue;
    out.add(id);
    open.push_back(id);
  }
  for (; !open.empty(); open.pop_front()) {
    for (const EdgeId edge : model.groups[open.front()].requesters) {
      const std::optional<GroupId> requester = model.edges[edge].requester;
      if (requester && out.add(*requester)) open.push_back(*requester);
    }
  }
  return out;
}

class Side {
public:
  Side(const Model& model, const std::set<std::string>& changed)
      : model_(model),
        changed_(changed),
        below_(changed_below(model, changed)) {}

  /// Everything that decides how it is brought to run, if nothing in it has changed; otherwise empty.
  std::optional<std::string> situation(GroupId target) const {
    if (below_.contains(target)) return {};
    std::set<std::string> out; // in whatever order groups are declared
    for (const Way& way : transitions::find_ways(model_, target)) {
      if (changed_.contains(name_of(model_, way.group(0)))) return {};
      std::string words = name_of(model_, way.group(0));
      for (const Link& link : way.links) {
        if (has_changed(link)) return {};
        words +=
            fmt::format(" {} {} {}", model_.full_name(link.provider), link.pack, name_of(model_, link.next->target));
      }
      out.insert(fmt::format("{} {}\n", words, model_.full_name(way.runs)));
    }
    return fmt::format("{}", fmt::join(out, ""));
  }

private:
  /// Whether the group itself, its providers' needs, or the other requests of this link have changed.
  bool has_changed(const Link& link) const {
    const Group& group = model_.group_of(link.provider);
    if (changed_.contains(group.name.value)) return true;
    return std::any_of(group.providers.begin(), group.providers.end(), [&](ProviderId id) {
      const Provider& provider = model_.providers[id];
      const auto below = [&](const auto& use) { return below_.contains(use.id); };
      if (std::any_of(provider.needs.begin(), provider.needs.end(), below)) return true;
      if (id != link.provider && provider.causing.empty()) return false; // it does not come to run
      const bool is_pushed = id != link.provider;
      return std::any_of(provider.packs.begin(), provider.packs.end(),
                         [&](const Pack& pack) { return has_changed(pack, link.next->target, is_pushed); });
    });
  }

  bool has_changed(const Pack& pack, GroupId next, bool is_pushed) const {
    const auto leads_on = [&](const Task& task) { return task.target == next; };
    if (!is_pushed && std::none_of(pack.tasks.begin(), pack.tasks.end(), leads_on)) return false;
    // Of tasks without a named pack only the next one is requested.
    if (!is_pushed && pack.name.empty()) return false;
    return std::any_of(pack.tasks.begin(), pack.tasks.end(),
                       [&](const Task& task) { return !leads_on(task) && below_.contains(task.target); });
  }

  const Model& model_;
  const std::set<std::string>& changed_;
  const IdSet<GroupId> below_;
};

/// The requests of the program on both sides, in order: of equals the first one goes first.
std::vector<std::string> common_roots(const Model& mine, const Model& other) {
  std::vector<std::string> out;
  for (const Task& root : mine.roots) {
    const std::string& name = name_of(mine, root.target);
    if (std::any_of(other.roots.begin(), other.roots.end(),
                    [&](const Task& each) { return name_of(other, each.target) == name; }))
      out.push_back(name);
  }
  return out;
}

bool same_program(const Model& was, const Model& is) {
  return was.trials.most == is.trials.most && was.pass.most == is.pass.most &&
         common_roots(was, is) == common_roots(is, was);
}

} // namespace

std::set<std::string> changed_situations(const Pair& pair) {
  const std::set<std::string> changed = changed_groups(pair);
  const Side was(pair.old_model, changed), is(pair.new_model, changed);
  const bool same = same_program(pair.old_model, pair.new_model);
  std::map<std::string, GroupId> old;
  for (const GroupId id : pair.old_model.groups.ids()) old.emplace(name_of(pair.old_model, id), id);
  std::set<std::string> out;
  for (const GroupId id : pair.new_model.groups.ids()) {
    if (pair.new_model.groups[id].edges.empty()) continue;
    const std::string& name = name_of(pair.new_model, id);
    const auto before = old.find(name);
    if (before == old.end()) continue;
    const std::optional<std::string> now = same ? is.situation(id) : std::nullopt;
    if (!now || was.situation(before->second) != now) out.insert(name);
  }
  return out;
}

} // namespace director::compiler::diff
