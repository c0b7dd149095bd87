// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace director::compiler {

namespace {

std::vector<Use<GroupId>> find_groups(Resolver& r, const std::vector<Word>& words) {
  std::vector<Use<GroupId>> out;
  for (const Word& word : words) {
    if (const auto id = find_group(r, word)) out.push_back({*id, word.span});
  }
  return out;
}

/// Keeps the first mention of each thing.
template <class T>
void drop_repeated(std::vector<T>& uses) {
  std::vector<T> out;
  for (T& use : uses) {
    if (std::none_of(out.begin(), out.end(), [&](const T& other) { return other.id == use.id; })) out.push_back(use);
  }
  uses = std::move(out);
}

/// The triggers of promises with a time limit: `Walk.halting.broken`.
std::vector<std::string> promises(const Resolver& r, const std::string& group, GroupId id) {
  std::vector<std::string> out;
  for (const dsl::ProviderSpec* provider : r.group_sources[id].providers) {
    const bool in_time = std::any_of(provider->causing.begin(), provider->causing.end(),
                                     [](const dsl::ConditionSpec& promise) { return promise.within.has_value(); });
    if (in_time) out.push_back(fmt::format("{}.{}.broken", group, provider->name.value));
  }
  return out;
}

std::vector<std::string> promises(const Resolver& r) {
  std::vector<std::string> out;
  for (const GroupId id : r.model.groups.ids()) {
    for (std::string& each : promises(r, r.model.groups[id].name.value, id)) out.push_back(std::move(each));
  }
  return out;
}

/// Whether the word names a promise with a time limit, or may do so: of a group that others provide.
bool is_promise(const Resolver& r, const std::string& name) {
  const std::size_t first = name.find('.'), last = name.rfind('.');
  const auto group = r.groups.find(name.substr(0, first));
  if (group == r.groups.end()) return false;
  if (r.is_provided_elsewhere(group->second) && first < last && name.substr(last) == ".broken" &&
      name.find('.', first + 1) == last && last > first + 1)
    return true;
  const std::vector<std::string> known = promises(r, group->first, group->second);
  return std::find(known.begin(), known.end(), name) != known.end();
}

std::optional<TriggerId> find_trigger(Resolver& r, const Word& word) {
  if (const auto at = r.triggers.find(word.value); at != r.triggers.end()) return at->second;
  if (is_promise(r, word.value)) {
    const TriggerId id = r.model.triggers.add({word.value, word.span, std::nullopt, {}});
    r.triggers.emplace(word.value, id);
    return id;
  }
  if (word.value.find('.') != std::string::npos) {
    const auto nearest = dsl::suggest(word.value, promises(r));
    r.error("undefined_name", word.span, fmt::format("there is no promise `{}`", word.value),
            nearest ? fmt::format("did you mean `{}`?", *nearest)
                    : "`Group.provider.broken` is the trigger of a provider with a `causing ... within`");
    return std::nullopt;
  }
  std::vector<std::string> known;
  for (const Trigger& trigger : r.model.triggers) known.push_back(trigger.name);
  report_undefined(r, "trigger", word, known);
  return std::nullopt;
}

std::vector<Use<TriggerId>> find_triggers(Resolver& r, const std::vector<Word>& words) {
  std::vector<Use<TriggerId>> out;
  for (const Word& word : words) {
    if (const auto id = find_trigger(r, word)) out.push_back({*id, word.span});
  }
  return out;
}

/// The entries beside `providers` apply to each provider, and come first.
template <class T>
std::vector<T> merged(const std::vector<T>& for_all, std::vector<T> own) {
  own.insert(own.begin(), for_all.begin(), for_all.end());
  drop_repeated(own);
  return own;
}

/// The keys beside `providers`.
struct ForAll {
  std::vector<ConditionUse> sets;
  std::vector<Use<GroupId>> uses;
  std::vector<Use<TriggerId>> triggers;
};

ForAll resolve_for_all(Resolver& r, const dsl::GroupSpec* spec) {
  if (!spec) return {};
  return {resolve_conditions(r, spec->sets), find_groups(r, spec->uses), find_triggers(r, spec->triggers)};
}

void resolve_packs(Resolver& r, Provider& provider, const dsl::ProviderSpec& spec) {
  if (spec.tasks) provider.packs.push_back({"", spec.name.span, resolve_tasks(r, provider.group, *spec.tasks), {}});
  if (!spec.packs) return;
  provider.has_packs = true;
  for (const dsl::PackSpec& pack : *spec.packs) {
    check_name(r, "pack", pack.name);
    if (pack.name.value == capitalised(spec.name.value)) {
      r.error("redefined_name", pack.name.span,
              fmt::format("the pack `{}` is called like what the body of its provider gets in C++", pack.name.value),
              "give the pack another name")
          .notes.push_back({spec.name.span, "the provider is declared here"});
    }
    provider.packs.push_back({pack.name.value, pack.name.span, resolve_tasks(r, provider.group, pack.tasks), {}});
  }
}

Provider resolve_provider(Resolver& r, GroupId group, const dsl::ProviderSpec& spec, const ForAll& for_all) {
  Provider provider;
  provider.group = group;
  provider.name = spec.name.value;
  provider.span = spec.name.span;
  provider.direct = spec.direct;
  provider.when = resolve_conditions(r, spec.when);
  provider.stay = resolve_conditions(r, spec.stay);
  provider.causing = resolve_conditions(r, spec.causing);
  provider.sets = merged(for_all.sets, resolve_conditions(r, spec.sets));
  provider.needs = find_groups(r, spec.needs);
  provider.uses = merged(for_all.uses, find_groups(r, spec.uses));
  provider.triggers = merged(for_all.triggers, find_triggers(r, spec.triggers));
  if (spec.every) provider.every = spec.every->value.microseconds();
  resolve_packs(r, provider, spec);
  if (spec.doc) provider.doc = spec.doc->value;
  return provider;
}

std::optional<Handler> resolve_handler(Resolver& r, const std::optional<dsl::HandlerSpec>& spec) {
  if (!spec) return std::nullopt;
  return Handler{spec->span, resolve_conditions(r, spec->sets)};
}

void resolve_words(Resolver& r, Group& group, const dsl::GroupSpec& spec) {
  group.start = resolve_handler(r, spec.start);
  group.stop = resolve_handler(r, spec.stop);
  group.realtime = spec.realtime.value;
  if (spec.doc) group.doc = spec.doc->value;
  if (spec.data) {
    group.data = spec.data->value;
    group.data_span = spec.data->span;
    check_foreign_type(r, *spec.data);
  }
  if (!spec.layer) return;
  if (const auto at = r.layers.find(spec.layer->value); at != r.layers.end()) {
    group.layer = Use<LayerId>{at->second, spec.layer->span};
    return;
  }
  std::vector<std::string> known;
  for (const Layer& layer : r.model.layers) known.push_back(layer.name.value);
  report_undefined(r, "layer", *spec.layer, known);
}

/// A substitute for a missing provider, which is reported: the checks treat the rest as if it existed. It is unknown,
/// so it may set anything.
Provider stand_in(Resolver& r, GroupId id) {
  Provider out;
  out.group = id;
  out.name = "default";
  out.span = r.model.groups[id].name.span;
  out.direct = true;
  for (const StateId state : r.model.states.ids()) {
    const State& row = r.model.states[state];
    const auto [at, is_new] =
        r.conditions.try_emplace(row.name.value, ConditionId{static_cast<std::uint32_t>(r.model.conditions.size())});
    if (is_new) r.model.conditions.add({state, Condition::Op::any, {}, row.domain(), row.name.value});
    if (!row.of || row.of->id == id) out.sets.push_back({at->second, out.span, std::nullopt});
  }
  return out;
}

/// Adds a paragraph.
void add_doc(std::string& all, const std::string& doc) {
  while (all.ends_with('\n')) all.pop_back();
  all += (all.empty() ? "" : "\n\n") + doc;
}

void resolve_group(Resolver& r, GroupId id, const GroupSource& source) {
  if (source.spec) resolve_words(r, r.model.groups[id], *source.spec);
  for (const Word* doc : source.docs) add_doc(r.model.groups[id].doc, doc->value);
  const ForAll for_all = resolve_for_all(r, source.spec);
  for (const dsl::ProviderSpec* spec : source.providers) {
    const ProviderId provider = r.model.providers.add(resolve_provider(r, id, *spec, for_all));
    r.model.groups[id].providers.push_back(provider);
  }
  if (r.model.groups[id].providers.empty() && r.model.deployment)
    r.model.groups[id].providers.push_back(r.model.providers.add(stand_in(r, id)));
  for (const ProviderId provider : r.model.groups[id].providers) {
    for (const Use<GroupId>& need : r.model.providers[provider].needs) declare_need(r, id, need);
  }
}

/// Resolves what has no place in the model, to report its own faults.
void resolve_forgotten(Resolver& r) {
  if (!dsl::has_errors(r.findings)) return; // then nothing was forgotten
  Resolver scratch = r;
  for (const GroupId id : r.model.groups.ids()) {
    GroupSource source = r.group_sources[id];
    source.spec = nullptr; // its own keys have been resolved
    source.providers = source.forgotten;
    if (!source.providers.empty()) resolve_group(scratch, id, source);
  }
  for (const GroupSource& source : r.forgotten_groups) {
    resolve_group(scratch, r.groups.find(source.spec->name.value)->second, source);
  }
  r.findings = std::move(scratch.findings);
}

/// The layers of the main file come first; then those that other files add, as they are declared.
void declare_layers(Resolver& r) {
  const auto declare = [&r](const dsl::BehaviourSpec& file) {
    std::map<std::string, Span> here;
    for (const Word& name : file.layers) {
      check_name(r, "layer", name, false);
      const auto [first, is_new] = here.try_emplace(name.value, name.span);
      if (!is_new) {
        r.error("redefined_name", name.span, fmt::format("the layer `{}` is declared twice", name.value),
                "leave one of them out")
            .notes.push_back({first->second, "declared first here"});
      } else if (r.layers.try_emplace(name.value, LayerId{static_cast<std::uint32_t>(r.model.layers.size())}).second) {
        r.model.layers.add({name});
      }
    }
  };
  declare(r.main);
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    if (&file != &r.main) declare(file);
  }
}

} // namespace

void resolve_groups(Resolver& r) {
  declare_layers(r);
  for (const GroupId id : r.model.groups.ids()) resolve_group(r, id, r.group_sources[id]);
  resolve_forgotten(r);
  // The provider of a promise is known only now that all of them have their ids.
  for (Trigger& trigger : r.model.triggers) {
    const std::size_t dot = trigger.name.find('.');
    if (dot == std::string::npos) continue;
    const auto group = r.groups.find(trigger.name.substr(0, dot));
    if (group == r.groups.end()) continue;
    for (const ProviderId id : r.model.groups[group->second].providers) {
      const Provider& provider = r.model.providers[id];
      if (trigger.name == fmt::format("{}.{}.broken", r.model.groups[provider.group].name.value, provider.name))
        trigger.promise = id;
    }
  }
}

} // namespace director::compiler
