// Door: compiler/checks/analysis/conflicts/starving.hpp. Test: compiler/checks/starved_task.md.
#include "compiler/checks/analysis/conflicts/starving.hpp"

#include "compiler/checks/analysis/conflicts/certainties.hpp"
#include "compiler/checks/analysis/conflicts/conflicts.hpp"
#include "compiler/checks/analysis/needs/needs.hpp"
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/words/notes.hpp"
#include "compiler/checks/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace director::checks {

namespace {

class StarvationSearch {
public:
  explicit StarvationSearch(const Input& input)
      : input_(input),
        certainties_(input),
        entries_(input.model.groups.size()),
        taken_(input.model.groups.size()),
        never_runs_(input.model.groups.size()) {
    for (const PackConflict& conflict : input.conflicts.pack_conflicts()) conflicts_.insert(&conflict.pack->tasks);
    for (const Together& together : input.shared.chains().together()) {
      for (const Task& task : *together.tasks) entries_[task.target].push_back({&together, &task});
    }
  }

  std::vector<StarvingTask> run() {
    for (const Node node : input_.graph.order) look_at(GroupId{node});
    std::sort(found_.begin(), found_.end(), [](const StarvingTask& a, const StarvingTask& b) {
      return a.places.front().task->edge < b.places.front().task->edge;
    });
    return std::move(found_);
  }

private:
  using Taken = std::map<GroupId, Starver>; ///< by group

  struct Entry {
    const Together* together;
    const Task* task;
  };

  /// Requesters come before what they request.
  void look_at(GroupId group) {
    std::map<EdgeId, StarvingTask> by_edge;
    std::set<EdgeId> fed; ///< edges by which it is granted sometimes
    std::optional<Taken> common;
    for (const Entry& entry : entries_[group]) {
      const bool is_root = !entry.together->provider;
      if (!is_root && never_runs_.contains(requester_of(entry))) continue;
      Taken taken = taken_at(entry);
      if (const auto starver = find_starver(entry, taken)) {
        by_edge[entry.task->edge].places.push_back({entry.task, *starver});
      } else {
        fed.insert(entry.task->edge);
        common = common ? both(*common, taken) : std::move(taken);
      }
    }
    if (common) taken_[group] = std::move(*common);
    if (fed.empty()) never_runs_.add(group);
    for (auto& [edge, starving] : by_edge) {
      if (fed.count(edge) != 0) continue;
      starving.optional = is_optional(*starving.places.front().task);
      found_.push_back(std::move(starving));
    }
  }

  GroupId requester_of(const Entry& entry) const { return input_.model.providers[*entry.together->provider].group; }

  bool is_optional(const Task& task) const {
    return input_.model.edges[task.edge].levels[task.levels[0].level].optional;
  }

  static Taken both(const Taken& a, const Taken& b) {
    Taken out;
    for (const auto& [group, starver] : a) {
      if (b.count(group) != 0) out.emplace(group, starver);
    }
    return out;
  }

  /// What is certain to be taken from this entry's task and all that is below it, whenever it is requested.
  Taken taken_at(const Entry& entry) {
    if (!entry.together->provider) return {};
    const Taken& above = taken_[requester_of(entry)];
    const bool has_company =
        entry.together->whole && entry.together->tasks->size() > 1 && conflicts_.count(entry.together->tasks) == 0;
    if (above.empty() && !has_company) return {};
    const Groups& wanted = input_.shared.claims(entry.task->target).groups();
    Taken out;
    for (const auto& [group, starver] : above) {
      if (has(wanted, group)) out.emplace(group, starver);
    }
    if (!has_company) return out;
    const Region region = active_region(input_.model, input_.model.providers[*entry.together->provider]);
    const Takers& takers = takers_of(*entry.together);
    for (const GroupId group : wanted) {
      const auto at = takers.find(group);
      if (at == takers.end()) continue;
      for (const Task* other : at->second) {
        if (other->target == entry.task->target || !always_before(*other, *entry.task)) continue;
        if (certainties_.never_waits(other->target, region)) out.emplace(group, Starver{other, entry.task, group});
      }
    }
    return out;
  }

  /// Which entries of a pack are certain to take each group.
  using Takers = std::unordered_map<GroupId, std::vector<const Task*>>;

  const Takers& takers_of(const Together& together) {
    const auto [at, is_new] = takers_.try_emplace(&together);
    if (!is_new) return at->second;
    for (const Task& task : *together.tasks) {
      for (const GroupId group : certainties_.of(task.target).all) at->second[group].push_back(&task);
    }
    return at->second;
  }

