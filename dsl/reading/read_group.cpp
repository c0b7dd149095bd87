// Header: dsl/reading/read_group.hpp. Test: tests/dsl/reading/read_group_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_group.hpp"

#include "dsl/lexical/suggest.hpp"
#include "dsl/reading/read_condition.hpp"
#include "dsl/reading/read_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace director::dsl {

namespace {

/// Keys of a provider that are forbidden beside `providers`; `sets`, `uses` and `triggers` are allowed there, and apply
/// to all providers.
constexpr std::array<std::string_view, 7> provider_only{"when", "stay", "causing", "needs", "every", "tasks", "packs"};

/// Reads all keys but `name`, `doc` and `allow`, which belong to the group if the provider is direct.
void read_provider_words(Reader& reader, const YamlNode& mapping, ProviderSpec& provider) {
  const auto conditions = [&](std::string_view key, ConditionUse use) {
    return read_conditions(reader, mapping.find(key), key, use);
  };
  provider.when = conditions("when", ConditionUse::comparison);
  provider.stay = conditions("stay", ConditionUse::comparison);
  provider.causing = conditions("causing", ConditionUse::causing);
  provider.sets = conditions("sets", ConditionUse::sets);
  provider.needs = reader.words(mapping.find("needs"), "needs", "the name of a group");
  provider.uses = reader.words(mapping.find("uses"), "uses", "the name of a group");
  provider.triggers = reader.words(mapping.find("triggers"), "triggers", "the name of a trigger");
  provider.every = reader.duration(mapping.find("every"), "every");
  provider.tasks = read_tasks(reader, mapping.find("tasks"), "tasks");
  provider.packs = read_packs(reader, mapping.find("packs"));
  reader.exclude(mapping, "tasks", "packs", "make one of the packs of the tasks");
  if (provider.tasks && provider.packs) provider.packs.reset();
}

const Keys provider_keys{"name",     "when",  "stay",  "causing", "sets", "needs", "uses",
                         "triggers", "every", "tasks", "packs",   "doc",  "allow", "because"};

/// `- walking: {...}`
const YamlPair* named_by_its_key(const YamlNode& mapping) {
  if (mapping.pairs.size() != 1) return nullptr;
  const YamlPair& pair = mapping.pairs.front();
  const bool is_key = std::find(provider_keys.begin(), provider_keys.end(), pair.key.value) != provider_keys.end();
  const bool is_body = pair.value.kind == YamlNode::Kind::mapping || pair.value.kind == YamlNode::Kind::null;
  return is_key || !is_body ? nullptr : &pair;
}

ProviderSpec read_provider(Reader& reader, const YamlNode& mapping) {
  const Span first = mapping.pairs.empty() ? mapping.span : mapping.pairs.front().key.span;
  const YamlNode* name = mapping.find("name");
  const bool named = name && name->kind == YamlNode::Kind::scalar;
  reader.know_keys(mapping, named ? fmt::format("provider `{}`", name->text) : "a provider", provider_keys,
                   slips_of_group());
  ProviderSpec provider;
  provider.span = mapping.span;
  provider.name = reader.word(reader.require(mapping, "name", "a provider", first, "name: walking"), "name", "a name")
                      .value_or(Word{"", first});
  read_provider_words(reader, mapping, provider);
  provider.doc = reader.text(mapping.find("doc"), "doc");
  provider.allow = read_allow(reader, mapping);
  return provider;
}

/// For `providers: {walking: {...}}` and for one provider without its dash.
std::string help_for_providers(const YamlNode* node) {
  if (!node || node->pairs.empty()) return "";
  if (node->find("name")) return "each is an entry of a list: write `- ` before its `name`";
  return fmt::format("their order is that of preference: write `- name: {}`, and its other words below",
                     node->pairs.front().key.value);
}

std::vector<ProviderSpec> read_providers(Reader& reader, const YamlNode* node) {
  std::vector<ProviderSpec> out;
  if (!reader.is_list(node, "providers", "a list of providers", help_for_providers(node),
                      "for example `[{name: walking}, {name: standing}]`"))
    return out;
  for (const YamlNode& item : node->items) {
    const std::string word = item.kind == YamlNode::Kind::scalar ? item.text : "";
    if (!reader.is_mapping(&item, "providers", "a mapping such as {name: walking}",
                           word.empty() ? "" : fmt::format("write `{{name: {}}}`", word), ""))
      continue;
    if (const YamlPair* pair = named_by_its_key(item)) {
      reader.error("missing_key", pair->key.span, "a provider needs `name`",
                   fmt::format("write `- name: {}`, and its other words below", pair->key.value));
    } else {
      out.push_back(read_provider(reader, item));
    }
  }
  return out;
}

/// Reads the provider of a group that has the provider's keys itself.
ProviderSpec read_direct_provider(Reader& reader, const YamlNode& mapping, const GroupSpec& group) {
  ProviderSpec provider;
  provider.name = {"default", group.name.span};
  provider.direct = true;
  provider.span = group.span;
  read_provider_words(reader, mapping, provider);
  return provider;
}

/// `start: true`, `stop: {sets: [...]}`.
std::optional<HandlerSpec> read_handler(Reader& reader, const YamlNode* node, std::string_view which) {
  if (!node || node->kind == YamlNode::Kind::broken) return std::nullopt;
  HandlerSpec handler{{}, node->span};
  if (node->kind == YamlNode::Kind::scalar && !node->quoted() && node->text == "true") return handler;
  const YamlNode* sets = node->find("sets");
  if (node->kind == YamlNode::Kind::mapping) {
    // The first key that the mapping cannot have.
    const auto other = std::find_if(node->pairs.begin(), node->pairs.end(),
                                    [](const YamlPair& pair) { return pair.key.value != "sets"; });
    if (other != node->pairs.end()) {
      reader.error(
          "start_stop_shape", other->key.span,
          fmt::format("`{}`: expected true or a mapping with `sets` alone, found `{}`", which, other->key.value),
          "a handler requests nothing and promises nothing: what it may set stands in its `sets`");
      return std::nullopt;
    }
  }
  if (node->kind != YamlNode::Kind::mapping || node->pairs.size() != 1 || !sets) {
    reader.error(
        "start_stop_shape", node->span,
        fmt::format("`{}`: expected true or a mapping with `sets` alone, found {}", which, found(*node)),
        node->kind == YamlNode::Kind::scalar && is_a_no(node->text)
            ? "a group without one leaves it out"
            : fmt::format("write `{}: true`, or what it may set: `{}: {{sets: [Pose == standing]}}`", which, which));
    return std::nullopt;
  }
  handler.sets = read_conditions(reader, sets, "sets", ConditionUse::sets);
  return handler;
}

const Keys group_keys{"doc",       "layer", "module", "data",    "realtime", "start",  "stop",
                      "providers", "when",  "stay",   "causing", "sets",     "needs",  "uses",
                      "triggers",  "every", "tasks",  "packs",   "allow",    "because"};

bool is_group_key(std::string_view word) {
  return std::find(group_keys.begin(), group_keys.end(), word) != group_keys.end();
}

std::string help_for_group_key(std::string_view key) {
  return fmt::format("`{}` is a key of a group: is the line indented as it should be?", key);
}

/// For `Walk: [Legs]` and `Walk: Legs`, which is no key that lacks its colon, and for a key of a group beside it.
std::string help_for_short_group(const YamlPair& pair) {
  const YamlNode& value = pair.value;
  if (is_group_key(pair.key.value)) return help_for_group_key(pair.key.value);
  const bool is_word = value.kind == YamlNode::Kind::scalar && value.text.find(' ') == std::string::npos;
  if (value.kind != YamlNode::Kind::list && !is_word) return "";
  return fmt::format("what it requests stands in `tasks`, what it must control in `needs`: `{}: {{tasks: [{}]}}`",
                     pair.key.value, is_word ? value.text : "...");
}

/// In `tasks: {Walk: {priority: 5}}` that stands beside the group: `Walk`, which is like no key of a group.
const YamlPair* entry_of_group_key(const YamlPair& pair) {
  if (!is_group_key(pair.key.value)) return nullptr;
  const auto entry = std::find_if(pair.value.pairs.begin(), pair.value.pairs.end(), [](const YamlPair& each) {
    return !is_group_key(each.key.value) && !help_for(slips_of_group(), each.key.value) &&
           !suggest(each.key.value, group_keys);
  });
  return entry == pair.value.pairs.end() ? nullptr : &*entry;
}

/// The members of a struct are left to C++.
std::optional<Word> read_type_of_data(Reader& reader, const YamlNode* node) {
  constexpr std::string_view expected = "a C++ type";
  if (node == nullptr || (node->pairs.empty() && node->items.empty()))
    return reader.cpp_word(node, "data", expected, "bad_type", data_fault);
  reader.unexpected(*node, "data", expected,
                    "what has members is a struct in a header of yours: `data: robot::Course`, and under `cpp` "
                    "`headers: [robot/course.hpp]`");
  return std::nullopt;
}

} // namespace

