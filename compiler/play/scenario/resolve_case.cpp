// Header: compiler/play/scenario/resolve_case.hpp. Test: tests/compiler/play/scenario/resolve_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/scenario/resolve_case.hpp"

#include "dsl/source/shortened.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

namespace {

std::vector<RequestedTask> whole(const Pack& pack) {
  std::vector<RequestedTask> out;
  for (const Task& task : pack.tasks) out.push_back({task.edge, task.levels.front().level, std::nullopt, false});
  return out;
}

/// An edge that the pack requests already: the entry counts.
void add_request(std::vector<RequestedTask>& request, RequestedTask entry) {
  const auto same =
      std::find_if(request.begin(), request.end(), [&](const RequestedTask& a) { return a.edge == entry.edge; });
  if (same == request.end()) {
    request.push_back(std::move(entry));
  } else {
    *same = std::move(entry);
  }
}

const Pack* find_pack(ProviderId id, const Word& name, Names& names) {
  const Provider& provider = names.model.providers[id];
  const std::string full = names.model.full_name(id);
  if (!provider.has_packs) {
    names.error("undefined_name", name.span, fmt::format("`{}` has no packs", full),
                "say what it requests with `tasks`");
    return nullptr;
  }
  std::vector<std::string> known;
  for (const Pack& pack : provider.packs) {
    if (pack.name == name.value) return &pack;
    known.push_back(pack.name);
  }
  names.undefined(name.span, fmt::format("`{}` has no pack called `{}`", full, name.value), name.value, known);
  return nullptr;
}

/// Each of its requests is in one of its `packs`, so a case must name a pack, not a bare list of tasks.
void pack_is_missing(const dsl::CaseSpec& spec, ProviderId id, Names& names) {
  std::vector<std::string> known;
  for (const Pack& pack : names.model.providers[id].packs) known.push_back(pack.name);
  const bool listed = spec.answer.value == dsl::Answer::tasks;
  names.error("missing_key", listed ? spec.answer.span : spec.span,
              fmt::format("`{}` has packs: {}", names.model.full_name(id),
                          listed ? "a case names one of them, not tasks" : "a case that answers nothing names one"),
              known.empty() ? "give it a pack to request" : "`pack:` and one of " + dsl::shortened_list(known));
}

/// An entry of `without`.
void leave_out(const Word& name, const dsl::CaseSpec& spec, const Pack& pack, Names& names, Case& out) {
  const std::string owner = fmt::format("the pack `{}` has", pack.name);
  const Task* task = names.task(pack.tasks, owner, name);
  if (task == nullptr) return;
  if (!names.model.may_be_left_out(*task)) {
    std::vector<std::string> known;
    for (const Task& each : pack.tasks) {
      if (names.model.may_be_left_out(each)) known.push_back(names.model.groups[each.target].name.value);
    }
    names.undefined(name.span, fmt::format("{} no optional task called `{}`", owner, name.value), name.value, known)
        .notes.push_back({task->span, "a body that requests the pack cannot leave out this one"});
    return;
  }
  const auto more = std::find_if(spec.tasks.begin(), spec.tasks.end(),
                                 [&](const dsl::RequestSpec& entry) { return entry.group.value == name.value; });
  if (more != spec.tasks.end())
    names
        .error("exclusive_keys", name.span, fmt::format("`with` and `without` both name `{}`", name.value),
               "leave it out of `with`, or request it")
        .notes.push_back({more->group.span, "`with` names it here"});
  const std::size_t erased =
      std::erase_if(out.pack, [&](const RequestedTask& request) { return request.edge == task->edge; });
  if (erased == 0 && more == spec.tasks.end())
    names.error("redefined_name", name.span, fmt::format("`{}` is listed twice", name.value), "remove one of them");
}

void check_requests(const std::vector<dsl::RequestSpec>& entries, Names& names) {
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    const auto earlier = std::find_if(
        entries.begin(), entry, [&](const dsl::RequestSpec& each) { return each.group.value == entry->group.value; });
    if (earlier == entry) continue;
    names
        .error("redefined_name", entry->group.span, fmt::format("`{}` is listed twice", entry->group.value),
               "remove one of them")
        .notes.push_back({earlier->group.span, "it is listed here first"});
  }
}

void resolve_answer(const dsl::CaseSpec& spec, ProviderId id, Names& names, Case& out) {
  const Provider& provider = names.model.providers[id];
  const std::string owner = fmt::format("`{}` requests", names.model.full_name(id));
  check_requests(spec.tasks, names);
  switch (spec.answer.value) {
  case dsl::Answer::done: out.answer = Case::Answer::done; return;
  case dsl::Answer::failed: out.answer = Case::Answer::failed; return;
  case dsl::Answer::keep: out.answer = Case::Answer::keep; return;
  case dsl::Answer::pack: {
    if (!spec.pack) return;
    const Pack* pack = find_pack(id, *spec.pack, names);
    if (pack == nullptr) return;
    out.pack = whole(*pack);
    out.named_pack = static_cast<std::uint32_t>(pack - provider.packs.data());
    const std::string in_pack = fmt::format("the pack `{}` has", pack->name);
    for (const dsl::RequestSpec& entry : spec.tasks) {
      if (auto request = names.request(pack->tasks, in_pack, entry)) add_request(out.pack, std::move(*request));
    }
    for (const Word& name : spec.without) leave_out(name, spec, *pack, names, out);
    return;
  }
  case dsl::Answer::nothing:
  case dsl::Answer::tasks: break;
  }
  if (provider.has_packs) return pack_is_missing(spec, id, names);
  static const std::vector<Task> none;
  const std::vector<Task>& tasks = provider.packs.empty() ? none : provider.packs.front().tasks;
  for (const dsl::RequestSpec& entry : spec.tasks) {
    if (auto request = names.request(tasks, owner, entry)) add_request(out.pack, std::move(*request));
  }
}

