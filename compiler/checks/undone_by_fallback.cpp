// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/clashes/granted.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace director::checks {

namespace {

/// Another provider of the causing group, and what it sets.
struct Fallback {
  ProviderId provider{};
  ConditionUse entry{};
  bool promised = false;
  ValueSet values; ///< of these, those with which the waiter cannot continue
};

class UndoneByFallback {
public:
  UndoneByFallback(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        findings_(findings) {}

  void look_at(const Wanting& wanting) {
    const auto has_needs = [&](ProviderId causer) { return !model_.providers[causer].needs.empty(); };
    const auto may_be_lost = [&](const Want& want) {
      return std::any_of(want.causers.begin(), want.causers.end(), has_needs);
    };
    if (std::none_of(wanting.wants.begin(), wanting.wants.end(), may_be_lost)) return;
    for (const Granted& granted : granted_with(model_, shared_, wanting.task)) {
      for (const Want& want : wanting.wants) look_at(granted, wanting, want);
    }
  }

private:
  void look_at(const Granted& granted, const Wanting& wanting, const Want& want) {
    for (const ProviderId causer : want.causers) {
      if (granted.takings.takes(model_.providers[causer].group)) continue;
      const Use<GroupId>* need = granted.takings.need_taken(causer);
      if (need == nullptr || seen_.count({need->span, want.condition.span}) != 0) continue;
      const std::optional<Fallback> fallback = find_fallback(wanting, want, causer, granted.takings);
      if (fallback) report(granted, want, causer, *need, *fallback);
    }
  }

  /// The first one that can continue without what is taken, if no earlier one always can.
  std::optional<Fallback> find_fallback(const Wanting& wanting, const Want& want, ProviderId causer,
                                        const Takings& takings) const {
    Region here = region_of(model_, model_.providers[wanting.provider].when);
    here.meet(region_of(model_, model_.providers[want.waiter].when));
    for (const ProviderId id : model_.groups[model_.providers[causer].group].providers) {
      if (id == causer || !facts_.active.contains(id) || takings.need_taken(id) != nullptr) continue;
      const Region own = region_of(model_, model_.providers[id].when);
      if (!compatible(here, own)) continue;
      const std::optional<Fallback> found = find_undoing(want, id);
      if (found || contains(own, here)) return found;
    }
    return std::nullopt;
  }

  std::optional<Fallback> find_undoing(const Want& want, ProviderId id) const {
    const Provider& row = model_.providers[id];
    for (const std::vector<ConditionUse>* entries : {&row.sets, &row.causing}) {
      for (const ConditionUse& entry : *entries) {
        const Condition& set = model_.conditions[entry.id];
        if (set.state != model_.conditions[want.condition.id].state) continue;
        ValueSet values = undoing_values(model_, want.waiter, want.condition.id, set.accepts);
        if (!values.empty()) return Fallback{id, entry, entries == &row.causing, std::move(values)};
      }
    }
    return std::nullopt;
  }

  void report(const Granted& granted, const Want& want, ProviderId causer, const Use<GroupId>& need,
              const Fallback& fallback) {
    std::vector<std::string> names;
    for (const Use<GroupId>* each : granted.takings.needs_taken(causer)) {
      seen_.insert({each->span, want.condition.span});
      names.push_back(name_of(model_, each->id));
    }
    const std::string causing = name_of(model_, causer), lost = list_of(names);
    const std::string set = fmt::format("{} may {} {}", name_of(model_, fallback.provider),
                                        fallback.promised ? "cause" : "set", name_of(model_, fallback.entry.id));
    dsl::Diagnostic& finding = findings_.add(
        need.span, fmt::format("{} loses {} when {}, which waits for {}; instead of it {}: the two go round", causing,
                               lost, is_granted(model_, granted), name_of(model_, want.condition.id), set));
    add_taking(model_, want, causes(model_, causer, want.condition.id), granted.takings.way_to(need), finding);
    finding.notes.push_back({fallback.entry.span, set});
    finding.help = fmt::format("let {} do without {}, or {}", causing, lost, stay_help(model_, want, fallback.values));
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  Findings& findings_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
};

} // namespace

void undone_by_fallback(const Input& input, Findings& findings) {
  UndoneByFallback undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) undone.look_at(wanting);
}

} // namespace director::checks
