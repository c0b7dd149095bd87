// SPDX-License-Identifier: MIT
// Tests compiler/cli/commands/trace.cpp and replay.cpp, and the output of `simulate --trace`. All scenarios:
// tests/conformance.
#include "compiler/trace/trace_lines.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::compiler::TraceLine, director::compiler::TraceLines;
using director::tests::World;

const std::string rover_that_is_recorded = R"(behaviour: rover
language: 1
states:
  Motion: {values: [still, rolling], initial: still}
roots:
  Explore: {priority: 10}
  Photograph: {priority: 20}
groups:
  Explore: {tasks: [Drive]}
  Photograph: {when: [Motion == still], tasks: [Wheels]}
  Drive:
    providers:
      - {name: rolling, sets: [Motion == rolling], tasks: [Wheels]}
      - {name: braking, causing: [Motion == still], tasks: [Wheels]}
  Wheels: {}
)";

/// A world in which `run.jsonl` has been recorded.
World with_trace() {
  World world;
  world.files.add("rover.yaml", rover_that_is_recorded);
  world.files.add("s.yaml", R"(scenario: a picture
behaviour: rover.yaml
script:
  Drive.rolling: {set: {Motion: rolling}, tasks: [Wheels]}
  Drive.braking:
    - {reason: wait, set: {Motion: still}, continue: true}
    - {wait: 1 s, tasks: [Wheels]}
steps:
  - request: Explore
  - request: Photograph
  - advance: 2 s
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", world.outputs.files.at("run.jsonl"));
  return world;
}

std::string trace_in(World& world) { return world.outputs.files.at("run.jsonl"); }

std::string traced_line(const std::string& text, std::size_t number) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST_CASE("a trace as text is what simulate prints, with the inputs as they were taken") {
  World world = with_trace();
  CHECK(world.directorc({"trace", "run.jsonl"}) == 0);
  CHECK(world.out == R"([    0.000000] > request Explore
[    0.000000] run Explore new_task
[    0.000000] run Drive.rolling new_task
[    0.000000] set Motion rolling
[    0.000000] run Wheels new_task
[    0.000000] > request Photograph
[    0.000000] push Drive.braking for root>Photograph
[    0.000000] queue root>Photograph: waiting for Motion == still
[    0.000000] run Drive.braking pushed
[    0.000000] run Wheels new_task
[    1.000000] run Drive.braking wait
[    1.000000] set Motion still
[    1.000000] run Photograph new_task
[    1.000000] queue Drive>Wheels: blocked
[    1.000000] run Wheels new_task
)");
  CHECK(world.err.empty());
}

TEST_CASE("names in a trace command no terminal") {
  World world = with_trace();
  std::string text = trace_in(world);
  for (std::size_t at = 0; (at = text.find("\"Explore\"", at)) != std::string::npos; at += 9)
    text.replace(at, 9, "\"Ex\\u001b[2J\"");
  world.files.add("other.jsonl", text);
  CHECK(world.directorc({"trace", "other.jsonl"}) == 0);
  CHECK(world.out.find("run Ex\\x1B[2J new_task\n") != std::string::npos);
  CHECK(world.out.find('\x1B') == std::string::npos);
  CHECK(world.directorc({"replay", "other.jsonl"}) == 1);
  CHECK(world.out.find('\x1B') == std::string::npos);
  CHECK(world.err.find('\x1B') == std::string::npos);
}

TEST_CASE("a trace as JSON is the trace") {
  World world = with_trace();
  CHECK(world.directorc({"trace", "run.jsonl", "--to=json"}) == 0);
  CHECK(world.out == trace_in(world));
  CHECK(world.directorc({"trace", "run.jsonl", "--to=json", "-o", "again.jsonl"}) == 0);
  CHECK(world.out.empty());
  CHECK(world.outputs.files.at("again.jsonl") == trace_in(world));
}

TEST_CASE("the file's name decides how a trace is written if no format is named") {
  World world = with_trace();
  const auto written = [&](const std::string& file, std::vector<std::string> words = {}) {
    words.insert(words.begin(), {"trace", "run.jsonl", "-o", file});
    REQUIRE(world.directorc(words) == 0);
    return world.outputs.files.at(file);
  };
  const std::string text = written("run.txt");
  CHECK(text == written("other.txt", {"--to=text"}));
  CHECK(written("again.jsonl") == trace_in(world));
  CHECK(written("again.json") == trace_in(world));
  CHECK(written("run.pftrace") == written("run", {"--to=perfetto"}));
  CHECK(written("run.perfetto-trace") == written("run", {"--to=perfetto"}));
  CHECK(written("run.html") == written("page", {"--to=html"}));
  CHECK(written("text.html", {"--to=text"}) == text);
}

TEST_CASE("the file's name decides how a scenario is recorded, and no page is recorded") {
  World world = with_trace();
  REQUIRE(world.directorc({"trace", "run.jsonl", "-o", "of_lines.pftrace"}) == 0);
  for (const std::string file : {"run.pftrace", "run.perfetto-trace"}) {
    CHECK(world.directorc({"simulate", "s.yaml", "--trace", file}) == 0);
    CHECK(world.outputs.files.at(file) == world.outputs.files.at("of_lines.pftrace"));
  }
  CHECK(world.directorc({"simulate", "s.yaml", "--trace", "run.html"}) == 2);
  CHECK(world.err ==
        "directorc: --trace writes no page; record a .jsonl, and `directorc trace FILE.jsonl -o FILE.html` "
        "writes one\n");
}

TEST_CASE("bytes for Perfetto are not printed to a terminal, but how to look at them") {
  World world = with_trace();
  CHECK(world.directorc({"trace", "run.jsonl", "--to=perfetto"}) == 0); // into a pipe
  const std::string bytes = world.out;
  CHECK(world.directorc({"trace", "run.jsonl", "--to=perfetto", "-o", "run.perfetto-trace"}) == 0);
  CHECK(world.err.empty());
  world.width = 80;
  CHECK(world.directorc({"trace", "run.jsonl", "--to=perfetto"}) == 2);
  CHECK(world.out.empty());
  CHECK(world.err == "directorc: --to=perfetto writes bytes that a terminal cannot show: -o FILE.perfetto-trace writes "
                     "them to a file, for https://ui.perfetto.dev\n");
  CHECK(world.directorc({"trace", "run.jsonl", "--to=perfetto", "-o", "run.perfetto-trace"}) == 0);
  CHECK(world.outputs.files.at("run.perfetto-trace") == bytes);
  CHECK(world.err ==
        "directorc: wrote `run.perfetto-trace`; `Open trace file` on https://ui.perfetto.dev shows it, and "
        "keeps it on this machine\n");
}

TEST_CASE("of a trace that was cut off in its last line the rest is read") {
  World world = with_trace();
  world.directorc({"trace", "run.jsonl"});
  const std::string whole = world.out;
  const std::string cut = trace_in(world).substr(0, trace_in(world).size() - 5);
  world.files.add("cut.jsonl", cut);
  CHECK(world.directorc({"trace", "cut.jsonl"}) == 0);
  CHECK(whole.starts_with(world.out));
  const auto lines = std::count(cut.begin(), cut.end(), '\n') + 1;
  CHECK(world.err == "cut.jsonl:" + std::to_string(lines) + ": note: the last line is cut off, and was left out\n");
  CHECK(world.directorc({"replay", "cut.jsonl"}) == 0);
  CHECK(world.out == "cut.jsonl: " + std::to_string(lines - 2) + " events, all the same\n");
}

TEST_CASE("a trace may end its lines as Windows does") {
  World world = with_trace();
  std::string text;
  for (const char letter : trace_in(world)) text += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  world.files.add("windows.jsonl", text);
  CHECK(world.directorc({"replay", "windows.jsonl"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.directorc({"trace", "windows.jsonl", "--to=json"}) == 0);
  CHECK(world.out == trace_in(world));
}

TEST_CASE("empty lines at the end of a trace are ignored") {
  World world = with_trace();
  for (const char* end : {"\n", "\r\n", "\n\n \t\n", "  "}) {
    CAPTURE(end);
    world.files.add("longer.jsonl", trace_in(world) + end);
    CHECK(world.directorc({"replay", "longer.jsonl"}) == 0);
    CHECK(world.err + world.out == "longer.jsonl: 37 events, all the same\n");
    CHECK(world.directorc({"trace", "longer.jsonl", "--to=json"}) == 0);
    CHECK(world.err + world.out == trace_in(world));
  }
}

TEST_CASE("a replay of a trace without events fails, and says that there is nothing to replay") {
  World world = with_trace();
  const std::string header = traced_line(trace_in(world), 1) + "\n";
  const std::string none = "none.jsonl: the trace has no events behind its header: nothing was replayed\n";
  const auto replay = [&](const std::string& text, const std::vector<std::string>& more) {
    world.files.add("none.jsonl", text);
    std::vector<std::string> words{"replay", "none.jsonl"};
    words.insert(words.end(), more.begin(), more.end());
    CHECK(world.directorc(words) == 1);
    return world.err + world.out;
  };
  CHECK(replay(header, {}) == none);
  CHECK(replay(header + "\n", {}) == none);
  CHECK(replay(header + "{\"t\":0", {}) == "none.jsonl:2: note: the last line is cut off, and was left out\n" + none);
  CHECK(replay(header, {"--format=json"}) ==
        "{\"trace\":\"none.jsonl\",\"behaviour\":\"rover.yaml\",\"other_version\":false,\"events\":0,\"dropped\":0}\n");
  std::string other = rover_that_is_recorded;
  other.replace(other.find("priority: 20"), 12, "priority: 21");
  world.files.add("other.yaml", other);
  CHECK(replay(header, {"--behaviour=other.yaml"}) == none);
  CHECK(replay(header + "{\"event\":\"dropped\",\"count\":3}\n", {}) ==
        "none.jsonl: 0 events the same, up to where 3 events are missing\n");
}

TEST_CASE("a trace that nests without end is reported with its line") {
  World world = with_trace();
  std::string deep = traced_line(trace_in(world), 1) + "\n";
  for (int i = 0; i < 300'000; ++i) deep += "{\"a\":";
  world.files.add("deep.jsonl", deep + "1" + std::string(300'000, '}') + "\n");
  CHECK(world.directorc({"replay", "deep.jsonl"}) == 1);
  CHECK(world.err == "deep.jsonl:2: error: this line cannot be read: it is no JSON object\n"
                     "  help: expected is one JSON object a line, an event each, as a recorder writes them; the lines "
                     "before are good: `head -n 1 deep.jsonl` prints them\n");
}

TEST_CASE("a line that is not of a trace is reported with its number") {
  World world = with_trace();
  const auto say = [&](const std::string& text) {
    world.files.add("bad.jsonl", text);
    CHECK(world.directorc({"trace", "bad.jsonl"}) == 1);
    CHECK(world.directorc({"replay", "bad.jsonl", "--behaviour=rover.yaml"}) == 1);
    return world.err + world.out;
  };
  const std::string header = traced_line(trace_in(world), 1) + "\n";
  const std::string none = "bad.jsonl:1: error: this is no trace: its first line is not the header of one\n"
                           "  help: expected are the JSON lines of a recorder or of `directorc simulate --trace`; a "
                           ".perfetto-trace is opened "
                           "on https://ui.perfetto.dev\n";
  CHECK(say("") == "bad.jsonl:1: error: the trace is empty: nothing was recorded, or nothing of it was written\n");
  CHECK(say(header.substr(0, 60)) == "bad.jsonl:1: error: the trace is cut off within its first line\n");
  CHECK(say("{\"direct") == none);
  CHECK(say("\xff\x00\n{}") == none);
  CHECK(say("{\"director_trace\":2}\n") == "bad.jsonl:1: error: a trace of version 2; this program reads version 1\n");
  const std::string help = "  help: expected is one JSON object a line, an event each, as a recorder writes them; the "
                           "lines before are good: `head -n 1 bad.jsonl` prints them\n";
  const std::string unreadable = "bad.jsonl:2: error: this line cannot be read: ";
  const std::string none_before = "bad.jsonl: 0 events the same, up to line 2, which cannot be read\n";
  CHECK(say(header + "{\"t\":\n{}\n") == unreadable + "it is no JSON object\n" + help + none_before);
  CHECK(say(header + "\n{}\n") == unreadable + "it is empty\n" + help + none_before);
  CHECK(say(header + " \t\r\n{}\n") == unreadable + "it is empty\n" + help + none_before);
  CHECK(say(header + "[]\n") == unreadable + "it is no JSON object\n" + help + none_before);
  CHECK(say(header + "{}\n") == unreadable + "it names no event\n" + help + none_before);
  CHECK(say(header + header) ==
        unreadable + "another recording begins here, and each is read by itself\n" + help + none_before);
  CHECK(say(header + "{\"event\":\"run\",\"group\":\"Nobody\"}\n") ==
        unreadable + "the behaviour has no group called `Nobody`\n" + help + none_before);
  CHECK(say(header + "{\"event\":\"run\",\"group\":\"Drive\"}\n") ==
        unreadable + "`run` without its provider\n" + help + none_before);
  CHECK(say(header + "{\"t\":0,\"n\":0,\"event\":\"given\",\"state\":\"Motion\",\"value\":7}\n") ==
        unreadable + "`Motion` cannot be 7\n" + help + none_before);
  for (const char* count : {"", ",\"count\":-1", ",\"count\":0", ",\"count\":\"many\""}) {
    CHECK(say(header + "{\"event\":\"dropped\"" + count + "}\n") ==
          unreadable + "`dropped` needs a `count` from 1\n" + help + none_before);
  }
  CHECK(world.directorc({"trace", "none.jsonl"}) == 2);
}

TEST_CASE("the command that prints the good lines is right also for a file name that a shell would read otherwise") {
  World world = with_trace();
  world.files.add("a b'c $x.jsonl", traced_line(trace_in(world), 1) + "\ngarbage\n");
  CHECK(world.directorc({"trace", "a b'c $x.jsonl"}) == 1);
  CHECK(world.err.find("`head -n 1 'a b'\\''c $x.jsonl'` prints them\n") != std::string::npos);
}

TEST_CASE("a line that names an event, and that no recorder would have written, is not shown as if it had happened") {
  World world = with_trace();
  const std::string header = traced_line(trace_in(world), 1) + "\n";
  const std::string right =
      R"({"t":0,"n":1,"event":"run","group":"Explore","provider":"default","reasons":["new_task"]})";
  const auto trace = [&](const std::string& line) {
    world.files.add("bad.jsonl", header + line + "\n" + right + "\n");
    const int status = world.directorc({"trace", "bad.jsonl"});
    return std::to_string(status) + "\n" + world.err + world.out;
  };
  const std::string shown = "[    0.000000] run Explore new_task\n";
  CHECK(trace(right) == "0\n" + shown + shown);
  CHECK(
      trace(
          R"({"t": 0, "n": 1, "event": "run", "group": "Explore", "provider": "default", "reasons": ["new_task"]})") ==
      "0\n" + shown + shown);
  const std::string refused = "1\nbad.jsonl:2: error: this line cannot be read: a recorder would have written it as " +
                              right +
                              "\n  help: expected is one JSON object a line, an event each, as a recorder writes them; "
                              "the lines before are good: "
                              "`head -n 1 bad.jsonl` prints them\n";
  const std::string rest = right.substr(right.find(",\"n\""));
  for (const char* time : {"\"t\":\"abc\"", "\"t\":{}", "\"time\":0", "\"t\":null", "\"t\":0.5", "\"t\":7,\"t\":0"}) {
    CAPTURE(time);
    const std::string said = trace("{" + std::string(time) + rest);
    CHECK(said == (std::string(time).starts_with("\"time")
                       ? "1\nbad.jsonl:2: error: this line cannot be read: unknown key `time`\n" +
                             refused.substr(refused.find("  help"))
                       : refused));
  }
  CHECK(
      trace(R"({"t":0,"n":1,"event":"run","group":"Explore","provider":"default","reasons":["new_task","newtask"]})") ==
      refused);
}

TEST_CASE("a number that a state was refused is shown, and one that is no level of a request is not") {
  World world = with_trace();
  const auto trace = [&](const std::string& line) {
    world.files.add("bad.jsonl", traced_line(trace_in(world), 1) + "\n{\"t\":0,\"n\":1,\"event\":" + line + "}\n");
    const int status = world.directorc({"trace", "bad.jsonl"});
    return std::to_string(status) + "\n" + world.err + world.out;
  };
  CHECK(trace(R"("refused","group":"Drive","provider":"rolling","state":"Motion","value":7)") ==
        "0\n[    0.000000] refused Motion 7\n");
  CHECK(trace(R"("ask","edge":"Explore>Drive","level":1)")
            .starts_with("1\nbad.jsonl:2: error: this line cannot be read: the request has no level 1\n"));
}

TEST_CASE("an answer has the place of the pack that a scenario names") {
  World world;
  world.files.add("robot.yaml", "behaviour: robot\nlanguage: 1\nroots: [Play]\ngroups:\n"
                                "  Play: {packs: {a: [Head], b: [Legs]}}\n  Head: {}\n  Legs: {}\n");
  world.files.add("s.yaml", "scenario: packs\nbehaviour: robot.yaml\nscript: {Play: {pack: b}}\n"
                            "steps:\n  - request: Play\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  CHECK(traced_line(trace_in(world), 6) ==
        R"({"t":0,"n":2,"event":"answer","group":"Play","provider":"default","answer":"pack","pack":1})");
}

TEST_CASE("the same behaviour decides the same") {
  World world = with_trace();
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  CHECK(world.out == "run.jsonl: 37 events, all the same\n");
  CHECK(world.directorc({"replay", "run.jsonl", "--format=json"}) == 0);
  CHECK(world.out ==
        "{\"trace\":\"run.jsonl\",\"behaviour\":\"rover.yaml\",\"other_version\":false,\"events\":37,\"dropped\":0}\n");
}

TEST_CASE("a trace with blanks, as other programs write JSON, is replayed too") {
  World world = with_trace();
  std::string wide;
  for (const char c : trace_in(world)) {
    wide += c;
    if (c == ':' && wide.ends_with("\":")) wide += ' ';
  }
  world.files.add("wide.jsonl", wide);
  CHECK(world.directorc({"replay", "wide.jsonl"}) == 0);
  CHECK(world.out == "wide.jsonl: 37 events, all the same\n");
}

TEST_CASE("a text of a trace may end with a backslash, and blanks behind it are none of it") {
  TraceLines lines(R"({ "a": "b\\", "c": "d \" e" , "f": 1 })"
                   "\n");
  const std::optional<TraceLine> line = lines.next();
  REQUIRE(line);
  CHECK(line->text == R"({"a":"b\\","c":"d \" e","f":1})");
}

TEST_CASE("a body that requests some of its tasks is replayed, also by a version that lists them in another order") {
  World world;
  const auto robot = [](const std::string& tasks) {
    return "behaviour: robot\nlanguage: 1\nroots: [Play]\ngroups:\n  Play: {every: 1 s, tasks: [" + tasks +
           "]}\n  A: {}\n  B: {}\n  C: {}\n";
  };
  world.files.add("robot.yaml", robot("A, B, C"));
  world.files.add("s.yaml", "scenario: turns\nbehaviour: robot.yaml\nscript: {Play: [{run: 1, tasks: [A]}, "
                            "{run: 2, tasks: [A: {keep: true}, B]}, {tasks: [C]}]}\n"
                            "steps: [{request: Play}, {advance: 2 s}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", trace_in(world));
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  world.files.add("other.yaml", robot("C, B, A"));
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 0);
  INFO(world.out);
  CHECK(world.out.ends_with("all the same by `other.yaml`, another version than the one recorded\n"));
}

TEST_CASE("a request of a task of another group is not replayed, though it has a task of that name too") {
  World world;
  world.files.add("robot.yaml", "behaviour: robot\nlanguage: 1\nroots: [Other, Play]\ngroups:\n  Other: {tasks: [B]}\n"
                                "  Play: {tasks: [A, B]}\n  A: {}\n  B: {}\n");
  world.files.add("s.yaml", "scenario: play\nbehaviour: robot.yaml\nsteps: [{request: Play}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  std::string trace = trace_in(world);
  trace.replace(trace.find("\"ask\",\"edge\":\"Play>B"), 18, "\"ask\",\"edge\":\"Other");
  world.files.add("run.jsonl", trace);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 1);
  CHECK(world.out.starts_with("run.jsonl:8: event 7, at 0.000000 s, is decided otherwise\n  recorded: ask Other>B\n"));
}

TEST_CASE("a first step at a later time than the beginning is replayed at that time") {
  World world;
  world.files.add("oven.yaml", "behaviour: oven\nlanguage: 1\nstates: {Heat: {range: [0, 100], initial: 0, external: "
                               "true}}\nroots: [Bake]\ngroups: {Bake: {when: [Heat > 50]}}\n");
  world.files.add("s.yaml", "scenario: warming up\nbehaviour: oven.yaml\ngiven: {Heat: 10}\n"
                            "steps: [{advance: 10 ms}, {set: {Heat: 80}}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", trace_in(world));
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  CHECK(world.out == "run.jsonl: 3 events, all the same\n");
}

TEST_CASE("a value that a handler sets again and that does not change restarts its expiry in a replay too") {
  World world;
  world.files.add("lamp.yaml", R"(behaviour: lamp
language: 1
states:
  Heat: {range: [0, 9], initial: 7, expires: {after: 300 ms, to: 0}}
roots: [Lamp, Other]
groups:
  Lamp: {stop: {sets: [Heat == 7]}, sets: [Heat]}
  Other: {}
)");
  world.files.add("s.yaml", R"(scenario: the lamp goes out while it is hot
behaviour: lamp.yaml
script:
  Lamp.stop: {set: {Heat: 7}}
steps:
  - request: Lamp
  - advance: 100 ms
  - cancel: Lamp
  - advance: 50 ms
  - request: Other
  - advance: 1 s
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", trace_in(world));
  REQUIRE(trace_in(world).find(R"({"t":400000,"n":8,"event":"input","input":"expire","state":"Heat"})") !=
          std::string::npos);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  CHECK(world.err.empty());
}

TEST_CASE("a wait without end at a time before 0 is replayed as it was recorded") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n");
  world.files.add("s.yaml", R"(scenario: the lamp waits
behaviour: lamp.yaml
script:
  Lamp: {wait: 2 s, continue: true}
steps:
  - request: Lamp
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  std::string trace = trace_in(world);
  for (std::size_t at = trace.find("\"t\":0"); at != std::string::npos; at = trace.find("\"t\":0", at))
    trace.replace(at, 5, "\"t\":-1000000");
  const std::string due = ",\"due\":2000000";
  trace.erase(trace.find(due), due.size());
  world.files.add("run.jsonl", trace);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  CHECK(world.out == "run.jsonl: 6 events, all the same\n");
}

TEST_CASE("a damaged line ends a replay, and is never a decision") {
  World world = with_trace();
  std::string other = rover_that_is_recorded;
  other.replace(other.find("priority: 20"), 12, "priority: 21"); // no decision differs
  world.files.add("other.yaml", other);
  const auto replay_with = [&](std::size_t damaged, const std::string& text, const char* behaviour) {
    std::string some;
    for (std::size_t i = 1; i <= 38; ++i) some += (i == damaged ? text : traced_line(trace_in(world), i)) + "\n";
    world.files.add("bad.jsonl", some);
    CHECK(world.directorc({"replay", "bad.jsonl", std::string("--behaviour=") + behaviour}) == 1);
    return world.err.substr(0, world.err.find('\n') + 1) + world.out;
  };
  CHECK(replay_with(18, "garbage", "rover.yaml") ==
        "bad.jsonl:18: error: this line cannot be read: it is no JSON object\n"
        "bad.jsonl: 16 events the same, up to line 18, which cannot be read\n");
  CHECK(replay_with(18, R"({"t":0,"n":5,"event":"push","group":"Drive","edge":"root>Photograph"})", "other.yaml") ==
        "bad.jsonl:18: error: this line cannot be read: `push` without its provider\n"
        "bad.jsonl: 16 events the same by `other.yaml`, another version than the one recorded, up to line 18, which "
        "cannot be read\n");
  CHECK(replay_with(18, R"({"t":0,"n":5,"event":"push","group":"Drvie","provider":"braking","edge":"root>Photograph"})",
                    "other.yaml")
            .starts_with("bad.jsonl:18: error: this line cannot be read: the behaviour has no group called `Drvie`\n"));
  CHECK(replay_with(18, R"({"n":5,"event":"lost","count":1})", "rover.yaml") ==
        "bad.jsonl:18: error: this line cannot be read: a recorder would have written it as "
        R"({"t":0,"n":5,"event":"lost","count":1})"
        "\nbad.jsonl: 16 events the same, up to line 18, which cannot be read\n");
  const std::string line = traced_line(trace_in(world), 18);
  CHECK(replay_with(18, "{" + line.substr(line.find("\"event")), "rover.yaml") ==
        "bad.jsonl:18: error: this line cannot be read: a recorder would have written it as " +
            std::string("{\"t\":0,\"n\":0,") + line.substr(line.find("\"event")) + "\n" +
            "bad.jsonl: 16 events the same, up to line 18, which cannot be read\n");
  CHECK(world.directorc({"replay", "bad.jsonl", "--format=json"}) == 1);
  CHECK(world.out.starts_with(
      "{\"trace\":\"bad.jsonl\",\"behaviour\":\"rover.yaml\",\"other_version\":false,\"events\":16,"
      "\"dropped\":0,\"unreadable\":{\"line\":18,\"problem\":\"a recorder would"));
  // For each line.
  for (std::size_t damaged = 2; damaged <= 38; ++damaged) {
    const std::string at = std::to_string(damaged), before = std::to_string(damaged - 2);
    CHECK(replay_with(damaged, "{\"t\":0", "rover.yaml") ==
          "bad.jsonl:" + at + ": error: this line cannot be read: it is no JSON object\nbad.jsonl: " + before +
              (damaged == 3 ? " event" : " events") + " the same, up to line " + at + ", which cannot be read\n");
    CHECK(replay_with(damaged, "{\"t\":0,\"event\":\"rnu\"}", "rover.yaml") ==
          "bad.jsonl:" + at + ": error: this line cannot be read: no event is called `rnu`\nbad.jsonl: " + before +
              (damaged == 3 ? " event" : " events") + " the same, up to line " + at + ", which cannot be read\n");
  }
}

TEST_CASE("a header that does not belong to its fingerprint, or to the events, is not another version") {
  World world = with_trace();
  std::string other = rover_that_is_recorded;
  other.replace(other.find("priority: 20"), 12, "priority: 21"); // no decision differs
  world.files.add("other.yaml", other);
  const std::string trace = trace_in(world);
  const auto with = [&](const std::string& before, const std::string& after, const char* behaviour) {
    std::string bad = trace;
    bad.replace(bad.find(before), before.size(), after);
    world.files.add("bad.jsonl", bad);
    CHECK(world.directorc({"replay", "bad.jsonl", "--behaviour", behaviour}) == 1);
    return world.err + world.out;
  };
  const std::string changed =
      "bad.jsonl:1: error: the header of the trace was changed: it has the fingerprint of `rover.yaml`, but does not "
      "name what that behaviour has\n"
      "  help: the header of any other trace of this version may replace it, such as one of `directorc simulate "
      "--trace`\n";
  CHECK(with(R"("initial":"still")", R"("initial":"rolling")", "rover.yaml") == changed);
  CHECK(with(R"({"name":"Wheels")", R"({"name":"Whels")", "rover.yaml")
            .find("the header names something that it does not declare") != std::string::npos);
  CHECK(with(R"({"name":"Explore","providers":["default"]})", R"({"name":"Explore","providers":[]})", "rover.yaml")
            .find("the header names something that it does not declare") != std::string::npos);
  CHECK(with(R"({"name":"Wheels","providers":["default"]})", R"({"name":"Wheels","providers":[]})", "rover.yaml") ==
        changed);
  CHECK(world.directorc({"trace", "bad.jsonl", "--to=html", "-o", "page.html"}) == 1);
  CHECK(world.err == changed);
  CHECK(
      with(R"({"name":"Wheels","providers":["default"]})", R"({"name":"Wheels","providers":["dafault"]})", "other.yaml")
          .starts_with("bad.jsonl:14: error: this line cannot be read: the behaviour has no provider called `default`"
                       "\n"));
  CHECK(with("\"fingerprint\":\"", "\"fingerprint\":\"x", "rover.yaml") ==
        "bad.jsonl:1: error: the header has no fingerprint, which is 16 hexadecimal digits\n");
  std::string wide = trace; // blanks are no damage
  wide.replace(wide.find(",\"groups\""), 1, " ,\t");
  world.files.add("wide.jsonl", wide);
  CHECK(world.directorc({"replay", "wide.jsonl"}) == 0);
}

TEST_CASE("a header that says otherwise what a level means is of another version") {
  World world = with_trace();
  std::string other = trace_in(world);
  const std::size_t uses = other.find("\"level_uses\"");
  REQUIRE(uses < other.find('\n'));
  other.replace(other.find("\"priority\":20", uses), 13, "\"priority\":21");
  world.files.add("other.jsonl", other);
  CHECK(world.directorc({"replay", "other.jsonl"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.out.ends_with("all the same by `rover.yaml`, another version than the one recorded\n"));
}

TEST_CASE("a behaviour that has another name now is no other version") {
  World world = with_trace();
  std::string renamed = rover_that_is_recorded;
  const std::string name = "behaviour: rover";
  renamed.replace(renamed.find(name), name.size(), "behaviour: lander");
  world.files.add("lander.yaml", renamed);
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour", "lander.yaml"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.out == "run.jsonl: 37 events, all the same\n");
  CHECK(world.directorc({"trace", "run.jsonl", "--to=html", "-o", "page.html", "--behaviour", "lander.yaml"}) == 0);
  CHECK(world.err.empty());
}

TEST_CASE("a byte order mark before the header, as an editor may write it, is no damage") {
  World world = with_trace();
  world.files.add("bom.jsonl", "\xEF\xBB\xBF" + trace_in(world));
  CHECK(world.directorc({"replay", "bom.jsonl"}) == 0);
  CHECK(world.out == "bom.jsonl: 37 events, all the same\n");
}

TEST_CASE("if the recorded version decides differently, the trace has been changed") {
  World world = with_trace();
  std::string some;
  for (std::size_t i = 1; i <= 38; ++i) some += i == 19 ? "" : traced_line(trace_in(world), i) + "\n";
  world.files.add("less.jsonl", some);
  CHECK(world.directorc({"replay", "less.jsonl"}) == 1);
  CHECK(world.out == R"(less.jsonl:19: event 18, at 0.000000 s, is decided otherwise
  recorded: run Drive.braking pushed
  replayed: queue root>Photograph: waiting for Motion == still
  17 events before it are the same
  it is the version that was recorded: lines of the trace are missing or were changed, the program loaded another state there, or another version of Director recorded it
)");
}

TEST_CASE("damage behind a decision that is another one does not hide it") {
  World world = with_trace();
  std::string other = rover_that_is_recorded;
  other.replace(other.find("priority: 20"), 12, "priority: 5");
  world.files.add("other.yaml", other);
  std::string some;
  for (std::size_t i = 1; i <= 18; ++i) some += traced_line(trace_in(world), i) + "\n";
  world.files.add("bad.jsonl", some + "garbage\n");
  CHECK(world.directorc({"replay", "bad.jsonl", "--behaviour=other.yaml"}) == 1);
  CHECK(world.out.starts_with("bad.jsonl:18: event 17, at 0.000000 s, is decided otherwise"));
  CHECK(world.err.empty());
}

TEST_CASE("the page of a trace with a damaged line reports it, and from where on `why` is not known") {
  World world = with_trace();
  std::string some = trace_in(world);
  const std::string line = traced_line(some, 18);
  some.replace(some.find(line), line.find("\"n\""), "{");
  world.files.add("bad.jsonl", some);
  CHECK(world.directorc({"trace", "bad.jsonl", "--to=html", "-o", "page.html"}) == 1);
  CHECK(world.err.starts_with("bad.jsonl:18: error: this line cannot be read: a recorder would have written it as {"));
}

TEST_CASE("another version decides differently, and the place is reported") {
  World world = with_trace();
  std::string other = rover_that_is_recorded;
  other.replace(other.find("priority: 20"), 12, "priority: 5");
  world.files.add("other.yaml", other);
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 1);
  CHECK(
      world.out ==
      R"(run.jsonl:18: event 17, at 0.000000 s, is decided otherwise by `other.yaml`, another version than the one recorded
  recorded: push Drive.braking for root>Photograph
  replayed: queue root>Photograph: waiting for Motion == still
  16 events before it are the same
)");
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml", "--format=json"}) == 1);
  CHECK(world.out ==
        "{\"trace\":\"run.jsonl\",\"behaviour\":\"other.yaml\",\"other_version\":true,\"events\":16,\"dropped\":0,"
        "\"difference\":{\"line\":18,\"event\":17,\"time_us\":0,\"recorded\":" +
            traced_line(trace_in(world), 18) +
            ",\"replayed\":{\"t\":0,\"n\":5,\"event\":\"queue\",\"edge\":\"root>Photograph\",\"why\":\"waiting\","
            "\"condition\":\"Motion == still\"}}}\n");
}

TEST_CASE("a version without something that was recorded") {
  World world = with_trace();
  world.files.add("other.yaml", "behaviour: rover\nlanguage: 1\nroots: [Explore]\ngroups:\n  Explore: {}\n");
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 1);
  CHECK(
      world.out ==
      R"(run.jsonl:7: event 6, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded
  recorded: ask Explore>Drive
  replayed: the behaviour has no task called `Explore>Drive`
  5 events before it are the same
)");
}

TEST_CASE(
    "of an answer that a version cannot give, the request or value that it does not have is told, not the first") {
  World world;
  const std::string head = "behaviour: lamp\nlanguage: 1\n", zap = "states: {Zap: {values: [p, q], initial: p}, ";
  const std::string of_bulb = "roots: [Shine]\ngroups:\n  Shine: {tasks: [Bulb, Fan]}\n  Bulb: {sets: [Zap, Glow]}\n"
                              "  Fan: {}\n";
  world.files.add("lamp.yaml", head + zap + "Glow: {values: [none, faint], initial: none}}\n" + of_bulb);
  world.files.add("s.yaml", "scenario: light\nbehaviour: lamp.yaml\nscript: {Bulb: {set: {Zap: q, Glow: faint}}}\n"
                            "steps: [{request: Shine}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", trace_in(world));
  const auto replay = [&](const std::string& other) {
    world.files.add("other.yaml", head + other);
    CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 1);
    return world.err + world.out;
  };
  CHECK(
      replay(zap + "Glow: {values: [none, faint], initial: none}}\nroots: [Shine]\ngroups:\n"
                   "  Shine: {tasks: [Bulb]}\n  Bulb: {sets: [Zap, Glow]}\n") ==
      R"(run.jsonl:8: event 7, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded
  recorded: ask Shine>Fan
  replayed: the behaviour has no task called `Shine>Fan`
  6 events before it are the same
)");
  CHECK(
      replay(zap + "Glow: {values: [none, dim], initial: none}}\n" + of_bulb) ==
      R"(run.jsonl:14: event 13, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded
  recorded: assign Glow faint
  replayed: `faint` is no value of the state `Glow`: its values are none, dim
  help: write one of them, or add it to the `values`
  12 events before it are the same
)");
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml", "--format=json"}) == 1);
  CHECK(world.out.ends_with("\"replayed\":null},\"cannot_be_replayed\":\"`faint` is no value of the state `Glow`: its "
                            "values are none, dim\",\"help\":\"write one of them, or add it to the `values`\"}\n"));
}

TEST_CASE("of two inputs that were taken together, the one that a version does not have is told") {
  World world;
  const std::string head = "behaviour: lamp\nlanguage: 1\n";
  world.files.add("lamp.yaml", head + "roots: [Shine, Blow]\ngroups: {Shine: {}, Blow: {}}\n");
  world.files.add("s.yaml", "scenario: both\nbehaviour: lamp.yaml\nsteps: [{request: [Shine, Blow]}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", trace_in(world));
  world.files.add("other.yaml", head + "roots: [Shine]\ngroups: {Shine: {}}\n");
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 1);
  CHECK(
      world.out ==
      R"(run.jsonl:4: event 3, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded
  recorded: > request Blow
  replayed: the behaviour has no task called `root>Blow`
  2 events before it are the same
)");
}

