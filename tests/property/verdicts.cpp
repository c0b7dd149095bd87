// Header: tests/property/verdicts.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/verdicts.hpp"

#include <algorithm>
#include <set>

namespace director::property {

using compiler::ConditionUse;
using compiler::EdgeId;
using compiler::GroupId;
using compiler::Model;
using compiler::Provider;
using compiler::ProviderId;
using compiler::Task;
using dsl::Span;

namespace {

bool contains(const dsl::Diagnostic& finding, std::string_view words) {
  return finding.message.find(words) != std::string::npos;
}

/// The text at a place.
class Places {
public:
  explicit Places(const Model& model) : model_(model) {}

  std::optional<ProviderId> with_when(Span span) const { return with(span, &Provider::when); }
  std::optional<ProviderId> with_causing(Span span) const { return with(span, &Provider::causing); }

  std::vector<ProviderId> named(Span span) const {
    std::vector<ProviderId> out;
    for (const ProviderId id : model_.providers.ids()) {
      if (model_.providers[id].span == span || model_.group_of(id).name.span == span) out.push_back(id);
    }
    return out;
  }

  std::optional<GroupId> group(Span span) const {
    for (const GroupId id : model_.groups.ids()) {
      if (model_.groups[id].name.span == span) return id;
    }
    return std::nullopt;
  }

  struct Entry {
    std::optional<ProviderId> provider;
    std::size_t pack = 0;
    const Task* task = nullptr;
  };
  std::optional<Entry> entry(Span span) const {
    for (const Task& task : model_.roots) {
      if (task.span == span) return Entry{std::nullopt, 0, &task};
    }
    for (const ProviderId id : model_.providers.ids()) {
      const std::vector<compiler::Pack>& packs = model_.providers[id].packs;
      for (std::size_t i = 0; i < packs.size(); ++i) {
        for (const Task& task : packs[i].tasks) {
          if (task.span == span) return Entry{id, i, &task};
        }
      }
    }
    return std::nullopt;
  }

  std::optional<GroupId> need(ProviderId provider, Span span) const {
    for (const auto& use : model_.providers[provider].needs) {
      if (use.span == span) return use.id;
    }
    return std::nullopt;
  }

private:
  std::optional<ProviderId> with(Span span, std::vector<ConditionUse> Provider::*list) const {
    for (const ProviderId id : model_.providers.ids()) {
      for (const ConditionUse& use : model_.providers[id].*list) {
        if (use.span == span) return id;
      }
    }
    return std::nullopt;
  }

