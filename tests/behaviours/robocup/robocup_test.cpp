// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/declared.hpp"
#include "tests/behaviours/robocup/facts.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace director::tests;

namespace {

std::filesystem::path folder(Source source) {
  const std::filesystem::path robocup = source_dir() / "behaviours/robocup";
  return source == Source::k1 ? robocup : robocup / "older";
}

template <class T>
std::vector<std::string> names(const std::vector<T>& things) {
  std::vector<std::string> names;
  for (const T& thing : things) names.push_back(thing.name);
  return names;
}

// The same things with the same lines, in the same order.
template <class T>
void compare(const std::vector<T>& facts, const std::vector<T>& told) {
  CHECK(difference(names(facts), names(told)).empty());
  for (const T& fact : facts)
    for (const T& thing : told)
      if (thing.name == fact.name) {
        const std::string found = difference(lines(fact), lines(thing));
        INFO("facts (-) and behaviours/robocup (+):" << found);
        CHECK(found.empty());
      }
}

std::set<std::string> group_names(const TeamGraph& graph) {
  std::set<std::string> names;
  for (const Module& module : graph.modules)
    for (const Group& group : module.groups) names.insert(group.name);
  return names;
}

} // namespace

TEST_CASE("the groups, providers, packs, needs and priorities of every module are those of the facts, and no more") {
  const Source source = GENERATE(Source::k1, Source::older);
  compare(read_facts(source).graph.modules, read_declared(folder(source)).modules);
}

TEST_CASE("the modules and root tasks of every role are those of the facts, and no others") {
  const Source source = GENERATE(Source::k1, Source::older);
  compare(read_facts(source).graph.roles, read_declared(folder(source)).roles);
}

TEST_CASE("states and triggers are those of the facts") {
  const Source source = GENERATE(Source::k1, Source::older);
  const TeamGraph facts = read_facts(source).graph, told = read_declared(folder(source));
  compare(facts.states, told.states);
  CHECK(facts.triggers == told.triggers);
}

TEST_CASE("every provider's place in the team's source is in the file of its module") {
  const Source source = GENERATE(Source::k1, Source::older);
  for (const TeamFacts::Place& place : read_facts(source).places) {
    const std::string text = read_file(folder(source) / "modules" / (place.module + ".yaml"));
    INFO(place.module << " does not name " << place.at);
    CHECK(text.find(place.at) != std::string::npos);
  }
}

TEST_CASE("the whole of both graphs is there") {
  const TeamGraph k1 = read_declared(folder(Source::k1)), older = read_declared(folder(Source::older));
  CHECK(group_names(k1).size() == 81); // 78, Say and the two of skill::GPT
  CHECK(k1.roles.size() == 22);
  CHECK(group_names(older).size() == 65);
  CHECK(older.roles.size() == 3);
}

TEST_CASE("no finding about the team's graph is suppressed by an allow") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder(Source::k1)))
    if (entry.path().extension() == ".yaml") {
      INFO(entry.path());
      CHECK(read_file(entry.path()).find("allow") == std::string::npos);
    }
}
