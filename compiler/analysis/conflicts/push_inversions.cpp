// Header: compiler/analysis/conflicts/push_inversions.hpp. Test: compiler/checks/push_inversion.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/push_inversions.hpp"

#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/graph/dominators.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace director::analysis {

namespace {

class Inversions {
public:
  explicit Inversions(const Input& input)
      : model_(input.model),
        graph_(input.graph),
        facts_(input.facts),
        shared_(input.shared) {}

  std::map<dsl::Span, std::vector<Inversion>> find() {
    for (const Wanting& wanting : shared_.wants()) {
      for (const Want& want : wanting.wants) look_at(wanting, want);
    }
    return std::move(found_);
  }

private:
  using Holder = Inversion::Holder;
  using Between = Inversion::Between;

  void look_at(const Wanting& wanting, const Want& want) {
    for (const ProviderId causer : want.causers) {
      const std::vector<Use<GroupId>>& needs = model_.providers[causer].needs;
      if (std::all_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) { return is_full(need); })) continue;
      find_company(wanting.task, model_.providers[causer].group);
      below_.clear();
      above_pushed_.clear();
      find_own(causer);
      when_ = region_of(model_, model_.providers[causer].when);
      for (const Use<GroupId>& need : needs) {
        const auto& parts = shared_.indispensable().of(need.id);
        if (!parts || is_full(need)) continue;
        std::optional<Between> worst;
        for (const GroupId part : *parts) find_between(wanting.task, want, causer, part, worst);
        if (worst && seen_.insert({need.span, want.condition.span, worst->holder.group}).second)
          found_[need.span].push_back({&wanting, &want, causer, &need, *worst});
      }
    }
  }

  /// If the pushed group is always requested with the task, it is held by that request or by a stronger one.
  void find_company(GroupId task, GroupId pushed) {
    near_.clear();
    Company company(model_, facts_, shared_.requests(), {pushed});
    for (const Request& request : shared_.requests().of(task)) {
      if (!company.find_bare_chain(request).empty()) return;
    }
    near_ = company.found_in();
  }

  /// Finds the groups that the pushed provider has in every plan. Such a group holds its own needs for its holder, so
  /// only another holder of that group can be in the way.
  void find_own(ProviderId causer) {
    own_.clear();
    for (const Use<GroupId>& need : model_.providers[causer].needs) {
      if (const auto& parts = shared_.indispensable().of(need.id)) own_.insert(parts->begin(), parts->end());
    }
  }

  /// The two meet where the pushed group is requested with the task, or further down.
  bool is_near(const Meeting& meeting) const {
    if (near_.empty() || near_.count(meeting.together->tasks) != 0) return true;
    if (!meeting.together->provider) return false;
    const GroupId group = model_.providers[*meeting.together->provider].group;
    return std::any_of(near_.begin(), near_.end(), [&](const std::vector<Task>* entries) {
      return std::any_of(entries->begin(), entries->end(),
                         [&](const Task& entry) { return shared_.claims(entry.target).contains(group); });
    });
  }

  /// Whether more tasks push its provider already than are reported.
  bool is_full(const Use<GroupId>& need) const {
    const auto at = found_.find(need.span);
    return at != found_.end() && at->second.size() == most_inversions;
  }

  /// Of several the one that goes first: if the pushed group goes before that one, it does before all of them.
  void find_between(GroupId task, const Want& want, ProviderId causer, GroupId part,
                    std::optional<Between>& worst) const {
    const GroupId pushed = model_.providers[causer].group;
    for (const Holder& holder : holders_of(part)) {
      if (!is_between(task, want, causer, holder)) continue;
      const std::vector<Meeting> above = find_above(task, holder, pushed, part);
      const std::optional<Meeting> below = above.empty() ? std::nullopt : find_below(task, holder, pushed, above);
      if (!below || (worst && !goes_before(*below, worst->below))) continue;
      const bool equal = std::none_of(above.begin(), above.end(), [&](const Meeting& each) {
        return each.first_goes_before() && at_once(each, *below);
      });
      worst = Between{part, holder, *below, equal, !above.front().together->provider};
    }
  }

  /// Compares by the first entry, for equal second ones.
  static bool goes_before(const Meeting& a, const Meeting& b) {
    if (a.second != b.second) return false;
    return std::pair(!a.first_optional, a.first_level.priority) > std::pair(!b.first_optional, b.first_level.priority);
  }

  /// Where the waiting task goes before the holder, or is its equal, which keeps what it holds although the task itself
  /// takes nothing of that. Nothing that is in one unit with the task is granted.
  std::vector<Meeting> find_above(GroupId task, const Holder& holder, GroupId pushed, GroupId part) const {
    std::vector<Meeting> out;
    shared_.chains().visit(task, {holder.group}, [&](const Meeting& found, GroupId) {
      const bool keeps = found.equal() && !shared_.claims(task).contains(part);
      if ((!found.first_goes_before() && !keeps) || (holder.root != nullptr && found.second != holder.root)) return;
      if (found.one_unit() && found.first->target == task) return;
      if (leads_to(*found.second, holder.group, task, pushed) && !join(found, task, holder.group)) out.push_back(found);
    });
    return out;
  }

  /// Whether their entries have these levels at the same time: each request has one.
  static bool at_once(const Meeting& a, const Meeting& b) {
    const auto contradict = [](const Task& one, const Level& its, const Task& other, const Level& level) {
      return one.edge == other.edge && its != level;
    };
    return !contradict(*a.first, a.first_level, *b.first, b.first_level) &&
           !contradict(*a.first, a.first_level, *b.second, b.second_level) &&
           !contradict(*a.second, a.second_level, *b.first, b.first_level) &&
           !contradict(*a.second, a.second_level, *b.second, b.second_level);
  }

  /// Where the holder goes before the pushed group, while the waiting task goes before the holder.
  std::optional<Meeting> find_below(GroupId task, const Holder& holder, GroupId pushed,
                                    const std::vector<Meeting>& above) const {
    std::optional<Meeting> out;
    shared_.chains().visit(holder.group, {pushed}, [&](const Meeting& found, GroupId) {
      if (out || !found.first_goes_before() || (holder.root != nullptr && found.first != holder.root)) return;
      if (!is_near(found) || !leads_to(*found.first, holder.group, task, pushed)) return;
      if (!leads_to_pushed(*found.second, pushed, task)) return; // the task requests nothing while it waits
      if (std::none_of(above.begin(), above.end(), [&](const Meeting& each) { return at_once(each, found); })) return;
      if (!join(found, holder.group, pushed)) out = found;
    });
    return out;
  }

  /// Whether a chain of requests from the entry to the group passes neither the waiting task nor the pushed one.
  bool leads_to(const Task& entry, GroupId group, GroupId task, GroupId pushed) const {
    if (entry.target == task || entry.target == pushed) return false;
    const Claims& all = shared_.claims(entry.target);
    if (!all.contains(group)) return false;
    if (!all.contains(task) && !all.contains(pushed)) return true;
    const std::vector<GroupId> without{task, pushed};
    return below_.try_emplace(entry.target, shared_.branches(), entry.target, without).first->second.contains(group);
  }

  /// Whether a chain of requests from the entry to the pushed group does not pass the waiting task.
  bool leads_to_pushed(const Task& entry, GroupId pushed, GroupId task) const {
    if (entry.target == task) return false;
    if (!shared_.claims(entry.target).contains(task)) return true;
    const std::vector<GroupId> without{task};
    return above_pushed_.try_emplace(entry.target, shared_.branches(), entry.target, without)
        .first->second.contains(pushed);
  }

  /// Whether all chains from the two entries to these groups pass one and the same group. Only one requester holds
  /// that, so the two tasks never meet at these entries.
  bool join(const Meeting& meeting, GroupId first, GroupId second) const {
    const std::vector<GroupId>& a = gates(meeting.first->target, first);
    const std::vector<GroupId>& b = gates(meeting.second->target, second);
    return std::any_of(a.begin(), a.end(), [&](GroupId each) { return std::binary_search(b.begin(), b.end(), each); });
  }

  /// The groups that every chain from the one to the other passes, both included; sorted.
  const std::vector<GroupId>& gates(GroupId from, GroupId to) const {
    const auto [at, fresh] = gates_.try_emplace({from, to});
    std::vector<GroupId>& out = at->second;
    if (!fresh) return out;
    if (from == to) return out = {from};
    if (arrows_.empty()) {
      arrows_.resize(model_.groups.size());
      for (const GroupId group : model_.groups.ids()) {
        for (const Branch& branch : shared_.branches().from(group)) arrows_[group.value].push_back(branch.to.value);
      }
    }
    const DominatorTree tree(arrows_, from.value);
    for (const GroupId each : shared_.claims(from).groups()) {
      if (tree.is_below(to.value, each.value)) out.push_back(each);
    }
    return out;
  }

  const std::vector<Holder>& holders_of(GroupId group) const {
    const auto [at, fresh] = holders_.try_emplace(group);
    std::vector<Holder>& out = at->second;
    if (!fresh) return out;
    for (const Task& root : model_.roots) {
      if (root.target == group) out.push_back({group, std::nullopt, root.span, false, &root});
    }
    for (const EdgeId edge : model_.groups[group].requesters) {
      if (!model_.edges[edge].requester) continue;
      const GroupId requester = *model_.edges[edge].requester;
      for (const ProviderId id : model_.groups[requester].providers) {
        if (!facts_.active.contains(id)) continue;
        if (const std::optional<Holder> holder = holder_by(requester, id, group)) out.push_back(*holder);
      }
    }
    return out;
  }

  std::optional<Holder> holder_by(GroupId requester, ProviderId id, GroupId group) const {
    for (const Use<GroupId>& need : model_.providers[id].needs) {
      if (need.id == group) return Holder{requester, id, need.span, true, nullptr};
    }
    for (const Pack& pack : model_.providers[id].packs) {
      for (const Task& task : pack.tasks) {
        if (task.target == group && !model_.edges[task.edge].levels[task.levels.front().level].optional)
          return Holder{requester, id, task.span, false, nullptr};
      }
    }
    return std::nullopt;
  }

  /// Whether it may hold the group while the task waits, and not only by a push of the same task.
  bool is_between(GroupId task, const Want& want, ProviderId causer, const Holder& holder) const {
    const GroupId pushed = model_.providers[causer].group;
    if (holder.group == pushed || holder.group == task || hangs_on(holder.group, pushed) ||
        hangs_on(holder.group, task))
      return false;
    if (!holder.provider) return true;
    if (own_.count(holder.group) != 0) return false;
    const ProviderId provider = *holder.provider;
    if (!facts_.chosen.contains(provider) && pushed_by(task).count(provider) != 0) return false;
    const auto [place, fresh] = active_.try_emplace(provider);
    if (fresh) place->second = active_region(model_, model_.providers[provider]);
    const Region& region = place->second;
    const Condition& wanted = model_.conditions[want.condition.id];
    const auto at = region.states.find(wanted.state);
    if (at != region.states.end() && at->second.subset_of(wanted.accepts)) return false;
    return compatible(region, when_);
  }

  /// The providers that a task for this group may push, and what is only ever requested in one unit with it.
  const std::set<ProviderId>& pushed_by(GroupId task) const {
    if (pushing_ == task) return pushed_;
    pushing_ = task;
    pushed_.clear();
    add_pushed_by(task);
    for (const Request& request : shared_.requests().of(task)) {
      if (!request.requester || request.pack->name.empty() || !model_.is_always_member(*request.task)) continue;
      for (const Task& other : request.pack->tasks) {
        if (model_.is_always_member(other) && shared_.requests().of(other.target).size() == 1)
          add_pushed_by(other.target);
      }
    }
    return pushed_;
  }

  void add_pushed_by(GroupId task) const {
    for (const Want* want : shared_.wants_of(task)) pushed_.insert(want->causers.begin(), want->causers.end());
  }

  /// Whether every chain of requests to the group passes the other one.
  bool hangs_on(GroupId group, GroupId other) const {
    std::optional<GroupId> gate = graph_.gate[group];
    while (gate && *gate != other) gate = graph_.gate[*gate];
    return gate.has_value();
  }

  const Model& model_;
  const Graph& graph_;
  const Facts& facts_;
  const Shared& shared_;
  std::set<const std::vector<Task>*> near_; ///< of the current push; empty: they may meet anywhere
  std::set<GroupId> own_;                   ///< of the provider that is pushed
  /// What a group leads to without the waiting task and the pushed one.
  mutable std::map<GroupId, Claims> below_;
  mutable std::map<GroupId, Claims> above_pushed_; ///< what it leads to without the waiting task
  mutable std::map<std::pair<GroupId, GroupId>, std::vector<GroupId>> gates_;
  mutable Arrows arrows_; ///< of requests and needs; empty: not found yet
  Region when_;           ///< with which the pushed provider may begin
  mutable std::map<GroupId, std::vector<Holder>> holders_;
  mutable std::map<ProviderId, Region> active_; ///< where these may run
  mutable std::optional<GroupId> pushing_;
  mutable std::set<ProviderId> pushed_;                      ///< by the task `pushing_`
  std::set<std::tuple<dsl::Span, dsl::Span, GroupId>> seen_; ///< need, condition, and who is between
  std::map<dsl::Span, std::vector<Inversion>> found_;        ///< by need
};

} // namespace

std::map<dsl::Span, std::vector<Inversion>> find_inversions(const Input& input) { return Inversions(input).find(); }

} // namespace director::analysis