GroupSpec read_group(Reader& reader, const YamlPair& pair) {
  GroupSpec group;
  group.span = pair.span;
  group.name = reader.name(pair);
  group.realtime.span = pair.key.span;
  const YamlNode& mapping = pair.value;
  if (!reader.is_mapping(&mapping, pair.key.value, "a mapping", help_for_short_group(pair))) return group;
  const std::string thing = fmt::format("group `{}`", pair.key.value);
  if (const YamlPair* entry = entry_of_group_key(pair)) {
    reader.error("unknown_key", entry->key.span, fmt::format("{} has no key `{}`", thing, entry->key.value),
                 help_for_group_key(pair.key.value));
    return group;
  }
  reader.know_keys(mapping, thing, group_keys, slips_of_group());
  group.doc = reader.text(mapping.find("doc"), "doc");
  group.layer = reader.word(mapping.find("layer"), "layer", "the name of a layer");
  group.module = reader.word(mapping.find("module"), "module", "the name of a module");
  group.data = read_type_of_data(reader, mapping.find("data"));
  if (const auto flag = reader.flag(mapping.find("realtime"), "realtime")) group.realtime = *flag;
  group.start = read_handler(reader, mapping.find("start"), "start");
  group.stop = read_handler(reader, mapping.find("stop"), "stop");
  group.allow = read_allow(reader, mapping);
  if (!mapping.find("providers")) {
    group.providers.push_back(read_direct_provider(reader, mapping, group));
    return group;
  }
  for (const std::string_view word : provider_only)
    reader.exclude(mapping, "providers", word, fmt::format("move `{}` into the providers that it is meant for", word));
  group.providers = read_providers(reader, mapping.find("providers"));
  group.sets = read_conditions(reader, mapping.find("sets"), "sets", ConditionUse::sets);
  group.uses = reader.words(mapping.find("uses"), "uses", "the name of a group");
  group.triggers = reader.words(mapping.find("triggers"), "triggers", "the name of a trigger");
  return group;
}

ExtendSpec read_extend(Reader& reader, const YamlPair& pair) {
  static const Keys keys{"before", "providers", "doc"};
  ExtendSpec extend;
  extend.span = pair.span;
  extend.group = reader.name(pair);
  if (!reader.is_mapping(&pair.value, pair.key.value, "a mapping", "", "for example `{providers: [{name: quickly}]}`"))
    return extend;
  const std::string thing = fmt::format("extend of `{}`", pair.key.value);
  reader.know_keys(pair.value, thing, keys);
  extend.before = reader.word(pair.value.find("before"), "before", "the name of a provider");
  extend.providers = read_providers(
      reader, reader.require(pair.value, "providers", thing, pair.key.span, "providers: [{name: quickly}]"));
  extend.doc = reader.text(pair.value.find("doc"), "doc");
  return extend;
}

} // namespace director::dsl