  const Model& model_;
};

/// The texts in backquotes, in order.
std::vector<std::string> quoted_in(const std::string& message) {
  std::vector<std::string> out;
  for (std::size_t at = message.find('`'); at != std::string::npos; at = message.find('`', at)) {
    const std::size_t end = message.find('`', at + 1);
    if (end == std::string::npos) break;
    out.push_back(message.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return out;
}

std::string note_at(const dsl::Diagnostic& finding, Span span) {
  for (const dsl::Note& note : finding.notes) {
    if (note.span == span) return note.message;
  }
  return {};
}

/// The requester may be named with its provider.
std::optional<EdgeId> edge_between(const Model& model, const std::string& requester, const std::string& target) {
  for (const EdgeId id : model.edges.ids()) {
    const compiler::Edge& edge = model.edges[id];
    if (edge.requester && model.groups[*edge.requester].name.value == requester.substr(0, requester.find('.')) &&
        model.groups[edge.target].name.value == target)
      return id;
  }
  return std::nullopt;
}

/// "`S` is unset, v0 or v2", "`S` is 0 to 20".
std::optional<NeverWhile::Part> part_of(std::string_view words, const Model& model) {
  const std::size_t name = words.find('`') + 1, end = words.find('`', name);
  const auto state = model.find_state(words.substr(name, end - name));
  if (!state || words.substr(end, 5) != "` is ") return std::nullopt;
  NeverWhile::Part out{*state, {}, false};
  std::optional<std::int64_t> first; // of a range
  bool is_range = false;
  for (std::size_t from = end + 5; from < words.size();) {
    const std::size_t to = std::min(words.find_first_of(" ,", from), words.size());
    const std::string_view word = words.substr(from, to - from);
    from = std::min(words.find_first_not_of(" ,", to), words.size());
    if (word == "or") continue;
    if (word == "unset") {
      out.unset = true;
    } else if (word == "to") {
      is_range = true;
    } else if (const auto value = model.states[*state].value_of(word)) {
      for (auto each = is_range ? *first : *value; each <= *value; ++each)
        out.values = out.values.united(compiler::ValueSet::single(each));
      first = value, is_range = false;
    } else {
      return std::nullopt;
    }
  }
  return out;
}

/// Of "no provider of `A` or `B` can run while `S` is v0 and `T` is v1", or more of the like.
std::vector<Claim> gaps_of(const dsl::Diagnostic& finding, const Model& model, const std::vector<GroupId>& groups) {
  std::vector<Claim> out;
  const std::string_view message = finding.message;
  for (std::size_t at = message.find("while `"); at != std::string_view::npos; at = message.find("while `", at + 1)) {
    std::string_view gap = message.substr(at);
    for (const std::string_view behind : {" or while `", ", while `", " or in ", ", in "})
      gap = gap.substr(0, gap.find(behind));
    std::vector<NeverWhile::Part> parts;
    bool known = true;
    while (known && !gap.empty()) {
      const std::size_t end = std::min(gap.find(" and `"), gap.size());
      const auto part = part_of(gap.substr(0, end), model);
      known = part.has_value();
      if (part) parts.push_back(*part);
      gap.remove_prefix(end == gap.size() ? end : end + 5);
    }
    for (const GroupId group : groups) {
      if (known) out.push_back(NeverWhile{group, parts});
    }
  }
  return out;
}

} // namespace

std::vector<Claim> claims_of(const dsl::Diagnostic& finding, const Model& model) {
  const Places places(model);
  std::vector<Claim> out;
  const auto never_runs = [&](std::optional<ProviderId> provider) {
    if (provider) out.push_back(NeverRuns{*provider});
  };
  const auto notes_with = [&](std::string_view words) {
    std::vector<Span> spans;
    for (const dsl::Note& note : finding.notes) {
      if (note.message.find(words) != std::string::npos) spans.push_back(note.span);
    }
    return spans;
  };
  const std::string& id = finding.id;
  // Explanations end at providers that never run.
  for (const Span span : notes_with("but never runs itself")) {
    if (const auto entry = places.entry(span); entry && entry->provider) never_runs(*entry->provider);
  }
  for (const Span span : notes_with("never runs: whenever it could")) {
    for (const ProviderId provider : places.named(span)) {
      const std::vector<std::string> names = quoted_in(note_at(finding, span));
      if (!names.empty() && names.front() == model.full_name(provider)) out.push_back(NeverRuns{provider});
    }
  }
  if (id == "contradictory_when" || id == "unreachable_when" || id == "state_without_source") {
    never_runs(places.with_when(finding.span));
    for (const Span span : notes_with("looked at here too")) never_runs(places.with_when(span));
  } else if (id == "unreachable_causing" || id == "unpushable_causing") {
    never_runs(places.with_causing(finding.span));
  } else if (id == "shadowed_provider" || id == "needs_conflict") {
    for (const ProviderId provider : places.named(finding.span)) {
      if (id == "shadowed_provider" || contains(finding, "can never run")) out.push_back(NeverRuns{provider});
    }
  } else if (id == "uncovered_state" && contains(finding, "only where it cannot")) {
    if (const auto entry = places.entry(finding.span)) out.push_back(NeverGranted{entry->task->edge});
  } else if (id == "uncovered_state") {
    std::vector<GroupId> groups;
    if (const auto group = places.group(finding.span)) groups.push_back(*group);
    for (const Span span : notes_with("nor can ")) {
      if (const auto group = places.group(span)) groups.push_back(*group);
    }
    if (!contains(finding, "can ever run")) return gaps_of(finding, model, groups);
    for (const GroupId group : groups) {
      for (const ProviderId provider : model.groups[group].providers) out.push_back(NeverRuns{provider});
    }
  } else if (id == "unused_declaration" && contains(finding, "nothing requests or needs")) {
    for (const ProviderId provider : places.named(finding.span)) out.push_back(NeverRuns{provider});
  } else if (id == "starved_task" || id == "optional_never_runs" ||
             (id == "task_cycle" && contains(finding, "that one is never granted"))) {
    if (const auto entry = places.entry(finding.span)) out.push_back(NeverGranted{entry->task->edge});
  } else if (id == "pack_conflict" || (id == "possible_pack_conflict" && contains(finding, "can never"))) {
    const auto entry = places.entry(finding.span);
    if (!entry || !entry->provider) return out;
    const std::vector<WholePack> packs = whole_packs(model);
    for (std::size_t i = 0; i < packs.size(); ++i) {
      if (packs[i].provider == *entry->provider && packs[i].pack == entry->pack) out.push_back(NeverWhole{i});
    }
  } else if (id == "self_conflict") {
    // "`Legs` never runs for `Walk` below `KickTo`, which keeps `Legs` for itself": the last name is the group that it
    // keeps.
    const auto entry = places.entry(finding.span);
    const std::vector<std::string> names = quoted_in(finding.message);
    if (!entry || !entry->provider || names.size() < 2) return out;
    if (const auto edge = edge_between(model, names[1], names[0]);
        edge && names[1].find('.') == std::string::npos && !contains(finding, "keeps")) {
      out.push_back(NeverGranted{*edge});
    } else if (const auto kept = model.find_group(names.back())) {
      const auto add = [&](Span span) {
        const auto place = places.entry(span);
        if (!edge || !place || !place->provider) return;
        const auto& providers = model.groups[model.providers[*place->provider].group].providers;
        for (const ProviderId by : providers) {
          // Without "while", also where another provider keeps the request.
          const std::vector<compiler::Pack>& packs = model.providers[by].packs;
          const bool is_kept =
              !contains(finding, "while") && std::none_of(packs.begin(), packs.end(), [&](const compiler::Pack& pack) {
                return pack.requests(place->task->edge);
              });
          if (by == *place->provider || is_kept) out.push_back(NeverBelow{by, place->task->edge, *edge, *kept});
        }
      };
      add(finding.span);
      for (const Span span : notes_with("the same here")) add(span);
    }
  } else if (id == "sibling_starvation") {
    const std::vector<std::string> names = quoted_in(finding.message);
    if (!contains(finding, "never runs for") || names.size() < 2) return out;
    if (const auto edge = edge_between(model, names.back(), names[names.size() - 2]))
      out.push_back(NeverGranted{*edge});
  } else if (id == "unused_causing" && contains(finding, "no task ever pushes")) {
    const auto causer = places.with_causing(finding.span);
    if (!causer) return out;
    for (const ConditionUse& promise : model.providers[*causer].causing) {
      for (const compiler::ConditionId condition : model.conditions.ids()) {
        if (promise.span == finding.span && model.satisfies(promise.id, condition))
          out.push_back(NeverPushed{*causer, condition, true});
      }
    }
  } else if (id == "push_in_vain" && contains(finding, " in vain once ")) {
    NeverBack claim;
    for (const std::string& name : quoted_in(finding.message)) {
      for (const compiler::ConditionId condition : model.conditions.ids()) {
        if (model.conditions[condition].text == name) claim.conditions.push_back(condition);
      }
    }
    out.push_back(claim);
  } else if (id == "imprecise_causing") {
    const auto causer = places.with_causing(finding.span);
    const auto waiter = finding.notes.empty() ? std::nullopt : places.with_when(finding.notes.front().span);
    if (!causer || !waiter) return out;
    for (const ConditionUse& use : model.providers[*waiter].when) {
      if (use.span == finding.notes.front().span) out.push_back(NeverPushed{*causer, use.id, false});
    }
  }
  return out;
}

std::vector<EdgeId> losers_of(const dsl::Diagnostic& finding, const Model& model) {
  std::vector<EdgeId> out;
  if (finding.id == "task_cycle") {
    const Places places(model);
    const auto add = [&](Span span) {
      if (const auto entry = places.entry(span)) out.push_back(entry->task->edge);
    };
    add(finding.span);
    for (const dsl::Note& note : finding.notes) add(note.span);
    return out;
  }
  if (finding.id != "sibling_starvation") return out;
  for (const dsl::Note& note : finding.notes) {
    const std::vector<std::string> names = quoted_in(note.message);
    if (names.size() != 2 || note.message.find(" requests ") == std::string::npos) continue;
    if (const auto edge = edge_between(model, names[0], names[1])) out = {*edge}; // the last name is the loser
  }
  return out;
}

std::vector<ProviderId> hints_of(const dsl::Diagnostic& finding, const Model& model) {
  static const std::set<std::string> ids{"push_in_vain",      "push_cycle",         "incompatible_pushes",
                                         "imprecise_causing", "causer_not_running", "self_defeating_handler",
                                         "undone_by_stop",    "undone_by_fallback", "causer_goes_first"};
  std::vector<ProviderId> out;
  if (finding.id == "possible_pack_conflict" && !contains(finding, "can never")) {
    // "can be granted together only by other providers": the providers that it names are not among them.
    for (const ProviderId id : model.providers.ids()) {
      const auto& needs = model.providers[id].needs;
      if (contains(finding, "`" + model.full_name(id) + "`") &&
          std::any_of(needs.begin(), needs.end(),
                      [&](const auto& need) { return !note_at(finding, need.span).empty(); }))
        out.push_back(id);
    }
  }
  if (!ids.contains(finding.id)) return out;
  const Places places(model);
  const auto add = [&](Span span) {
    for (const auto& each : {places.with_when(span), places.with_causing(span)}) {
      if (each) out.push_back(*each);
    }
  };
  add(finding.span);
  for (const dsl::Note& note : finding.notes) add(note.span);
  return out;
}

std::vector<compiler::StateId> lacking_of(const dsl::Diagnostic& finding, const Model& model) {
  std::vector<compiler::StateId> out;
  if (finding.id != "unreachable_when" && finding.id != "state_without_source" && finding.id != "unreachable_causing")
    return out;
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    for (const auto* list : {&provider.when, &provider.stay, &provider.causing}) {
      for (const ConditionUse& use : *list) {
        if (use.span == finding.span) out.push_back(model.conditions[use.id].state);
      }
    }
  }
  return out;
}

bool are_lost(const NeverBack& claim, const Model& model, const std::vector<std::int32_t>& values) {
  return std::none_of(claim.conditions.begin(), claim.conditions.end(), [&](compiler::ConditionId id) {
    const compiler::Condition& condition = model.conditions[id];
    const std::int32_t value = values[condition.state.value];
    return value != unset && condition.accepts.contains(value);
  });
}

bool is_contradicted(const Claim& claim, const Model& model, const Reached& reached) {
  struct {
    const Model& model;
    const Reached& reached;
    bool operator()(const NeverRuns& c) const { return reached.ran[c.provider.value]; }
    bool operator()(const NeverGranted& c) const { return reached.granted[c.edge.value]; }
    bool operator()(const NeverPushed& c) const {
      return (c.to_effect ? reached.pushed_to_effect : reached.pushed).contains({c.provider, c.condition});
    }
    bool operator()(const NeverWhole& c) const { return reached.whole[c.pack]; }
    bool operator()(const NeverBelow& c) const { return reached.granted_below.contains({c.provider, c.edge, c.loser}); }
    bool operator()(const NeverWhile& c) const {
      return std::any_of(reached.granted_in.begin(), reached.granted_in.end(), [&](const auto& seen) {
        return seen.first == c.group && std::all_of(c.parts.begin(), c.parts.end(), [&](const auto& part) {
                 const std::int32_t value = seen.second[part.state.value];
                 return value == unset ? part.unset : part.values.contains(value);
               });
      });
    }
    bool operator()(const NeverBack& c) const {
      return std::any_of(reached.changes.begin(), reached.changes.end(), [&](const auto& change) {
        return are_lost(c, model, change.first) && !are_lost(c, model, change.second);
      });
    }
  } look{model, reached};
  return std::visit(look, claim);
}

std::string in_words(const Claim& claim, const Model& model) {
  struct {
    const Model& model;
    std::string operator()(const NeverRuns& c) const { return model.full_name(c.provider) + " never runs"; }
    std::string operator()(const NeverGranted& c) const { return model.edge_name(c.edge) + " is never granted"; }
    std::string operator()(const NeverPushed& c) const {
      return model.full_name(c.provider) + " is never pushed for " + model.conditions[c.condition].text;
    }
    std::string operator()(const NeverWhole& c) const {
      const WholePack pack = whole_packs(model)[c.pack];
      return "pack " + model.providers[pack.provider].packs[pack.pack].name + " of " + model.full_name(pack.provider) +
             " is never granted whole";
    }
    std::string operator()(const NeverBelow& c) const {
      return model.edge_name(c.loser) + " is never granted below " + model.full_name(c.provider) + " by way of " +
             model.edge_name(c.edge);
    }
    std::string operator()(const NeverWhile& c) const {
      std::string out = model.groups[c.group].name.value + " never runs in values of";
      for (const NeverWhile::Part& part : c.parts) out += " " + model.states[part.state].name.value;
      return out;
    }
    std::string operator()(const NeverBack& c) const {
      std::string out = "once lost, these never come back:";
      for (const compiler::ConditionId id : c.conditions) out += " " + model.conditions[id].text;
      return out;
    }
  } words{model};
  return std::visit(words, claim);
}

} // namespace director::property