TEST_CASE("a trace with events missing is played up to there") {
  World world = with_trace();
  std::string some;
  for (std::size_t i = 1; i <= 10; ++i) some += traced_line(trace_in(world), i) + "\n";
  world.files.add("some.jsonl",
                  some + "{\"event\":\"dropped\",\"count\":3}\n" + traced_line(trace_in(world), 14) + "\n");
  CHECK(world.directorc({"replay", "some.jsonl"}) == 0);
  CHECK(world.out == "some.jsonl: 9 events the same, up to where 3 events are missing\n");
  CHECK(world.directorc({"trace", "some.jsonl"}) == 0);
  CHECK(world.out.find("... 3 events are missing\n") != std::string::npos);
}

TEST_CASE("a trace that begins in the middle cannot be replayed, and this is the reason that is told") {
  World world = with_trace();
  std::string some = traced_line(trace_in(world), 1) + "\n";
  for (std::size_t i = 34; i <= 38; ++i) some += traced_line(trace_in(world), i) + "\n";
  world.files.add("late.jsonl", some);
  CHECK(world.directorc({"replay", "late.jsonl"}) == 1);
  CHECK(world.err.empty());
  CHECK(
      world.out ==
      R"(late.jsonl:2: the trace begins in the middle, at 1.000000 s: its first event is not `begin`, so the state before it is not known, and it cannot be replayed
  its recorder was made later than the first step, the program loaded a saved state before that, or lines at the beginning of the trace are missing
)");
  CHECK(world.directorc({"replay", "late.jsonl", "--format=json"}) == 1);
  CHECK(world.out == "{\"trace\":\"late.jsonl\",\"behaviour\":\"rover.yaml\",\"other_version\":false,\"events\":0,"
                     "\"dropped\":0,\"begins_in_the_middle\":{\"line\":2,\"time_us\":1000000}}\n");
  CHECK(world.directorc({"trace", "late.jsonl"}) == 0);
}

