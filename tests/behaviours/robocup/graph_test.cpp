// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/graph.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace director::tests;

TEST_CASE("equal lists have no difference") { CHECK(difference({"a", "b"}, {"a", "b"}).empty()); }

TEST_CASE("a difference shows what is missing and what is extra, among the lines that are the same") {
  CHECK(difference({"a", "b", "c"}, {"a", "c", "d"}) == "\n  a\n- b\n  c\n+ d\n");
  CHECK(difference({}, {"a"}) == "\n+ a\n");
  CHECK(difference({"a", "b"}, {"b", "a"}) == "\n- a\n  b\n+ a\n");
}

TEST_CASE("the lines of a module contain everything that is compared") {
  Provider provider;
  provider.when = {"Phase == PLAYING"};
  provider.needs = {"Legs"};
  provider.causing = {"Pose == up"};
  provider.sets = {"Pose"};
  provider.uses = {"Legs"};
  provider.triggers = {"Ball"};
  provider.every_us = 11111;
  provider.packs = {{{"Legs", {2}, false}, {"Arms", {0}, true}}, {}};
  const Module module{
      "skill_walk", {"Arms"}, {{"Walk", "skill", "skill_walk", std::vector<std::string>{}, {}, {provider}}}};
  CHECK(lines(module) == std::vector<std::string>{"module skill_walk", "extern Arms", "group Walk of skill_walk, skill",
                                                  "  start, sets ", "  provider", "    when Phase == PLAYING",
                                                  "    needs Legs", "    every 11111 us", "    triggers Ball",
                                                  "    causing Pose == up", "    sets Pose", "    uses Legs",
                                                  "    pack Legs 2, Arms 0 optional", "    pack "});
}
