// SPDX-License-Identifier: MIT
#include "compiler/model/closure.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using namespace director;
using namespace director::compiler;

using Closure = void (*)(const Model&, std::vector<GroupId>&);

std::string closure(Closure add, std::initializer_list<const char*> from) {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\nroots: [A]\ngroups:\n"
                                       "  A: {needs: [B], tasks: [C]}\n"
                                       "  B: {providers: [{name: one, needs: [D]}, {name: two, needs: [E]}]}\n"
                                       "  C: {needs: [D]}\n  D: {tasks: [F]}\n  E: {needs: [B]}\n  F: {}\n");
  std::vector<GroupId> groups;
  for (const char* name : from) groups.push_back(compiled.group(name));
  add(compiled.model, groups);
  std::string out;
  for (const GroupId group : groups) out += compiled.model.groups[group].name.value;
  return out;
}

TEST_CASE("what groups may need follows them, each once, the nearest first") {
  CHECK(closure(add_needed, {"A"}) == "ABDE");
  CHECK(closure(add_needed, {"C", "E", "C"}) == "CEDB");
  CHECK(closure(add_needed, {}).empty());
}

TEST_CASE("what a group may need itself is in order of declaration, without the group, also in a cycle") {
  const auto sorted = [](const Model& model, std::vector<GroupId>& groups) {
    groups = needed_by(model, groups.front());
  };
  CHECK(closure(sorted, {"A"}) == "BDE");
  CHECK(closure(sorted, {"E"}) == "BD");
  CHECK(closure(sorted, {"F"}).empty());
}

TEST_CASE("requests lead on as needs do") { CHECK(closure(add_led_to, {"C"}) == "CDF"); }

} // namespace