  /// At whichever levels the two are requested.
  bool always_before(const Task& first, const Task& second) const {
    const std::vector<Level>& a = input_.model.edges[first.edge].levels;
    const std::vector<Level>& b = input_.model.edges[second.edge].levels;
    return std::all_of(first.levels.begin(), first.levels.end(), [&](const Task::NamedLevel& x) {
      return std::all_of(second.levels.begin(), second.levels.end(), [&](const Task::NamedLevel& y) {
        const Level& one = a[x.level];
        const Level& other = b[y.level];
        return one.optional == other.optional ? one.priority > other.priority : other.optional;
      });
    });
  }

  bool in_one_unit(const Task& a, const Task& b) const {
    const auto is_member = [&](const Task& task) {
      const std::vector<Level>& levels = input_.model.edges[task.edge].levels;
      return std::any_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
        return !levels[named.level].optional && !levels[named.level].apart;
      });
    };
    return is_member(a) && is_member(b);
  }

  std::optional<Starver> find_starver(const Entry& entry, const Taken& taken) {
    const auto& must = input_.shared.indispensable().of(entry.task->target);
    if (!must) return std::nullopt;
    for (const auto& [group, starver] : taken) {
      // A unit is granted whole, before anything that one of its members requests.
      if (starver.over == entry.task && in_one_unit(*starver.by, *entry.task)) continue;
      if (has(*must, group) && !may_be_blocked(starver, *must)) return starver;
    }
    return std::nullopt;
  }

  /// Somebody else may keep the taker from something that the starving task can do without: then that one has its
  /// chance.
  bool may_be_blocked(const Starver& starver, const Groups& must) {
    const Groups& below = input_.shared.claims(starver.by->target).groups();
    const Groups& beside = input_.shared.claims(starver.over->target).groups();
    const Certain& certain = certainties_.of(starver.by->target);
    return std::any_of(certain.depends.begin(), certain.depends.end(), [&](GroupId group) {
      if (group == starver.by->target || has(must, group)) return false;
      const std::vector<EdgeId>& requesters = input_.model.groups[group].requesters;
      return std::any_of(requesters.begin(), requesters.end(), [&](EdgeId id) {
        const std::optional<GroupId> requester = input_.model.edges[id].requester;
        return !requester || !(has(below, *requester) || has(beside, *requester));
      });
    });
  }

  const Input& input_;
  Certainties certainties_;
  IdTable<GroupId, std::vector<Entry>> entries_; ///< by target
  IdTable<GroupId, Taken> taken_;                ///< whenever the group is requested
  IdSet<GroupId> never_runs_;
  std::map<const Together*, Takers> takers_;
  std::set<const std::vector<Task>*> conflicts_; ///< packs that are never granted anyway
  std::vector<StarvingTask> found_;
};

} // namespace

std::vector<StarvingTask> find_starving_tasks(const Input& input) { return StarvationSearch(input).run(); }

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings) {
  const Model& model = input.model;
  const Task& task = *starving.places.front().task;
  const Starver& starver = starving.places.front().starver;
  const std::string name = name_of(model, task.target), by = name_of(model, starver.by->target);
  const std::string requester = name_of(model, *model.edges[task.edge].requester);
  dsl::Diagnostic& finding = findings.add(
      task.span,
      starver.by->target == task.target
          ? fmt::format("{} never runs for {}: it is always requested at a higher rank as well", name, requester)
          : fmt::format(
                "{} never runs for {}: {}, which goes before it and never has to wait, is always requested with it "
                "and takes {}",
                name, requester, by, name_of(model, starver.group)));
  finding.notes.push_back({starver.by->span, fmt::format("{} is requested here", by)});
  if (starver.over != &task)
    finding.notes.push_back({starver.over->span, fmt::format("and goes before {}, which leads to {}",
                                                             name_of(model, starver.over->target), name)});
  const Claims& claims = input.shared.claims(starver.by->target);
  const Reach reach = claims.find(starver.group, Reach::own) != nullptr ? Reach::own : Reach::mandatory;
  add_chain(model, claims.path(starver.group, reach), finding.notes);
  add_chain(model, need_path(model, task.target, starver.group), finding.notes);
  for (std::size_t i = 1; i < starving.places.size(); ++i) {
    const StarvingTask::Place& place = starving.places[i];
    finding.notes.push_back(
        {place.task->span, fmt::format("the same here, by {}, which takes {}", name_of(model, place.starver.by->target),
                                       name_of(model, place.starver.group))});
  }
  finding.help = starving.optional
                     ? fmt::format("ask for it where {} is not asked for: what is optional goes after all "
                                   "that is mandatory",
                                   by)
                     : fmt::format("give it a higher priority, or ask for it where {} is not asked for", by);
}

} // namespace director::checks
