// SPDX-License-Identifier: MIT
// Tests runtime/hosted/trace/json_lines.hpp. Reading and replaying traces: tests/compiler/trace.
#include "runtime/hosted/trace/fingerprint.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "tests/runtime/hosted/trace/lamp.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::tests;

namespace {

std::string line(const Event& event, const Names& names) {
  std::string out;
  append_event(event, names, out);
  return out;
}

} // namespace

TEST_CASE("the header of a trace has the names of all rows, and who requests which level") {
  const Lamp lamp;
  std::string out;
  append_header(lamp.names, "a \"lamp\"\n.yaml", out);
  CHECK(out == R"({"director_trace":1,"behaviour":"lamp","file":"a \"lamp\"\u000a.yaml","fingerprint":")" +
                   fingerprint_text(lamp.names) +
                   R"(","groups":[{"name":"Shine","providers":["default"]},{"name":"Signal","providers":["default"]},)"
                   R"({"name":"Bulb","providers":["bright","dim"]}],)"
                   R"("edges":[{"name":"root>Shine","target":"Shine","levels":[""]},)"
                   R"({"name":"root>Signal","target":"Signal","levels":[""]},)"
                   R"({"name":"Shine>Bulb","target":"Bulb","levels":[""]},)"
                   R"({"name":"Signal>Bulb","target":"Bulb","levels":[""]}],)"
                   R"("states":[{"name":"Motion","values":["still","moving"],"initial":"still"},{"name":"Charge"}],)"
                   R"("triggers":["Alarm"],"conditions":["Motion == still"],"level_uses":[)"
                   R"({"edge":"root>Shine","level":0,"priority":1},{"edge":"root>Signal","level":0,"priority":2},)"
                   R"({"edge":"Shine>Bulb","provider":"default","level":0,"priority":0},)"
                   R"({"edge":"Signal>Bulb","provider":"default","level":0,"priority":0}]})");
}

TEST_CASE("the header of a trace of no file names none") {
  const Lamp lamp;
  std::string out;
  append_header(lamp.names, "", out);
  CHECK(out.starts_with(R"({"director_trace":1,"behaviour":"lamp","fingerprint":")"));
}

TEST_CASE("a level is written by its name, if no level before it has the same one") {
  const Lamp lamp;
  Tables tables = *lamp.names.tables;
  std::vector<Edge> edges(tables.edges.begin(), tables.edges.end());
  edges[3].levels = {3, 6};
  tables.edges = edges;
  Names names = lamp.names;
  names.tables = &tables;
  names.level = [](const void*, Index level) { return level < 4 ? "" : "hot"; };
  Event ask = lamp.event(Event::Kind::ask, 0);
  ask.group = 2;
  ask.edge = 3;
  const std::string begin = R"({"t":0,"n":1,"event":"ask","edge":"Signal>Bulb")";
  ask.level = 3;
  CHECK(line(ask, names) == begin + "}");
  ask.level = 4;
  CHECK(line(ask, names) == begin + R"(,"level":"hot"})");
  ask.level = 5;
  CHECK(line(ask, names) == begin + R"(,"level":2})");
}

TEST_CASE("each event is a line, with names instead of numbers") {
  const Lamp lamp;
  Event request = lamp.event(Event::Kind::input, 1'500'000, 7);
  request.input = Event::Input::request;
  request.group = 1;
  request.edge = request.level = 1;
  CHECK(line(request, lamp.names) == R"({"t":1500000,"n":7,"event":"input","input":"request","edge":"root>Signal"})");
  Event push = lamp.event(Event::Kind::push, 10);
  push.until = 20;
  push.group = 2;
  push.provider = 3;
  push.edge = 1;
  push.condition = 0;
  CHECK(line(push, lamp.names) == R"({"t":10,"until":20,"n":1,"event":"push","group":"Bulb","edge":"root>Signal",)"
                                  R"("provider":"dim","condition":"Motion == still"})");
  Event run = lamp.event(Event::Kind::run, 0);
  run.group = 2;
  run.provider = 3;
  run.reasons = Reasons{3};
  CHECK(line(run, lamp.names) ==
        R"({"t":0,"n":1,"event":"run","group":"Bulb","provider":"dim","reasons":["new_task","pushed"]})");
  Event set = lamp.event(Event::Kind::set, 0);
  set.state = 1;
  set.value = 42;
  CHECK(line(set, lamp.names) == R"({"t":0,"n":1,"event":"set","state":"Charge","value":42})");
  set.value = unset;
  CHECK(line(set, lamp.names) == R"({"t":0,"n":1,"event":"set","state":"Charge","value":null})");
  Event grant = lamp.event(Event::Kind::grant, 0);
  grant.group = 2;
  grant.edge = 3;
  grant.other = 4 + 2;
  CHECK(line(grant, lamp.names) == R"({"t":0,"n":1,"event":"grant","edge":"Signal>Bulb","from":"limbo"})");
  Event answer = lamp.event(Event::Kind::answer, 0);
  answer.group = answer.provider = 0;
  answer.outcome = Outcome::Kind::pack;
  answer.pack = 2;
  CHECK(line(answer, lamp.names) ==
        R"({"t":0,"n":1,"event":"answer","group":"Shine","provider":"default","answer":"pack","pack":2})");
  std::string dropped;
  append_dropped(12, dropped);
  CHECK(dropped == R"({"event":"dropped","count":12})");
}

TEST_CASE("behaviours that differ have different fingerprints, and equal ones the same") {
  const Lamp one, same;
  CHECK(fingerprint(one.names) == fingerprint(same.names));
  Lamp other;
  Names renamed = other.names;
  renamed.trigger = [](const void*, Index) { return "Bell"; };
  CHECK(fingerprint(renamed) != fingerprint(one.names));
  Names reordered = other.names; // a value of a state with another number
  reordered.value = [](const void*, Index, std::int32_t number) {
    return number == 0 ? "on" : number == 1 ? "off" : "";
  };
  Names ordered = other.names;
  ordered.value = [](const void*, Index, std::int32_t number) { return number == 0 ? "off" : number == 1 ? "on" : ""; };
  CHECK(fingerprint(reordered) != fingerprint(ordered));
  Tables tables = *other.names.tables;
  std::vector<Level> levels(tables.levels.begin(), tables.levels.end());
  levels.front().optional = true;
  tables.levels = levels;
  Names changed = other.names;
  changed.tables = &tables;
  CHECK(fingerprint(changed) != fingerprint(one.names));
}
