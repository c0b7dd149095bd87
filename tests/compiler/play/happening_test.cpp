// SPDX-License-Identifier: MIT
#include "compiler/play/happening.hpp"

#include <catch2/catch.hpp>

using director::compiler::Happening;
using director::compiler::to_json;
using director::compiler::to_text;
using Kind = director::compiler::Happening::Kind;

namespace {

Happening happening(Kind kind, std::uint32_t step = 1) {
  Happening out;
  out.kind = kind;
  out.step = step;
  return out;
}

Happening about(Kind kind, const std::string& group, const std::string& provider = {}) {
  Happening out = happening(kind);
  out.group = group;
  out.provider = provider;
  return out;
}

} // namespace

TEST_CASE("an input is shown behind an angle bracket") {
  Happening input = happening(Kind::input, 3);
  input.words = "set {Pose: standing, Charge: 3}";
  CHECK(to_text(input) == "> set {Pose: standing, Charge: 3}");
  CHECK(to_json(input) == R"({"step":3,"event":"input","input":"set {Pose: standing, Charge: 3}"})");
}

TEST_CASE("a run names its provider, unless that is called default, and its reasons") {
  Happening run = about(Kind::run, "Kick", "default");
  run.reasons = {"new_task", "trigger"};
  CHECK(to_text(run) == "run Kick new_task+trigger");
  CHECK(to_json(run) ==
        R"({"step":1,"event":"run","group":"Kick","provider":"default","reasons":["new_task","trigger"]})");
  run.group = "Walk";
  run.provider = "halting";
  CHECK(to_text(run) == "run Walk.halting new_task+trigger");
}

TEST_CASE("handlers and results name their group") {
  CHECK(to_text(about(Kind::start, "Walk")) == "start Walk");
  CHECK(to_json(about(Kind::start, "Walk")) == R"({"step":1,"event":"start","group":"Walk"})");
  CHECK(to_text(about(Kind::stop, "Walk")) == "stop Walk");
  CHECK(to_text(about(Kind::done, "Walk")) == "done Walk");
  CHECK(to_text(about(Kind::failed, "Walk")) == "failed Walk");
  CHECK(to_json(about(Kind::failed, "Walk")) == R"({"step":1,"event":"failed","group":"Walk"})");
}

TEST_CASE("a broken promise names its provider, unless that is called default") {
  CHECK(to_text(about(Kind::broken, "Walk", "halting")) == "broken Walk.halting");
  CHECK(to_text(about(Kind::broken, "Walk", "default")) == "broken Walk");
  CHECK(to_json(about(Kind::broken, "Walk", "default")) ==
        R"({"step":1,"event":"broken","group":"Walk","provider":"default"})");
}

TEST_CASE("an exhausted budget has a line of its own") {
  CHECK(to_text(happening(Kind::budget_exhausted)) == "budget_exhausted");
  CHECK(to_json(happening(Kind::budget_exhausted)) == R"({"step":1,"event":"budget_exhausted"})");
}

TEST_CASE("decisions") {
  Happening queue = about(Kind::queue, "Kick");
  queue.from = "root";
  queue.words = "waiting for Pose == standing";
  CHECK(to_text(queue) == "queue root>Kick: waiting for Pose == standing");
  CHECK(to_json(queue) ==
        R"({"step":1,"event":"queue","from":"root","group":"Kick","why":"waiting for Pose == standing"})");
  Happening push = about(Kind::push, "Walk", "default");
  push.from = "root";
  push.words = "Kick";
  CHECK(to_text(push) == "push Walk.default for root>Kick");
  CHECK(to_json(push) == R"({"step":1,"event":"push","group":"Walk","provider":"default","for":"root>Kick"})");
  CHECK(to_text(about(Kind::release, "Walk")) == "release Walk");
  CHECK(to_json(about(Kind::release, "Walk")) == R"({"step":1,"event":"release","group":"Walk"})");
}

TEST_CASE("a state is set to a word, to a number, or to nothing") {
  Happening set = happening(Kind::set);
  set.state = "Pose";
  set.value = "standing";
  CHECK(to_text(set) == "set Pose standing");
  CHECK(to_json(set) == R"({"step":1,"event":"set","state":"Pose","value":"standing"})");
  set.value = "-3";
  set.is_number = true;
  CHECK(to_json(set) == R"({"step":1,"event":"set","state":"Pose","value":-3})");
  set.value.reset();
  CHECK(to_text(set) == "unset Pose");
  CHECK(to_json(set) == R"({"step":1,"event":"set","state":"Pose","value":null})");
}
