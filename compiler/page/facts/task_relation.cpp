// Header: compiler/page/facts/task_relation.hpp. Test: tests/compiler/page/facts/ranks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/facts/task_relation.hpp"

#include "compiler/page/facts/leaders.hpp"

#include <algorithm>
#include <vector>

namespace director::compiler {

namespace {

/// Whether at some level of this rank it is a member of the unit of its pack, or is not. What is optional may be
/// so by something below it.
bool may_be(const Model& model, const Task& task, const analysis::SideRank& rank, bool in_unit) {
  return std::any_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
    const Level& level = model.edges[task.edge].levels[named.level];
    return level.priority == rank.priority && (rank.optional || !level.optional) && level.shares_unit() == in_unit;
  });
}

bool may_be(const Model& model, const Task& task, const analysis::SideRank& rank) {
  return may_be(model, task, rank, true) || may_be(model, task, rank, false);
}

/// Which of two targets a provider needs.
struct NeedOf {
  bool first = false, second = false;
  bool operator==(const NeedOf&) const = default;
};

/// What the pack of one provider adds, while one with these needs is active: itself, or one that its group has
/// changed to and that has not requested anything yet.
void add_pack(const Model& model, const Pack& pack, const analysis::Decision& decision, const NeedOf& needs,
              bool is_own, TaskRelation& out) {
  const Task* const first = entry_of(pack, decision.first_sibling);
  const Task* const second = entry_of(pack, decision.second_sibling);
  const bool has_first = needs.first || (first != nullptr && may_be(model, *first, decision.first)),
             has_second = needs.second || (second != nullptr && may_be(model, *second, decision.second));
  out.at_once = out.at_once || (is_own && has_first && has_second);
  if (first != nullptr && second != nullptr) {
    out.unit =
        out.unit || (may_be(model, *first, decision.first, true) && may_be(model, *second, decision.second, true));
    const bool loose = may_be(model, *first, decision.first, false) || may_be(model, *second, decision.second, false);
    out.first_loose = out.first_loose || (loose && !needs.first);
    out.second_loose = out.second_loose || (loose && !needs.second);
  }
  out.first_alone = out.first_alone || (needs.first && !needs.second && second != nullptr);
  out.second_alone = out.second_alone || (needs.second && !needs.first && first != nullptr);
  out.first_own = out.first_own || (is_own && needs.first && second != nullptr);
  out.second_own = out.second_own || (is_own && needs.second && first != nullptr);
}

} // namespace

TaskRelation relation_of(const Model& model, const analysis::Decision& decision) {
  if (!decision.requester) return {true, false};
  TaskRelation out;
  const std::vector<ProviderId>& providers = model.groups[*decision.requester].providers;
  const auto needs_of = [&](ProviderId id) {
    const Provider& provider = model.providers[id];
    return NeedOf{provider.needs_group(model.edges[decision.first_sibling].target),
                  provider.needs_group(model.edges[decision.second_sibling].target)};
  };
  std::vector<NeedOf> all; // each once
  for (const ProviderId id : providers) {
    const NeedOf needs = needs_of(id);
    if (std::find(all.begin(), all.end(), needs) == all.end()) all.push_back(needs);
    out.at_once = out.at_once || (needs.first && needs.second);
  }
  out.first_needed = out.second_needed = out.first_own = out.second_own = out.at_once;
  for (const ProviderId id : providers) {
    const NeedOf own = needs_of(id);
    for (const Pack& pack : model.providers[id].packs) {
      for (const NeedOf& needs : all) add_pack(model, pack, decision, needs, needs == own, out);
    }
  }
  out.first_needed = out.first_needed || out.first_alone;
  out.second_needed = out.second_needed || out.second_alone;
  return out;
}

} // namespace director::compiler
