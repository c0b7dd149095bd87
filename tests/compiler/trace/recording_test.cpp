// SPDX-License-Identifier: MIT
// Tests compiler/trace/recording.cpp: a decoder that depends only on the format in recording.hpp reads the bytes. The
// page's own decoder: tests/browser.
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/recorded_names.hpp"
#include "compiler/trace/recording.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

using namespace director::compiler;

namespace {

const std::string header_line =
    R"({"director_trace":1,"behaviour":"b","fingerprint":"0000000000000000","groups":[{"name":"A","providers":["x","y"]},{"name":"B","providers":["default"]}],)"
    R"("edges":[{"name":"root>A","target":"A","levels":[""]},{"name":"A>B","target":"B","levels":[""]}],"states":[{"name":"S","values":["on","off"]}],)"
    R"("triggers":[],"conditions":["S == on"]})";

/// One event or change of what a page has.
struct Decoded {
  Json head;
  std::vector<std::pair<std::int64_t, std::string>> events;
  std::vector<std::vector<std::uint64_t>> changes; ///< event, group, answer
};

Decoded decode(const std::string& bytes) {
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes.at(at)); };
  const std::size_t length = byte(0) + byte(1) * 256U + byte(2) * 65536U + byte(3) * 16777216U;
  Decoded out;
  out.head = parse_json(bytes.substr(4, length)).value();
  std::size_t at = 4 + length;
  const auto next = [&] {
    std::uint64_t number = 0;
    for (int bits = 0;; bits += 7, ++at) {
      number |= static_cast<std::uint64_t>(byte(at) & 127) << bits;
      if (byte(at) < 128) break;
    }
    ++at;
    return number;
  };
  const auto column = [&](const char* key) {
    std::vector<std::uint64_t> numbers(static_cast<std::size_t>(out.head[key].as_number()));
    for (std::uint64_t& each : numbers) each = next();
    return numbers;
  };
  const auto times = column("events"), shapes = column("events");
  std::int64_t time = out.head["begins"].as_number();
  for (std::size_t i = 0; i < times.size(); ++i) {
    time += static_cast<std::int64_t>(times[i]);
    out.events.emplace_back(time, to_line(out.head["shapes"].items().at(shapes[i])));
  }
  const auto events = column("changes"), groups = column("changes"), answers = column("changes");
  std::uint64_t event = 0;
  for (std::size_t i = 0; i < events.size(); ++i) out.changes.push_back({event += events[i], groups[i], answers[i]});
  CHECK(at == bytes.size());
  return out;
}

Decoded recorded(const std::vector<std::string>& lines, Waits waits = {}, std::string why_ends = {}) {
  std::string problem;
  const Json header = parse_json(header_line).value();
  std::optional<RecordedNames> names = RecordedNames::read(header, problem);
  REQUIRE(names);
  const director::Names rows = names->names();
  const Lookup lookup(rows);
  Recording recording(rows, std::move(waits), std::move(why_ends));
  std::string unused;
  for (const std::string& line : lines) {
    const Json json = parse_json(line).value();
    if (json["event"].as_text() == "dropped") {
      recording.dropped(static_cast<std::uint64_t>(json["count"].as_number()), unused);
      continue;
    }
    const Lookup::Found found = lookup.event(json);
    REQUIRE(found.problem.empty());
    recording.event(found.event, unused);
  }
  const Decoded out = decode(recording.bytes(header));
  CHECK(out.head["header"] == header);
  return out;
}

using Events = std::vector<std::pair<std::int64_t, std::string>>;

TEST_CASE("events come back without their times, each shape once, in order and never earlier than the one before") {
  const Decoded out = recorded(
      {R"({"t":-5,"n":0,"event":"begin"})", R"({"t":-5,"n":1,"event":"input","input":"request","edge":"root>A"})",
       R"({"t":300000000,"until":300000100,"n":2,"event":"run","group":"A","provider":"x","reasons":["new_task"]})",
       R"({"t":200000000,"n":3,"event":"set","state":"S","value":"off"})",
       R"({"t":300000200,"n":4,"event":"run","group":"A","provider":"x","reasons":["new_task"]})"});
  const std::string run = R"({"event":"run","group":"A","provider":"x","reasons":["new_task"]})";
  CHECK(out.events == Events{{-5, R"({"event":"begin"})"},
                             {-5, R"({"event":"input","input":"request","edge":"root>A"})"},
                             {300000000, run},
                             {300000000, R"({"begins":true,"event":"set","state":"S","value":"off"})"},
                             {300000200, run}});
  CHECK(out.head["shapes"].items().size() == 4);
  CHECK(out.head["why_until"].as_number() == 0);
  CHECK(out.head["why_ends"].is_null());
}

