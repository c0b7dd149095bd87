// Header: tests/behaviours/robocup/notation.hpp. Test: tests/behaviours/robocup/robocup_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/notation.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace director::tests {

using dsl::YamlNode;

namespace {

using Words = std::vector<std::string>;

void append(Words& to, const Words& more) { to.insert(to.end(), more.begin(), more.end()); }

Words split(std::string_view text, std::string_view separator) {
  Words parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  return parts;
}

// The texts between an opening and the next closing sign.
Words between(std::string_view text, char open, char close) {
  Words found;
  for (std::size_t begin = text.find(open); begin != std::string_view::npos; begin = text.find(open, begin + 1))
    found.emplace_back(text.substr(begin + 1, text.find(close, begin) - begin - 1));
  return found;
}

// A trigger cannot have the name of a state.
Words trigger_names(Words names) {
  std::replace(names.begin(), names.end(), std::string("Stability"), std::string("StabilityMessage"));
  return names;
}

// "Phase = READY" -> "Phase == READY"
Words conditions(const Words& texts) {
  Words conditions;
  for (const std::string& text : texts) {
    const Words sides = split(text, " = ");
    REQUIRE(sides.size() == 2);
    conditions.push_back(sides[0] + " == " + sides[1]);
  }
  return conditions;
}

// "90 Hz", rounded to whole microseconds.
std::int64_t microseconds_of(const std::string& rate) {
  REQUIRE(rate.ends_with(" Hz"));
  return std::llround(1e6 / std::stod(rate));
}

// [Walk, 0] or [LeftArm, 0, true]
Ask ask_of(const YamlNode& task) {
  return {
      task.items.at(0).text, {std::stoi(task.items.at(1).text)}, task.items.size() > 2 && task.items[2].text == "true"};
}

// Done, Continue, Wait and Idle are answers. A branch of answers alone is no pack, one of nothing is an empty pack.
std::vector<std::vector<Ask>> packs_of(const YamlNode& entry) {
  std::vector<std::vector<Ask>> packs;
  for (const YamlNode& branch : at(entry, "packs").items) {
    std::vector<Ask> pack;
    const std::vector<YamlNode>& tasks = at(branch, "tasks").items;
    for (const YamlNode& task : tasks)
      if (task.kind == YamlNode::Kind::list) pack.push_back(ask_of(task));
    if (tasks.empty() || !pack.empty()) packs.push_back(pack);
  }
  return packs;
}

// The short form: "NEW_TASK->[LimbsSequence 0]; SUBTASK_DONE->Done", "[LeftLegIK 0, LeftArm 0 optional] or Done".
std::vector<std::vector<Ask>> packs_of(const std::string& text) {
  std::vector<std::vector<Ask>> packs;
  for (const std::string& list : between(text, '[', ']')) {
    packs.emplace_back();
    for (const std::string& task : split(list, ", ")) {
      const Words parts = split(task, " ");
      packs.back().push_back({parts.at(0), {std::stoi(parts.at(1))}, parts.size() > 2 && parts[2] == "optional"});
    }
  }
  return packs;
}

// A provider of a template whose parameter the note lists: "template BodySection in {A, B} chosen by config". The entry
// of the first applies to each.
void expand_template(Provider& provider, const std::string& note) {
  const Words sections = split(between(note, '{', '}').at(0), ", ");
  provider.uses = sections;
  std::vector<std::vector<Ask>> packs;
  for (const std::vector<Ask>& pack : provider.packs) {
    if (pack.size() != 1 || pack[0].group != sections[0])
      packs.push_back(pack);
    else
      for (const std::string& section : sections) packs.push_back({{section, pack[0].priorities, false}});
  }
  provider.packs = packs;
}

} // namespace

const YamlNode& at(const YamlNode& mapping, std::string_view key) {
  const YamlNode* node = mapping.find(key);
  INFO("no key " << key);
  REQUIRE(node != nullptr);
  return *node;
}

std::string word(const YamlNode& mapping, std::string_view key) {
  const YamlNode* node = mapping.find(key);
  return node == nullptr ? std::string{} : node->text;
}

std::vector<std::string> words(const YamlNode& list) {
  Words words;
  for (const YamlNode& item : list.items) words.push_back(item.text);
  return words;
}

std::vector<std::string> words(const YamlNode& mapping, std::string_view key) {
  const YamlNode* node = mapping.find(key);
  return node == nullptr ? Words{} : words(*node);
}

// skill::K1VisualKick -> skill_k1_visual_kick: a word begins with a capital after a small letter or a digit, and with
// the last capital of several.
std::string file_name(std::string_view module) {
  const auto upper = [&](std::size_t i) { return std::isupper(static_cast<unsigned char>(module[i])) != 0; };
  const auto lower = [&](std::size_t i) { return std::islower(static_cast<unsigned char>(module[i])) != 0; };
  std::string name;
  for (std::size_t i = 0; i < module.size(); ++i) {
    if (module[i] == ':') {
      if (name.back() != '_') name += '_';
      continue;
    }
    const bool follows = i > 0 && module[i - 1] != ':';
    const bool last_capital = i + 1 < module.size() && follows && upper(i - 1) && lower(i + 1);
    if (upper(i) && follows && (!upper(i - 1) || last_capital)) name += '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(module[i])));
  }
  return name;
}

std::string layer_of(const std::string& module) { return module.substr(0, module.find("::")); }

// emits_state of a provider or handler and of its branches: "Stability=STANDING", or "WalkState=*" for any value.
std::vector<std::string> emitted(const YamlNode& entry) {
  Words texts = words(entry, "emits_state");
  if (const YamlNode* packs = entry.find("packs"))
    for (const YamlNode& pack : packs->items) append(texts, words(pack, "emits_state"));
  std::set<std::string> emitted;
  for (const std::string& text : texts) {
    const Words sides = split(text, "=");
    REQUIRE(sides.size() == 2);
    emitted.insert(sides[1] == "*" ? sides[0] : sides[0] + " == " + sides[1]);
  }
  return {emitted.begin(), emitted.end()};
}

Provider provider_of(const YamlNode& entry) {
  Provider provider;
  provider.when = conditions(words(entry, "when"));
  provider.causing = conditions(words(entry, "causing"));
  provider.needs = words(entry, "needs");
  provider.uses = words(entry, "uses");
  provider.triggers = words(entry, "trigger");
  append(provider.triggers, words(entry, "optional_trigger"));
  provider.triggers = trigger_names(provider.triggers);
  if (entry.find("dur") != nullptr) provider.every_us = microseconds_of(word(entry, "dur"));
  for (const std::string& set : emitted(entry)) // it may set what it promises anyway
    if (std::find(provider.causing.begin(), provider.causing.end(), set) == provider.causing.end())
      provider.sets.push_back(set);
  const YamlNode& packs = at(entry, "packs");
  provider.packs = packs.kind == YamlNode::Kind::list ? packs_of(entry) : packs_of(packs.text);
  if (provider.uses == Words{"BodySection"}) expand_template(provider, word(entry, "note"));
  return provider;
}

} // namespace director::tests
