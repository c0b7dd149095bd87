// Header: compiler/analysis/causing/root_causers.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/root_causers.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// At every level of both.
bool always_before(const Model& model, const Task& first, const Task& second) {
  const auto& firsts = model.edges[first.edge].levels;
  const auto& seconds = model.edges[second.edge].levels;
  return std::all_of(firsts.begin(), firsts.end(), [&](const Level& a) {
    return std::all_of(seconds.begin(), seconds.end(),
                       [&](const Level& b) { return a.optional == b.optional ? a.priority > b.priority : b.optional; });
  });
}

} // namespace

std::optional<RootCauser> RootCausers::of(ProviderId waiter, ConditionId condition) {
  if (!facts_.impossible_of(waiter).empty()) return std::nullopt;
  const auto [at, is_new] = only_causers_.try_emplace(condition);
  if (is_new) at->second = find_only_causer(condition);
  const std::optional<ProviderId> causer = at->second;
  if (!causer || !runs_once(*causer)) return std::nullopt;
  const Task* const root = root_before(model_.providers[*causer].group, model_.providers[waiter].group);
  if (root == nullptr) return std::nullopt;
  return RootCauser{*causer, root};
}

/// The provider that causes the condition, if nothing else can make it true after the start.
std::optional<ProviderId> RootCausers::find_only_causer(ConditionId id) {
  const Condition& condition = model_.conditions[id];
  if (model_.states[condition.state].of) return std::nullopt; // it begins again
  if (!sources_) sources_ = find_sources(model_);
  std::optional<ProviderId> out;
  for (const Source& source : (*sources_)[condition.state]) {
    if (source.kind == Source::Kind::initial || !source.values.overlaps(condition.accepts)) continue;
    if (source.kind != Source::Kind::causing || (out && out != source.provider)) return std::nullopt;
    out = source.provider;
  }
  return out && model_.causes(*out, id) ? out : std::nullopt;
}

/// Whether it is chosen from the start, and runs again only if the body or a new task says so.
bool RootCausers::runs_once(ProviderId id) const {
  const Provider& row = model_.providers[id];
  return facts_.chosen.contains(id) && model_.groups[row.group].providers.size() == 1 && row.when.empty() &&
         row.needs.empty() && row.packs.empty() && row.triggers.empty() && !row.every;
}

/// The root of the first group, if each is requested only as a root, and it goes before the other one.
const Task* RootCausers::root_before(GroupId first, GroupId second) const {
  const auto root_of = [&](GroupId group) -> const Task* {
    const Group& row = model_.groups[group];
    if (!std::all_of(row.requesters.begin(), row.requesters.end(),
                     [&](EdgeId edge) { return !model_.edges[edge].requester; }))
      return nullptr;
    const auto at =
        std::find_if(model_.roots.begin(), model_.roots.end(), [&](const Task& root) { return root.target == group; });
    return at == model_.roots.end() ? nullptr : &*at;
  };
  const Task *a = root_of(first), *b = root_of(second);
  return a != nullptr && b != nullptr && always_before(model_, *a, *b) ? a : nullptr;
}

} // namespace director::analysis
