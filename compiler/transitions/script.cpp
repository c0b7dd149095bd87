// Header: compiler/transitions/script.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
//
// A body that is on both chains first answers what leads to the row, for as many runs as it had until that was at rest,
// and from then on what leads to the column. Where the two chains part, it keeps the one task and requests the other.
#include "compiler/transitions/script.hpp"

#include "compiler/model/closure.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace director::compiler::transitions {

namespace {

std::string name_of(const Model& model, const Task& task) {
  return dsl::yaml_word(model.groups[task.target].name.value);
}

/// `{Motion: still, Grip: open}`, with the first value of each; empty if there is none.
std::string settings(const Model& model, const Values& values) {
  std::vector<std::string> pairs;
  for (const auto& [id, value] : values) {
    const State& state = model.states[id];
    pairs.push_back(fmt::format("{}: {}", dsl::yaml_word(state.name.value), dsl::yaml_word(state.value_text(value))));
  }
  return fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

std::string setting_words(const Model& model, const Values& values) {
  return values.empty() ? std::string{} : "set: " + settings(model, values);
}

/// The values that a pushed body sets: it keeps its promises.
Values promised(const Model& model, ProviderId id) {
  Values out;
  for (const ConditionUse& use : model.providers[id].causing) {
    const Condition& condition = model.conditions[use.id];
    if (!condition.accepts.empty()) out.emplace(condition.state, condition.accepts.intervals().front().low);
  }
  return out;
}

/// The values with which it may go on: what is left of them by its own conditions and promises on that state, as long
/// as any are left.
ValueSet suitable(const Model& model, const Provider& provider, StateId state, ValueSet values) {
  for (const std::vector<ConditionUse>* uses : {&provider.causing, &provider.when, &provider.stay}) {
    for (const ConditionUse& use : *uses) {
      const Condition& condition = model.conditions[use.id];
      if (condition.state != state) continue;
      const ValueSet left = values.intersected(condition.accepts);
      if (!left.empty()) values = left;
    }
  }
  return values;
}

/// For each state in its `sets` the first value that contradicts the promises of the other providers of its group, all
/// of them if possible: a provider that walks does not stand. `only_certain`: only where `sets` has one value.
Values opposed(const Model& model, ProviderId id, bool only_certain) {
  Values out;
  const Provider& provider = model.providers[id];
  for (const ConditionUse& use : provider.sets) {
    const Condition& condition = model.conditions[use.id];
    if (only_certain && condition.accepts.count() != 1) continue;
    const ValueSet values = suitable(model, provider, condition.state, condition.accepts);
    ValueSet any, all = values;
    for (const ProviderId other : model.groups[provider.group].providers) {
      for (const ConditionUse& promise : model.providers[other].causing) {
        const Condition& against = model.conditions[promise.id];
        if (other == id || against.state != condition.state) continue;
        any = any.united(values.without(against.accepts));
        all = all.without(against.accepts);
      }
    }
    if (!any.empty()) out.emplace(condition.state, (all.empty() ? any : all).intervals().front().low);
  }
  return out;
}

/// `{reason: pushed, pack: go, wait: 1 ms}`; empty parts are left out.
std::string mapping(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  std::copy_if(words.begin(), words.end(), std::back_inserter(out),
               [](const std::string& word) { return !word.empty(); });
  return fmt::format("{{{}}}", fmt::join(out, ", "));
}

/// The first pack, or all tasks.
std::string usual(const Model& model, ProviderId id) {
  const Provider& provider = model.providers[id];
  if (provider.packs.empty()) return {};
  const Pack& pack = provider.packs.front();
  if (provider.has_packs) return "pack: " + dsl::yaml_word(pack.name);
  std::vector<std::string> names;
  for (const Task& task : pack.tasks) names.push_back(name_of(model, task));
  return names.empty() ? std::string{} : fmt::format("tasks: [{}]", fmt::join(names, ", "));
}

std::string leads_on(const Model& model, const Link& link) {
  const Provider& provider = model.providers[link.provider];
  if (provider.has_packs) return "pack: " + dsl::yaml_word(provider.packs[link.pack].name);
  return fmt::format("tasks: [{}]", name_of(model, *link.next));
}

std::string kept(const Model& model, const Task& task) { return name_of(model, task) + ": {keep: true}"; }

/// A pack that requests both; the column's own, if there is none.
const Pack& pack_of_both(const Provider& provider, const Link& row, const Link& column) {
  const std::vector<Pack>& packs = provider.packs;
  if (packs[row.pack].requests(column.next->edge)) return packs[row.pack];
  const auto both = std::find_if(packs.begin(), packs.end(), [&](const Pack& pack) {
    return pack.requests(row.next->edge) && pack.requests(column.next->edge);
  });
  return both == packs.end() ? packs[column.pack] : *both;
}

/// Where the chains part: keeps the row's task, and requests the column's.
std::string leads_beside(const Model& model, const Link& row, const Link& column) {
  const Provider& provider = model.providers[column.provider];
  if (!provider.has_packs) return fmt::format("tasks: [{}, {}]", kept(model, *row.next), name_of(model, *column.next));
  const Pack& pack = pack_of_both(provider, row, column);
  if (!pack.requests(row.next->edge)) return leads_on(model, column);
  return fmt::format("pack: {}, with: [{}]", dsl::yaml_word(pack.name), kept(model, *row.next));
}

/// ... and when the row's task is done, only the column's, if it can be requested alone.
std::string goes_on_with(const Model& model, const Link& row, const Link& column) {
  const Provider& provider = model.providers[column.provider];
  if (!provider.has_packs) return fmt::format("tasks: [{}]", kept(model, *column.next));
  for (const Pack& pack : provider.packs) {
    if (pack.requests(column.next->edge) && !pack.requests(row.next->edge))
      return fmt::format("pack: {}, with: [{}]", dsl::yaml_word(pack.name), kept(model, *column.next));
  }
  return "continue: true";
}

/// Adds what a body does in a case: it sets these values, but from the column's request on none that is set from
/// outside.
void add_cases(ProviderId id, const std::string& guard, const Model& model, const Values& values, const Until& until,
               std::initializer_list<std::string> answer, std::vector<std::string>& out) {
  Values left = values;
  std::erase_if(left, [&](const auto& each) { return until.outside.contains(each.first); });
  const auto add = [&](const std::string& run, const Values& set) {
    std::vector<std::string> words{run, guard, setting_words(model, set)};
    words.insert(words.end(), answer);
    out.push_back(mapping(words));
  };
  const auto ran = until.runs.find(id);
  const std::uint32_t runs = left.size() == values.size() || ran == until.runs.end() ? 0 : ran->second;
  for (std::uint32_t run = 1; run <= runs; ++run) add(fmt::format("run: {}", run), values);
  add({}, left);
}

/// Adds its answers when it is pushed, and otherwise. True: it sets something.
bool add_answer(ProviderId id, const Model& model, const Until& until, std::initializer_list<std::string> answer,
                std::vector<std::string>& out) {
  const Values promise = promised(model, id), against = opposed(model, id, until.only_certain);
  if (!promise.empty()) add_cases(id, "reason: pushed", model, promise, until, answer, out);
  add_cases(id, {}, model, against, until, answer, out);
  return !promise.empty() || !against.empty();
}

/// Those that may run if the program requests only these.
IdSet<GroupId> below(const Model& model, std::vector<GroupId> requested) {
  add_led_to(model, requested);
  IdSet<GroupId> out(model.groups.size());
  for (const GroupId id : requested) out.add(id);
  return out;
}

/// The bodies of providers outside of the chains, if they promise something, or set what contradicts a promise. The
/// others answer as usual. Without those that do not come to run: the text is read for each play.
Script usual_script(const Model& model, std::initializer_list<GroupId> requested, const Until& until) {
  Script out;
  const IdSet<GroupId> may_run = below(model, requested);
  for (const ProviderId id : model.providers.ids()) {
    if (!may_run.contains(model.providers[id].group)) continue;
    std::vector<std::string> cases;
    if (add_answer(id, model, until, {usual(model, id)}, cases)) out[id] = std::move(cases);
  }
  return out;
}

/// The row's task is done a millisecond later: by then each group that could take what it holds has done so.
void add_target(const Model& model, GroupId target, const Until& until, Script& out) {
  for (const ProviderId id : model.groups[target].providers) {
    std::vector<std::string> cases{"{reason: wait, done: true}"};
    add_answer(id, model, until, {usual(model, id), "wait: 1 ms"}, cases);
    out[id] = std::move(cases);
  }
}

void add_link(const Model& model, const Link& link, bool passes_done, const Until& until, Script& out) {
  std::vector<std::string> cases;
  if (passes_done) cases.emplace_back("{reason: subtask_done, done: true}");
  const std::string answer = leads_on(model, link);
  add_answer(link.provider, model, until, {answer}, cases);
  out[link.provider] = std::move(cases);
}

} // namespace

Parting part(const Model& model, const Way& row, const Way& column) {
  Parting out;
  const std::size_t most = std::min(row.links.size(), column.links.size());
  for (std::size_t i = 0; i < most && row.group(i) == column.group(i); ++i) out.link = i;
  if (!out.link) return out;
  const Link &first = row.links[*out.link], &second = column.links[*out.link];
  const Provider& provider = model.providers[second.provider];
  if (first.provider != second.provider) {
    out.replaced = !provider.has_packs || !provider.packs[second.pack].requests(first.next->edge);
  } else {
    out.replaced = provider.has_packs && !pack_of_both(provider, first, second).requests(first.next->edge);
  }
  return out;
}

namespace {

Script script_from(Script out, const Model& model, const Way& row, const Until& until) {
  for (const Link& link : row.links) add_link(model, link, true, until, out);
  add_target(model, row.target, until, out);
  return out;
}

/// From the column's request on it sets what it may set of `given`.
void set_given(const Model& model, ProviderId id, const Way& row, const Until& until, Script& out) {
  Values values = settable(model, id, until.given);
  if (values.empty()) return;
  const auto link =
      std::find_if(row.links.begin(), row.links.end(), [&](const Link& each) { return each.provider == id; });
  const std::string answer = link == row.links.end() ? usual(model, id) : leads_on(model, *link);
  const Values against = opposed(model, id, until.only_certain);
  std::vector<std::string> cases;
  if (link != row.links.end()) cases.push_back(out.at(id).front()); // that its task is done
  const auto ran = until.runs.find(id);
  for (std::uint32_t run = 1; ran != until.runs.end() && run <= ran->second; ++run)
    cases.push_back(mapping({fmt::format("run: {}", run), setting_words(model, against), answer}));
  values.insert(against.begin(), against.end());
  cases.push_back(mapping({setting_words(model, values), answer}));
  out[id] = std::move(cases);
}

} // namespace

Values settable(const Model& model, ProviderId id, const Values& values) {
  Values out;
  const std::vector<ConditionUse>& sets = model.providers[id].sets;
  for (const auto& each : values) {
    const bool may = std::any_of(sets.begin(), sets.end(), [&](const ConditionUse& use) {
      const Condition& condition = model.conditions[use.id];
      return condition.state == each.first && condition.accepts.contains(each.second);
    });
    if (may) out.insert(each);
  }
  return out;
}

std::vector<ProviderId> beside(const Model& model, const Way& way) {
  std::vector<ProviderId> out;
  for (std::size_t i = 0; i < way.links.size(); ++i) {
    for (const ProviderId id : model.groups[way.group(i)].providers) {
      if (id != way.links[i].provider) out.push_back(id);
    }
  }
  return out;
}

bool leaves_choice(const Model& model) {
  const auto ids = model.providers.ids();
  return std::any_of(ids.begin(), ids.end(),
                     [&](ProviderId id) { return opposed(model, id, false) != opposed(model, id, true); });
}

Script script_of(const Model& model, const Way& row, const Until& until) {
  return script_from(usual_script(model, {row.root->target}, until), model, row, until);
}

Script script_of(const Model& model, const Way& row, const Way& column, const Until& until) {
  Script out = script_from(usual_script(model, {row.root->target, column.root->target}, until), model, row, until);
  if (!until.given.empty()) {
    for (const ProviderId id : beside(model, column)) set_given(model, id, row, until, out);
  }
  const Parting parting = part(model, row, column);
  // The requester of both continues when the first one is done.
  if (parting.link) out[row.links[*parting.link].provider].front() = "{reason: subtask_done, continue: true}";
  for (std::size_t i = 0; i < column.links.size(); ++i) {
    const Link& link = column.links[i];
    const auto same = std::find_if(row.links.begin(), row.links.end(),
                                   [&](const Link& each) { return each.provider == link.provider; });
    const bool on_both = same != row.links.end();
    std::vector<std::string> cases;
    const auto ran = until.runs.find(link.provider);
    for (std::uint32_t run = 1; ran != until.runs.end() && run <= ran->second; ++run)
      cases.push_back(
          mapping({fmt::format("run: {}", run), setting_words(model, opposed(model, link.provider, until.only_certain)),
                   on_both ? leads_on(model, *same) : usual(model, link.provider)}));
    std::string answer = leads_on(model, link);
    if (on_both && parting.link == i && !parting.replaced) {
      answer = leads_beside(model, *same, link);
      cases.push_back(mapping({"reason: subtask_done", goes_on_with(model, *same, link)}));
    }
    add_answer(link.provider, model, until, {answer}, cases);
    out[link.provider] = std::move(cases);
  }
  return out;
}

std::string settings_step(const Model& model, const Values& values) {
  return fmt::format("  - set: {}\n", settings(model, values));
}

std::string request_step(const Model& model, const Way& way, const Values& values) {
  const std::string name = name_of(model, *way.root);
  if (values.empty()) return fmt::format("  - request: {}\n", name);
  return fmt::format("  - inputs: [{{set: {}}}, {{request: {}}}]\n", settings(model, values), name);
}

std::string given_text(const Model& model, const Values& values) {
  return values.empty() ? std::string{} : fmt::format("given: {}\n", settings(model, values));
}

std::string done_step() { return "  - advance: 1 ms\n"; }

std::string entry_text(const Model& model, ProviderId id, const std::vector<std::string>& cases) {
  std::string out = fmt::format("  {}.{}:\n", model.group_of(id).name.value, model.providers[id].name);
  for (const std::string& each : cases) out += fmt::format("    - {}\n", each);
  return out;
}

} // namespace director::compiler::transitions