TEST_CASE("where the behaviour is found that a trace names") {
  World world = with_trace();
  world.files.add("runs/run.jsonl", trace_in(world));
  world.files.add("runs/rover.yaml", rover_that_is_recorded);
  CHECK(world.directorc({"replay", "runs/run.jsonl"}) == 0); // relative to the working directory
  World elsewhere;
  elsewhere.files.add("runs/run.jsonl", trace_in(world));
  elsewhere.files.add("runs/rover.yaml", rover_that_is_recorded);
  CHECK(elsewhere.directorc({"replay", "runs/run.jsonl"}) == 0); // beside the trace
  World nowhere;
  nowhere.files.add("run.jsonl", trace_in(world));
  CHECK(nowhere.directorc({"replay", "run.jsonl"}) == 2);
  CHECK(nowhere.err == "directorc: cannot read `rover.yaml`: No such file or directory\n"
                       "  help: the trace names this behaviour; where it is neither there nor beside the trace, say "
                       "where it is with --behaviour FILE\n");
  std::string of_program = trace_in(world);
  const std::size_t file = of_program.find("\"file\":");
  of_program.erase(file, of_program.find(',', file) + 1 - file);
  nowhere.files.add("run.jsonl", of_program);
  CHECK(nowhere.directorc({"replay", "run.jsonl"}) == 2);
  CHECK(nowhere.err ==
        "directorc: cannot read `rover.yaml`: No such file or directory\n"
        "  help: the trace has the behaviour's name, and no file: that of the name is taken; where it is "
        "neither there nor beside the trace, say where it is with --behaviour FILE\n");
}

} // namespace
