// Door: compiler/checks/check.hpp. Test: compiler/checks/self_conflict.md.
#include "compiler/checks/analysis/claims.hpp"
#include "compiler/checks/analysis/facts.hpp"
#include "compiler/checks/analysis/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace director::checks {

namespace {

class SelfConflicts {
public:
  SelfConflicts(const Input& input, Findings& findings) : input_(input), findings_(findings) {}

  void look_at(const Provider& provider) {
    for (const Pack& pack : provider.packs) {
      for (const Task& task : pack.tasks) {
        for (const Use<GroupId>& need : provider.needs) {
          if (task.target != need.id && task.target != provider.group && report(provider, task, need)) break;
        }
      }
    }
  }

private:
  /// What a task may claim while its requester runs: nothing goes through that again.
  const Claims& claims_of(GroupId task, GroupId requester) {
    const auto at = claims_.find({task, requester});
    if (at != claims_.end()) return at->second;
    const auto counts = [&](ProviderId id) { return input_.facts.active.contains(id); };
    return claims_.emplace(std::pair{task, requester}, Claims(input_.model, task, counts, {requester})).first->second;
  }

  bool report(const Provider& provider, const Task& task, const Use<GroupId>& need) {
    const Claims& claims = claims_of(task.target, provider.group);
    for (const Reach reach : {Reach::own, Reach::mandatory}) {
      const Claim* claim = claims.find(need.id, reach);
      if (claim == nullptr || !compatible(claim->region, active_region(input_.model, provider))) continue;
      const Model& model = input_.model;
      const std::string group = name_of(model, provider.group), taken = name_of(model, need.id);
      dsl::Diagnostic& finding =
          findings_.add(task.span, fmt::format("{} requests {}, which wants {}, and keeps {} for itself", group,
                                               name_of(model, task.target), taken, taken));
      finding.notes.push_back({need.span, fmt::format("{} needs {}", group, taken)});
      for (const ClaimStep& step : claims.path(need.id, reach))
        finding.notes.push_back({step.span, fmt::format("{} {} {}", name_of(model, step.from),
                                                        step.by_need ? "needs" : "requests", name_of(model, step.to))});
      finding.help = fmt::format("need {} instead of {}, or nothing: what a task needs is held when it is granted",
                                 name_of(model, task.target), taken);
      return true;
    }
    return false;
  }

  const Input& input_;
  Findings& findings_;
  std::map<std::pair<GroupId, GroupId>, Claims> claims_;
};

} // namespace

void self_conflict(const Input& input, Findings& findings) {
  SelfConflicts conflicts(input, findings);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.active.contains(id)) conflicts.look_at(input.model.providers[id]);
  }
}

} // namespace director::checks