void resolve_uses(const dsl::CaseSpec& spec, ProviderId id, Names& names, Case& out) {
  const Model& model = names.model;
  const Provider& provider = model.providers[id];
  for (const dsl::UseGuardSpec& guard : spec.uses) {
    const std::optional<GroupId> group = names.group(guard.group);
    if (!group) continue;
    std::vector<std::string> known;
    for (const Use<GroupId>& use : provider.uses) known.push_back(model.groups[use.id].name.value);
    if (std::find(known.begin(), known.end(), guard.group.value) == known.end()) {
      const std::string name = model.full_name(id);
      dsl::Diagnostic& finding =
          names.undefined(guard.group.span,
                          fmt::format("`{}` does not see `{}`: {}", name, guard.group.value,
                                      known.empty() ? "it has no `uses`" : "it is not in its `uses`"),
                          guard.group.value, known);
      if (known.empty()) finding.help = fmt::format("write `uses: [{}]` at `{}`", guard.group.value, name);
      continue;
    }
    UseGuard resolved{std::nullopt, guard.state.value};
    for (const EdgeId edge : model.groups[provider.group].edges) {
      if (model.edges[edge].target == *group) resolved.edge = edge;
    }
    out.uses.push_back(resolved);
  }
}

bool declares(const Model& model, const std::vector<ConditionUse>& uses, const Setting& setting) {
  return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) {
    const Condition& condition = model.conditions[use.id];
    return condition.state == setting.state && condition.accepts.contains(setting.value);
  });
}

/// `handler`: start or stop; empty for a provider.
void resolve_set(const dsl::CaseSpec& spec, const std::string& owner, const std::vector<ConditionUse>& declared,
                 std::string_view handler, Names& names, Case& out) {
  for (const dsl::SettingSpec& each : spec.set) {
    const std::optional<Setting> setting = names.setting(each);
    if (!setting) continue;
    out.set.push_back(*setting);
    if (declares(names.model, declared, *setting)) continue;
    std::vector<std::string> texts;
    for (const ConditionUse& use : declared) texts.push_back(names.model.conditions[use.id].text);
    const std::string sets = fmt::format("sets: [{} == {}]", each.state.value, each.value.value);
    names.error(
        "undeclared_state_write", each.value.span,
        fmt::format("{} sets `{}` to `{}`, which it does not declare", owner, each.state.value, each.value.value),
        !texts.empty()    ? fmt::format("what it declares is `{}`", fmt::join(texts, "`, `"))
        : handler.empty() ? fmt::format("declare it: `{}`", sets)
                          : fmt::format("declare it: `{}: {{{}}}`", handler, sets));
  }
}

std::optional<TriggerId> resolve_trigger(const Word& name, Names& names) {
  const auto& triggers = names.model.triggers;
  const bool listed =
      std::any_of(triggers.begin(), triggers.end(), [&](const Trigger& trigger) { return trigger.name == name.value; });
  if (listed || !find_promise(names.model, name.value)) return names.trigger(name, false);
  names.error("undefined_name", name.span, fmt::format("no provider listens to `{}`", name.value),
              "list it in the `triggers` of the provider that reacts to it");
  return std::nullopt;
}

void resolve_guards(const dsl::CaseSpec& spec, Case& out) {
  if (spec.data) out.data = spec.data->value;
  if (spec.run) out.run = spec.run->value;
}

} // namespace

std::optional<ProviderId> find_promise(const Model& model, std::string_view trigger) {
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    const bool in_time = std::any_of(provider.causing.begin(), provider.causing.end(),
                                     [](const ConditionUse& use) { return use.within.has_value(); });
    if (in_time && trigger == fmt::format("{}.{}.broken", model.group_of(id).name.value, provider.name)) return id;
  }
  return std::nullopt;
}

Case resolve_case(const dsl::CaseSpec& spec, ProviderId id, Names& names) {
  const Provider& provider = names.model.providers[id];
  Case out;
  resolve_guards(spec, out);
  if (spec.reason) out.reason = spec.reason->value;
  if (spec.trigger) out.trigger = resolve_trigger(*spec.trigger, names);
  resolve_uses(spec, id, names, out);
  resolve_answer(spec, id, names, out);
  std::vector<ConditionUse> declared = provider.causing;
  declared.insert(declared.end(), provider.sets.begin(), provider.sets.end());
  resolve_set(spec, fmt::format("`{}`", names.model.full_name(id)), declared, {}, names, out);
  if (spec.wait) out.wait = spec.wait->value.microseconds();
  return out;
}

Case resolve_handler_case(const dsl::CaseSpec& spec, GroupId group, std::string_view which, const Handler& handler,
                          Names& names) {
  const std::string owner = fmt::format("the {} handler of `{}`", which, names.model.groups[group].name.value);
  Case out;
  resolve_guards(spec, out);
  resolve_set(spec, owner, handler.sets, which, names, out);
  return out;
}

Case unscripted(const Model& model, ProviderId id) {
  Case out;
  const Provider& provider = model.providers[id];
  if (provider.has_packs) out.named_pack = 0;
  if (!provider.packs.empty()) out.pack = whole(provider.packs.front());
  return out;
}

} // namespace director::compiler
