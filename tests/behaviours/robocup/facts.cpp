// Header: tests/behaviours/robocup/facts.hpp. Test: tests/behaviours/robocup/robocup_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/facts.hpp"

#include "dsl/source/render.hpp"
#include "dsl/source/source_file.hpp"
#include "tests/behaviours/robocup/notation.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace director::tests {

namespace {

using dsl::YamlNode;

YamlNode read_yaml_file(const std::string& path) {
  dsl::Sources sources;
  const dsl::FileId file = sources.add(path, read_file(source_dir() / path));
  std::vector<dsl::Diagnostic> diagnostics;
  YamlNode root = dsl::read_yaml(file, sources[file].text(), diagnostics);
  INFO(dsl::render(diagnostics, sources));
  REQUIRE(diagnostics.empty());
  return root;
}

class Reader {
public:
  TeamFacts facts;

  void add_groups(const YamlNode& groups) {
    for (const dsl::YamlPair& group : groups.pairs)
      for (const YamlNode& entry : group.value.items) add_entry(group.key.value, entry);
  }

  // One line for a whole module; no facts where the module has a full form already.
  void add_short_forms(const YamlNode& groups) {
    for (const dsl::YamlPair& group : groups.pairs)
      for (const YamlNode& entry : group.value.items) {
        if (modules_.contains(word(entry, "module"))) continue;
        Group& told = group_of(word(entry, "module"), group.key.value);
        told.providers.push_back(provider_of(entry));
        if (word(entry, "start") == "yes") told.start.emplace();
        if (word(entry, "stop") == "yes") told.stop.emplace();
      }
  }

  // Three templates: every servo, every section of the body with its servos, every sequence with the section that it
  // plays.
  void add_servos(const YamlNode& facts_of_servos) {
    const std::string module = word(facts_of_servos, "servo_module");
    const YamlNode& templates = at(facts_of_servos, "servo_templates");
    for (const dsl::YamlPair& one : templates.pairs) facts.places.push_back({file_name(module), word(one.value, "at")});
    for (const std::string& servo : words(facts_of_servos, "servos"))
      group_of(module, servo).providers.push_back(provider_of(at(templates, "servos")));
    for (const dsl::YamlPair& section : at(facts_of_servos, "servo_groups").pairs) {
      Provider provider;
      provider.needs = words(section.value);
      provider.uses = provider.needs; // "every included servo done": the servos that it must read for it
      provider.flat = true;           // "each listed servo that the task includes"
      provider.packs.emplace_back();
      for (const std::string& servo : provider.needs) provider.packs.back().push_back({servo, {0}, false});
      group_of(module, section.key.value).providers.push_back(provider);
    }
    for (const dsl::YamlPair& sequence : at(facts_of_servos, "sequences").pairs) {
      Provider provider;
      provider.needs = {sequence.value.text};
      for (const YamlNode& branch : at(at(templates, "sequences"), "packs").items)
        if (word(branch, "tasks") == "the group it plays, priority 0")
          provider.packs.push_back({{sequence.value.text, {0}, false}});
      group_of(module, sequence.key.value).providers.push_back(provider);
    }
  }

  // `configured`: the value of `cfg`. If a module's roots were read before, these are ignored.
  void add_roots(const YamlNode& roots, int configured) {
    std::set<std::string> known;
    for (const auto& [module, asks] : roots_) known.insert(module);
    for (const dsl::YamlPair& module : roots.pairs) {
      if (known.contains(module.key.value)) continue;
      for (const YamlNode& reaction : module.value.items) {
        for (const std::string& text : words(reaction, "emits_state")) {
          const std::size_t sign = text.find('=');
          outside_.push_back(
              {module.key.value, text.substr(0, sign), text.substr(sign + 1), word(reaction, "trigger") == "Startup"});
        }
        if (const YamlNode* tasks = reaction.find("tasks"))
          for (const YamlNode& task : tasks->items) {
            const std::string& priority = task.items.at(1).text;
            add_root(roots_[module.key.value], task.items.at(0).text,
                     priority == "cfg" ? configured : std::stoi(priority));
          }
      }
    }
  }

  void add_roles(const YamlNode& roles) {
    for (const dsl::YamlPair& entry : roles.pairs) {
      Role role{entry.key.value, {}, {}};
      std::string folder = "modules/";
      for (const char letter : role.name)
        if (letter == '/') folder.insert(0, "../");
      roles_.push_back(words(entry.value));
      for (const std::string& module : roles_.back()) {
        role.imports.push_back(folder + file_name(module) + ".yaml");
        for (const Ask& root : roots_[module])
          for (const std::int32_t priority : root.priorities) add_root(role.roots, root.group, priority);
      }
      facts.graph.roles.push_back(role);
    }
    std::sort(facts.graph.roles.begin(), facts.graph.roles.end(),
              [](const Role& a, const Role& b) { return a.name < b.name; });
  }

  // After the roles. A module's emission outside of its providers is an initial value if every role begins with it;
  // otherwise it comes from outside.
  void add_states(const YamlNode& states) {
    for (const dsl::YamlPair& entry : states.pairs) {
      State state{entry.key.value, word(entry.value, "cpp"), words(entry.value, "values"), {}, {}, false};
      if (word(entry.value, "ordered") == "false") state.unordered = state.values;
      std::vector<Emission> emissions;
      std::copy_if(outside_.begin(), outside_.end(), std::back_inserter(emissions),
                   [&](const Emission& emission) { return emission.state == state.name; });
      const bool initial = !emissions.empty() && every_role_begins_with(emissions);
      if (initial) state.initial = emissions.front().value;
      state.external = word(entry.value, "source").starts_with("external") || (!emissions.empty() && !initial);
      facts.graph.states.push_back(state);
    }
  }

