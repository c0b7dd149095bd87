// Door: compiler/checks/check.hpp. Test: compiler/checks/self_conflict.md.
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/words/notes.hpp"
#include "compiler/checks/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

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
  bool report(const Provider& provider, const Task& task, const Use<GroupId>& need) {
    const Claims& claims = input_.shared.claims(task.target, provider.group);
    for (const Reach reach : {Reach::own, Reach::mandatory}) {
      const Claim* claim = claims.find(need.id, reach);
      if (claim == nullptr || !compatible(claim->region, active_region(input_.model, provider))) continue;
      const Model& model = input_.model;
      const std::string group = name_of(model, provider.group), taken = name_of(model, need.id);
      dsl::Diagnostic& finding =
          findings_.add(task.span, fmt::format("{} requests {}, which wants {}, and keeps {} for itself", group,
                                               name_of(model, task.target), taken, taken));
      finding.notes.push_back({need.span, fmt::format("{} needs {}", group, taken)});
      add_chain(model, claims.path(need.id, reach), finding.notes);
      finding.help = fmt::format("need {} instead of {}, or nothing: what a task needs is held when it is granted",
                                 name_of(model, task.target), taken);
      return true;
    }
    return false;
  }

  const Input& input_;
  Findings& findings_;
};

} // namespace

void self_conflict(const Input& input, Findings& findings) {
  SelfConflicts conflicts(input, findings);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.active.contains(id)) conflicts.look_at(input.model.providers[id]);
  }
}

} // namespace director::checks