TEST_CASE("what bodies answer and which timer was due is left out; what is missing is reported at its place") {
  const Decoded out =
      recorded({R"({"t":1,"n":1,"event":"input","input":"wait","group":"A"})",
                R"({"t":1,"n":1,"event":"answer","group":"A","provider":"x","answer":"pack"})",
                R"({"t":1,"n":1,"event":"ask","edge":"A>B"})", R"({"t":1,"n":1,"event":"wait","group":"A","due":7})",
                R"({"t":1,"n":1,"event":"assign","group":"A","provider":"x","state":"S","value":"on"})",
                R"({"event":"dropped","count":12})", R"({"t":9,"n":4,"event":"lose","group":"B","from":"A>B"})"});
  CHECK(out.events == Events{{1, R"({"event":"ask","edge":"A>B"})"},
                             {1, R"({"event":"dropped","count":12})"},
                             {9, R"({"event":"lose","group":"B","from":"A>B"})"}});
}

TEST_CASE("where a micro-step begins is in the shape, unless a run or an input begins it and nothing else") {
  const Decoded out = recorded(
      {R"({"t":1,"n":1,"event":"input","input":"request","edge":"root>A"})",
       R"({"t":1,"n":1,"event":"input","input":"set","state":"S","value":"on"})",
       R"({"t":1,"n":1,"event":"grant","edge":"root>A","provider":"x"})", R"({"t":1,"n":2,"event":"done","group":"A"})",
       R"({"t":1,"n":3,"event":"input","input":"expire","state":"S"})",
       R"({"t":1,"n":3,"event":"set","state":"S","value":null})", R"({"event":"dropped","count":12})",
       R"({"t":9,"n":7,"event":"lose","group":"B","from":"A>B"})", R"({"t":9,"n":7,"event":"done","group":"A"})"});
  CHECK(out.events == Events{{1, R"({"event":"input","input":"request","edge":"root>A"})"},
                             {1, R"({"begins":false,"event":"input","input":"set","state":"S","value":"on"})"},
                             {1, R"({"event":"grant","edge":"root>A","provider":"x"})"},
                             {1, R"({"begins":true,"event":"done","group":"A"})"},
                             {1, R"({"begins":true,"event":"set","state":"S","value":null})"},
                             {1, R"({"event":"dropped","count":12})"},
                             {9, R"({"event":"lose","group":"B","from":"A>B"})"},
                             {9, R"({"event":"done","group":"A"})"}});
}

TEST_CASE("answers hold from the event in their line on, or from the one before it, as far as they are known") {
  Waits waits;
  waits.texts = {"B waits", "B waits otherwise"};
  waits.blockers = {{}, {1, 1}};
  waits.changes = {{2, 1, 1}, {4, 1, 2}, {5, 1, 0}};
  waits.held = {{4, 0}};
  waits.stays = {{4, 1}};
  waits.without_effect = {{6, 0}};
  waits.in_force = {{7, 0}};
  waits.last_line = 5;
  const Decoded out =
      recorded({R"({"t":1,"n":1,"event":"done","group":"A"})", R"({"t":2,"n":2,"event":"done","group":"B"})",
                R"({"t":3,"n":3,"event":"done","group":"A"})",
                R"({"t":3,"n":3,"event":"answer","group":"A","provider":"x","answer":"done"})",
                R"({"t":4,"n":4,"event":"done","group":"B"})", R"({"t":5,"n":5,"event":"done","group":"B"})"},
               waits, "something is missing");
  CHECK(out.events.size() == 9);
  CHECK(out.events[3] == std::pair<std::int64_t, std::string>{3, R"({"event":"held","group":"A"})"});
  CHECK(out.events[4] == std::pair<std::int64_t, std::string>{3, R"({"event":"stays","group":"B"})"});
  CHECK(out.events[6] == std::pair<std::int64_t, std::string>{4, R"({"event":"without_effect","group":"A"})"});
  CHECK(out.events[8] == std::pair<std::int64_t, std::string>{5, R"({"event":"in_force","group":"A"})"});
  CHECK(out.head["texts"].as_texts() == waits.texts);
  CHECK(to_line(out.head["held"]) == R"([null,{"group":"B","by":"A>B"}])");
  CHECK(out.changes == std::vector<std::vector<std::uint64_t>>{{0, 1, 1}, {4, 1, 2}, {4, 1, 0}});
  CHECK(out.head["why_until"].as_number() == 5);
  CHECK(out.head["why_ends"].as_text() == "something is missing");
}

TEST_CASE("a trace without an event") {
  const Decoded out = recorded({});
  CHECK(out.events.empty());
  CHECK(out.head["begins"].as_number() == 0);
}

} // namespace
