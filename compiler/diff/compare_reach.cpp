// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares what may ever happen, by the facts of the checks: an over-approximation, so "never runs" is a proof and
// "reachable" means "may".
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <map>

namespace director::compiler::diff {

namespace {

/// Groups and providers by name, and whether each may ever run.
struct May {
  std::map<std::string, bool> groups, providers;
  std::set<std::pair<std::string, std::string>> pushes; ///< the waiting group, the pushable provider
};

May find_may(const Model& model, const Possible& possible) {
  May out;
  const analysis::Facts& facts = possible.facts();
  for (const GroupId id : model.groups.ids()) out.groups[name_of(model, id)] = facts.requested.contains(id);
  for (const ProviderId id : model.providers.ids()) out.providers[model.full_name(id)] = facts.active.contains(id);
  for (const auto& [waiter, causers] : possible.pushes()) {
    for (const ProviderId causer : causers) out.pushes.emplace(name_of(model, waiter), model.full_name(causer));
  }
  return out;
}

/// The provider with this full name.
const Provider* find_provider(const Model& model, const std::string& name) {
  for (const ProviderId id : model.providers.ids()) {
    if (model.full_name(id) == name) return &model.providers[id];
  }
  return nullptr;
}

class Reaching {
public:
  Reaching(const Pair& pair, Changes& changes)
      : pair_(pair),
        changes_(changes),
        was_(find_may(pair.old_model, pair.possible_before)),
        is_(find_may(pair.new_model, pair.possible_after)) {}

  void compare() {
    std::set<std::string> reported; // groups whose requests are reported: their providers are not
    for (const auto& [name, may] : is_.groups) {
      const auto old = was_.groups.find(name);
      if (old == was_.groups.end() || old->second == may) continue;
      reported.insert(name);
      const Span before = pair_.old_model.groups[*pair_.old_model.find_group(name)].name.span,
                 after = pair_.new_model.groups[*pair_.new_model.find_group(name)].name.span;
      changes_.add(may ? ChangeKind::became_reachable : ChangeKind::became_dead, name,
                   fmt::format("`{}` {}", name, may ? "may be requested now" : "is never requested any more"), before,
                   after);
    }
    for (const auto& [name, may] : is_.providers) {
      const auto old = was_.providers.find(name);
      if (old == was_.providers.end() || old->second == may) continue;
      const Provider *const before = find_provider(pair_.old_model, name), *const after =
                                                                               find_provider(pair_.new_model, name);
      if (reported.count(name_of(pair_.new_model, after->group)) != 0) continue;
      changes_.add(may ? ChangeKind::became_reachable : ChangeKind::became_dead, name,
                   fmt::format("`{}` {}", name, may ? "may run now" : "can never run any more"), before->span,
                   after->span);
    }
    for (const auto& push : is_.pushes) {
      if (was_.pushes.count(push) == 0) pushed(push, true);
    }
    for (const auto& push : was_.pushes) {
      if (is_.pushes.count(push) == 0) pushed(push, false);
    }
  }

private:
  void pushed(const std::pair<std::string, std::string>& push, bool now) {
    const auto& [waiter, causer] = push;
    const Provider *const old = find_provider(pair_.old_model, causer), *const fresh =
                                                                            find_provider(pair_.new_model, causer);
    const std::optional<Span> before = old ? std::optional(old->span) : std::nullopt,
                              after = fresh ? std::optional(fresh->span) : std::nullopt;
    changes_.add(now ? ChangeKind::push_gained : ChangeKind::push_lost, causer,
                 fmt::format("`{}` {} push `{}`", waiter, now ? "may now" : "can no longer", causer), before, after);
  }

  const Pair& pair_;
  Changes& changes_;
  May was_, is_;
};

} // namespace

void compare_reach(const Pair& pair, Changes& changes) {
  if (pair.old_model.deployment && pair.new_model.deployment) Reaching(pair, changes).compare();
}

} // namespace director::compiler::diff