  // At the end: one module for each that provides a group or requests a root task.
  void finish() {
    for (const std::vector<std::string>& role : roles_)
      for (const std::string& module : role) modules_[module];
    for (const auto& [module, asks] : roots_) modules_[module];
    std::set<std::string> triggers;
    for (auto& [name, groups] : modules_) {
      std::set<std::string> asked, own;
      for (const Ask& root : roots_[name]) asked.insert(root.group);
      for (const Group& group : groups) {
        own.insert(group.name);
        for (const Provider& provider : group.providers) {
          asked.insert(provider.needs.begin(), provider.needs.end());
          asked.insert(provider.uses.begin(), provider.uses.end());
          triggers.insert(provider.triggers.begin(), provider.triggers.end());
          for (const std::vector<Ask>& pack : provider.packs)
            for (const Ask& ask : pack) asked.insert(ask.group);
        }
      }
      Module module{file_name(name), {}, groups};
      std::set_difference(asked.begin(), asked.end(), own.begin(), own.end(), std::back_inserter(module.externs));
      facts.graph.modules.push_back(module);
    }
    facts.graph.triggers = {triggers.begin(), triggers.end()};
    std::sort(facts.graph.modules.begin(), facts.graph.modules.end(),
              [](const Module& a, const Module& b) { return a.name < b.name; });
  }

private:
  std::map<std::string, std::vector<Group>> modules_;
  std::map<std::string, std::vector<Ask>> roots_; // of each module
  struct Emission {
    std::string module, state, value;
    bool at_start;
  };
  std::vector<Emission> outside_; // what a module emits outside of its providers
  std::vector<std::vector<std::string>> roles_;

  bool every_role_begins_with(const std::vector<Emission>& emissions) const {
    const auto begins = [&](const std::vector<std::string>& role) {
      return role.empty() || std::any_of(emissions.begin(), emissions.end(), [&](const Emission& emission) {
               return std::find(role.begin(), role.end(), emission.module) != role.end();
             });
    };
    return std::all_of(emissions.begin(), emissions.end(),
                       [](const Emission& emission) { return emission.at_start; }) &&
           std::all_of(roles_.begin(), roles_.end(), begins);
  }

  Group& group_of(const std::string& module, const std::string& name) {
    std::vector<Group>& groups = modules_[module];
    const auto found =
        std::find_if(groups.begin(), groups.end(), [&](const Group& group) { return group.name == name; });
    if (found != groups.end()) return *found;
    return groups.emplace_back(Group{name, layer_of(module), file_name(module), {}, {}, {}});
  }

  void add_entry(const std::string& name, const YamlNode& entry) {
    const std::string module = word(entry, "module"), kind = word(entry, "kind");
    facts.places.push_back({file_name(module), word(entry, "at")});
    Group& group = group_of(module, name);
    if (kind == "start")
      group.start = emitted(entry);
    else if (kind == "stop")
      group.stop = emitted(entry);
    else
      group.providers.push_back(provider_of(entry));
  }

  // One root task for each group, one level for each priority.
  static void add_root(std::vector<Ask>& roots, const std::string& group, std::int32_t priority) {
    const auto found = std::find_if(roots.begin(), roots.end(), [&](const Ask& root) { return root.group == group; });
    if (found == roots.end())
      roots.push_back({group, {priority}, false});
    else if (std::find(found->priorities.begin(), found->priorities.end(), priority) == found->priorities.end())
      found->priorities.push_back(priority);
  }
};

// The published priorities of purpose::Tester, which are all the same.
int configured_priority(const YamlNode& config) {
  std::set<std::string> values;
  for (const dsl::YamlPair& entry : at(config, "purpose::Tester").pairs) values.insert(entry.value.text);
  REQUIRE(values.size() == 1);
  return std::stoi(*values.begin());
}

} // namespace

TeamFacts read_facts(Source source) {
  const YamlNode first = read_yaml_file("tests/behaviours/robocup/facts/robocup.yaml");
  const YamlNode second = read_yaml_file("tests/behaviours/robocup/facts/roles.yaml");
  Reader reader;
  if (source == Source::k1) {
    const int configured = configured_priority(at(second, "config"));
    reader.add_groups(at(first, "groups"));
    reader.add_groups(at(second, "more_groups"));
    reader.add_short_forms(at(first, "alternative_providers"));
    reader.add_servos(at(second, "more_servo_groups"));
    reader.add_roots(at(second, "more_roots"), configured);
    reader.add_roots(at(first, "roots"), configured);
    reader.add_roles(at(second, "roles"));
    reader.add_states(at(first, "states"));
  } else {
    const YamlNode& older = at(second, "older");
    reader.add_groups(at(older, "groups"));
    reader.add_servos(older);
    reader.add_roots(at(older, "roots"), 0);
    reader.add_roles(at(older, "roles"));
    reader.add_states(at(older, "states"));
  }
  reader.finish();
  return reader.facts;
}

} // namespace director::tests
