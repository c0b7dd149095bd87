// Header: compiler/checks/check.hpp. Test: compiler/checks/push_inversion.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/push_inversions.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Limit for the further tasks that push the same provider, with a note each.
constexpr std::size_t most_others = 8;

class InversionReport {
public:
  InversionReport(const Input& input, Findings& findings)
      : model_(input.model),
        shared_(input.shared),
        findings_(findings) {}

  /// The first one, with a note for each further task that pushes the same provider.
  void report(const std::vector<Inversion>& pushes) {
    const Wanting& wanting = *pushes.front().wanting;
    const Want& want = *pushes.front().want;
    const ProviderId causer = pushes.front().causer;
    const Use<GroupId>& need = *pushes.front().need;
    const auto& [part, holder, below, equal, at_roots] = pushes.front().between;
    const GroupId pushed = model_.providers[causer].group;
    bool one_side = false;
    shared_.chains().visit(wanting.task, {pushed}, [&, &at = below](const Meeting& other, GroupId) {
      one_side = one_side || (other.first == at.first && other.second == at.second);
    });
    const bool differ = std::any_of(pushes.begin() + 1, pushes.end(),
                                    [&](const Inversion& each) { return each.between.holder.group != holder.group; });
    const std::string task = name_of(model_, wanting.task), between = name_of(model_, holder.group);
    const std::string what = part == need.id ? "that" : name_of(model_, part);
    const std::string holds = holder.provider ? fmt::format("{} may hold {}", between, what)
                                              : fmt::format("{} may be requested by itself", name_of(model_, part));
    dsl::Diagnostic& finding =
        findings_.add(need.span, fmt::format("{} pushes {}, which needs {}, and {}: it {} {} and {} {}", task,
                                             name_of(model_, causer), name_of(model_, need.id), holds,
                                             equal ? "is the equal of" : "goes after", task,
                                             equal ? "goes before" : "before", name_of(model_, pushed)));
    finding.notes.push_back({want.condition.span, fmt::format("{} waits for {}", name_of(model_, want.waiter),
                                                              name_of(model_, want.condition.id))});
    if (holder.provider)
      finding.notes.push_back({holder.span, fmt::format("{} {} {}", name_of(model_, *holder.provider),
                                                        holder.by_need ? "needs" : "requests", name_of(model_, part))});
    add_side(*below.first, below.first_level, holder.group, finding);
    add_side(*below.second, below.second_level, pushed, finding);
    for (std::size_t i = 1; i < pushes.size(); ++i) {
      if (i > most_others) {
        finding.notes.push_back({need.span, fmt::format("further tasks push {} too", name_of(model_, causer))});
        break;
      }
      const Inversion& other = pushes[i];
      finding.notes.push_back(
          {other.want->condition.span,
           fmt::format("{} waits for {} and pushes it too, and {} goes after {} and before {}",
                       name_of(model_, other.want->waiter), name_of(model_, other.want->condition.id),
                       name_of(model_, other.between.holder.group), name_of(model_, other.wanting->task),
                       name_of(model_, pushed))});
    }
    const std::string alone = fmt::format("let {} do without {}", name_of(model_, causer), name_of(model_, need.id));
    if (equal && !at_roots) {
      finding.help = fmt::format("{}, or request {} and {} as one unit", alone, task, between);
      return;
    }
    if (shared_.indispensable().contains(pushed, part)) { // what goes after it would have to do without that
      finding.help = below.together->provider
                         ? fmt::format("{}, or request {} where {} is not requested", alone,
                                       name_of(model_, below.first->target), name_of(model_, below.second->target))
                         : fmt::format("{}, or request {} beside {}, `apart` and with a lower priority", alone,
                                       name_of(model_, pushed), task);
      return;
    }
    if (const std::optional<Turned> turned = find_turned(holder, part)) {
      finding.help = turned->causer == holder.provider
                         ? fmt::format("{}, or {}, which {} pushes, without {}", alone, name_of(model_, turned->causer),
                                       name_of(model_, turned->task), name_of(model_, turned->need))
                         : alone;
      return;
    }
    if (differ && !one_side) {
      finding.help = fmt::format("{}; or order them anew: first all tasks that push it, then {}, then what may hold {}",
                                 alone, name_of(model_, pushed), name_of(model_, part));
      return;
    }
    if (may_push(holder.group, pushed)) { // before it, that one would no longer push
      finding.help = alone;
      return;
    }
    finding.help = one_side || equal
                       ? fmt::format("{}, or {} go after {}, and that still after {}", alone, between,
                                     name_of(model_, pushed), task)
                       : fmt::format("let {} go before {}, and still after {}", name_of(model_, below.second->target),
                                     name_of(model_, below.first->target), task);
  }

private:
  /// A push of the group in between that needs the part too.
  struct Turned {
    GroupId task{};
    ProviderId causer{};
    GroupId need{};
  };

  /// Whether a task waits for what a provider of the other group causes.
  bool may_push(GroupId task, GroupId group) {
    const auto& all = pushes_of(group);
    return std::any_of(all.begin(), all.end(), [&](const auto& push) { return push.second == task; });
  }

  const std::set<std::pair<ProviderId, GroupId>>& pushes_of(GroupId group) {
    if (pushes_of_.empty()) {
      pushes_of_.resize(model_.groups.size());
      for (const Wanting& wanting : shared_.wants()) {
        for (const Want& want : wanting.wants) {
          for (const ProviderId id : want.causers)
            pushes_of_[model_.providers[id].group.value].insert({id, wanting.task});
        }
      }
    }
    return pushes_of_[group.value];
  }

  /// Another order would only turn the two round then. First the one by which it holds the part, if that is pushed.
  std::optional<Turned> find_turned(const Inversion::Holder& holder, GroupId part) {
    std::optional<Turned> out;
    for (const auto& [id, task] : pushes_of(holder.group)) {
      if (out && id != holder.provider) continue;
      for (const Use<GroupId>& need : model_.providers[id].needs) {
        const auto& parts = shared_.indispensable().of(need.id);
        if (!parts || std::find(parts->begin(), parts->end(), part) == parts->end()) continue;
        out = Turned{task, id, need.id};
        if (id == holder.provider) return out;
        break;
      }
    }
    return out;
  }

  void add_side(const Task& entry, const Level& level, GroupId meant, dsl::Diagnostic& finding) const {
    const std::string leads = entry.target == meant ? "" : fmt::format(", which leads to {},", name_of(model_, meant));
    finding.notes.push_back({entry.span, fmt::format("here {}{} has {}priority {}", name_of(model_, entry.target),
                                                     leads, level.optional ? "optional, " : "", level.priority)});
  }

  const Model& model_;
  const Shared& shared_;
  Findings& findings_;
  std::vector<std::set<std::pair<ProviderId, GroupId>>> pushes_of_; ///< of each group: who is pushed, and by what task
};

} // namespace

void push_inversion(const Input& input, Findings& findings) {
  InversionReport report(input, findings);
  for (const auto& [span, pushes] : find_inversions(input)) report.report(pushes);
}

} // namespace director::checks
