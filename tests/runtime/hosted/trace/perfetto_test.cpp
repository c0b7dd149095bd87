// SPDX-License-Identifier: MIT
// Tests the traces for Perfetto: reads them with protoc and the numbers of Perfetto's schema.
#include "runtime/hosted/trace/recorder.hpp"
#include "tests/runtime/hosted/trace/lamp.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <thread>

using namespace director::tests;

namespace {

/// One packet as protoc prints it: `name: value` at any depth.
struct Packet {
  std::multimap<std::string, std::string> fields;
  std::string operator[](const std::string& name) const {
    const auto [first, end] = fields.equal_range(name); // the outermost is last
    return first == end ? "" : std::prev(end)->second;
  }
};

std::vector<Packet> packets_of(const std::string& text) {
  std::vector<Packet> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "packet {") out.emplace_back();
    const std::size_t begin = line.find_first_not_of(' '), colon = line.find(": ");
    if (colon != std::string::npos && !out.empty())
      out.back().fields.emplace(line.substr(begin, colon - begin), line.substr(colon + 2));
  }
  return out;
}

std::string decoded(const std::string& scenario, std::string& slices) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string();
  const auto ran = run_command(
      "directorc simulate " + scenario + " --trace " + in + "/t.jsonl >/dev/null && directorc trace " + in +
          "/t.jsonl --to=perfetto -o " + in +
          "/t.pftrace && protoc --decode=perfetto.protos.Trace tests/support/perfetto.proto <" + in + "/t.pftrace",
      source_dir());
  slices = scenario;
  REQUIRE(ran.status == 0);
  return ran.output;
}

/// The output of protoc for these bytes.
std::vector<Packet> packets_in(const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "t.pftrace").string();
  std::ofstream(file, std::ios::binary) << bytes;
  const Ran ran =
      run_command("protoc --decode=perfetto.protos.Trace tests/support/perfetto.proto <" + file, source_dir());
  REQUIRE(ran.status == 0);
  return packets_of(ran.output);
}

/// The complete packets, one after another, as Perfetto itself reads a file.
std::string whole_packets(const std::string& bytes) {
  std::size_t whole = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    REQUIRE(bytes[at] == '\x0a'); // the field `packet`
    std::uint64_t length = 0;
    std::size_t next = at + 1;
    for (int bits = 0; next < bytes.size(); bits += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes[next++]);
      length |= static_cast<std::uint64_t>(byte & 127) << bits;
      if (byte < 128) break;
    }
    at = next + length;
    if (at <= bytes.size()) whole = at;
  }
  return bytes.substr(0, whole);
}

} // namespace

/// The values of the counter of this name, with their times.
std::string counts_on(const std::string& counter, const std::string& bytes) {
  std::string track, seen;
  for (const Packet& packet : packets_in(bytes)) {
    if (packet["name"] == '"' + counter + '"') track = packet["uuid"];
    if (packet["type"] == "TYPE_COUNTER" && packet["track_uuid"] == track)
      seen += packet["timestamp"] + ": " + packet["counter_value"] + "\n";
  }
  return seen;
}

TEST_CASE("a counter in a trace for Perfetto has the number of lost inputs") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes;
  format->begin(bytes);
  for (const std::uint32_t lost : {3U, 1U, 7U}) {
    director::Event event = lamp.event(director::Event::Kind::lost, lost * 1000);
    event.count = lost;
    format->event(event, bytes);
  }
  CHECK(counts_on("lost inputs", bytes) == "3000000: 3\n3000000: 4\n7000000: 11\n"); // time does not go back
}

TEST_CASE("a counter in a trace for Perfetto has the number of queued tasks: none of a group that does not run, nor "
          "after missing events") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes;
  format->begin(bytes);
  using Kind = director::Event::Kind;
  const director::Index root_shine = 0, root_signal = 1, shine_bulb = 2, signal_bulb = 3;
  const auto record = [&](Kind kind, std::uint32_t time, director::Index edge) {
    director::Event event = lamp.event(kind, time, time);
    event.edge = kind == Kind::stop ? director::nil : edge;
    event.group = kind == Kind::stop ? edge : lamp.lowered.edges[edge].target;
    format->event(event, bytes);
  };
  record(Kind::queue, 1, shine_bulb);
  record(Kind::queue, 2, root_shine);
  record(Kind::grant, 3, root_shine); // only held, without an active provider
  record(Kind::queue, 4, signal_bulb);
  record(Kind::stop, 5, lamp.lowered.edges[root_signal].target);
  record(Kind::queue, 6, root_signal);
  format->dropped(1, bytes);
  CHECK(counts_on("queued tasks", bytes) == "1000: 1\n2000: 2\n3000: 1\n3000: 0\n4000: 1\n5000: 0\n6000: 1\n6000: 0\n");
}

TEST_CASE(
    "in a trace for Perfetto the tracks are in the order of declaration, and those of states have their own parent") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes, seen;
  format->begin(bytes);
  for (const Packet& packet : packets_in(bytes)) {
    seen += packet["parent_uuid"] + "/" + packet["sibling_order_rank"] + " " + packet["uuid"] + " " +
            packet[packet["process_name"].empty() ? "name" : "process_name"] + " " + packet["child_ordering"] + "\n";
  }
  CHECK(seen == "/ 1 \"lamp\" EXPLICIT\n"
                "1/0 2 \"from outside\" \n"
                "1/1 16 \"Shine\" \n"
                "1/2 17 \"Signal\" \n"
                "1/3 18 \"Bulb\" \n"
                "1/4 5 \"values of states\" EXPLICIT\n"
                "5/0 19 \"Motion\" \n"
                "5/1 20 \"Charge\" \n"
                "1/5 3 \"queued tasks\" \n"
                "1/6 4 \"lost inputs\" \n");
}

TEST_CASE("in a trace for Perfetto no group has the name of another track, as viewers would merge the two") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes;
  format->begin(bytes);
  for (const Packet& packet : packets_in(bytes)) {
    const bool is_named = packet["parent_uuid"] == "1" && std::stoi(packet["uuid"]) < 16; // tracks of groups come then
    if (is_named) CHECK(packet["name"].find(' ') != std::string::npos); // the name of a group has none
  }
}

TEST_CASE("a trace for Perfetto has no time beyond the range of its viewer") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes;
  format->begin(bytes);
  constexpr director::Time last = 9'223'372'036'854'775; // microseconds: 292 years
  for (const director::Time time : {last - 1, last, last + 1, std::numeric_limits<director::Time>::max()}) {
    director::Event event = lamp.event(director::Event::Kind::lost, time);
    event.count = 1;
    format->event(event, bytes);
  }
  CHECK(counts_on("lost inputs", bytes) == "9223372036854774000: 1\n9223372036854775000: 2\n9223372036854775000: 3\n"
                                           "9223372036854775000: 4\n");
}

TEST_CASE("in a trace for Perfetto each value of a state is a slice, and unknown after missing events") {
  const Lamp lamp;
  const std::unique_ptr<director::TraceFormat> format = director::perfetto(lamp.names);
  std::string bytes;
  format->begin(bytes);
  using Kind = director::Event::Kind;
  const auto record = [&](Kind kind, director::Time time, director::Index state = director::nil,
                          std::int32_t value = 0) {
    director::Event event = lamp.event(kind, time);
    if (kind == Kind::input) event.input = director::Event::Input::set;
    event.state = state;
    event.value = value;
    format->event(event, bytes);
  };
  record(Kind::begin, 0);
  record(Kind::given, 0, 1, 80);
  record(Kind::set, 1, 0, 1);
  record(Kind::set, 2, 0, 1); // the same value
  record(Kind::input, 3, 1, 79);
  record(Kind::set, 4, 1, director::unset);
  format->dropped(7, bytes);
  record(Kind::given, 5, 0, 0);
  format->end(bytes);
  std::string seen;
  for (const Packet& packet : packets_in(bytes)) {
    const std::string track = packet["track_uuid"];
    if (!track.empty())
      seen += packet["timestamp"] + " " +
              (track == "19"   ? "Motion"
               : track == "20" ? "Charge"
                               : "outside") +
              " " + packet["type"].substr(5) + " " + packet["name"] + "\n";
  }
  CHECK(seen == "0 Motion SLICE_BEGIN \"still\"\n"
                "0 Charge SLICE_BEGIN \"unset\"\n"
                "0 Charge SLICE_END \n"
                "0 Charge SLICE_BEGIN \"80\"\n"
                "1000 Motion SLICE_END \n"
                "1000 Motion SLICE_BEGIN \"moving\"\n"
                "3000 Charge SLICE_END \n"
                "3000 Charge SLICE_BEGIN \"79\"\n"
                "3000 outside INSTANT \"set {Charge: 79}\"\n"
                "4000 Charge SLICE_END \n"
                "4000 Charge SLICE_BEGIN \"unset\"\n"
                "4000 Motion SLICE_END \n"
                "4000 Charge SLICE_END \n"
                "4000 outside INSTANT \"7 events are missing\"\n"
                "5000 Motion SLICE_BEGIN \"still\"\n"
                "5000 Motion SLICE_END \n");
}

TEST_CASE("a trace for Perfetto of a process that is killed can be read up to shortly before its end") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.perfetto-trace").string();
  const Lamp lamp;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    director::Recorder recorder{lamp.names, file, {.interval = std::chrono::milliseconds(1), .waits = true}};
    for (int i = 0;; ++i) recorder.tell(lamp.event(director::Event::Kind::exhausted, i));
  }
  while (!std::filesystem::exists(file) || std::filesystem::file_size(file) < 200'000)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const std::string bytes = read_file(file), whole = whole_packets(bytes);
  CHECK(bytes.size() - whole.size() < 100); // at most one packet is cut off
  const std::vector<Packet> packets = packets_in(whole);
  std::uint64_t events = 0;
  for (const Packet& packet : packets) {
    if (packet["name"] != "\"budget_exhausted\"") continue;
    if (std::stoull("0" + packet["timestamp"]) != events * 1000) FAIL(packet["timestamp"] << " after " << events);
    ++events;
  }
  CHECK(events > 5000);
}

TEST_CASE("in a trace for Perfetto slices nest, flows have both ends, and time does not go back") {
  for (const char* scenario : {"tests/docs/rover/rover.scenario.yaml", "tests/conformance/timers.scenario.yaml",
                               "tests/conformance/a_pusher_is_displaced_and_restored.scenario.yaml",
                               "behaviours/soccer/scenarios/a_promise_is_broken.scenario.yaml"}) {
    std::string of;
    const std::vector<Packet> packets = packets_of(decoded(scenario, of));
    CAPTURE(of);
    std::set<std::string> tracks;
    std::map<std::string, int> open;
    std::set<std::string> begun, ended;
    std::uint64_t now = 0;
    std::map<std::string, std::int64_t> counters;
    for (const Packet& packet : packets) {
      CHECK(packet["trusted_packet_sequence_id"] == "1");
      if (!packet["uuid"].empty()) {
        CHECK(tracks.insert(packet["uuid"]).second);
        if (!packet["parent_uuid"].empty()) CHECK(tracks.contains(packet["parent_uuid"]));
        continue;
      }
      const std::string track = packet["track_uuid"], type = packet["type"];
      CHECK(tracks.contains(track));
      const std::uint64_t time = std::stoull("0" + packet["timestamp"]);
      CHECK(time >= now);
      now = time;
      if (type == "TYPE_SLICE_BEGIN") CHECK(++open[track] == 1); // one provider at a time is active
      if (type == "TYPE_SLICE_END") CHECK(--open[track] == 0);
      if (type == "TYPE_COUNTER") {
        counters[track] = std::stoll(packet["counter_value"]);
        CHECK(counters[track] >= 0);
      }
      if (const std::string flow = packet["flow_ids"]; !flow.empty()) CHECK(begun.insert(flow).second);
      if (const std::string flow = packet["terminating_flow_ids"]; !flow.empty()) {
        CHECK(begun.contains(flow));
        CHECK(ended.insert(flow).second);
      }
    }
    CHECK(packets.size() > 10);
    CHECK(begun == ended);
    for (const auto& [track, depth] : open) CHECK(depth == 0);
  }
}

namespace {

/// Slices of groups and the counter of queued tasks, a line each, of this behaviour and scenario.
std::string shown_of(const std::string& behaviour, const std::string& scenario) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "b.yaml") << behaviour;
  std::ofstream(folder.path() / "s.yaml") << scenario;
  std::string of, out;
  std::map<std::string, std::string> names;
  for (const Packet& packet : packets_of(decoded((folder.path() / "s.yaml").string(), of))) {
    if (!packet["uuid"].empty()) names[packet["uuid"]] = packet["name"];
    const std::string type = packet["type"];
    if (type == "TYPE_SLICE_BEGIN" || type == "TYPE_SLICE_END" || type == "TYPE_COUNTER")
      out += packet["timestamp"] + " " + names[packet["track_uuid"]] + " " + type.substr(5) + packet["counter_value"] +
             "\n";
  }
  return out;
}

} // namespace

TEST_CASE("in a trace for Perfetto a group that is only held as a need does not run") {
  CHECK(shown_of("language: 1\nbehaviour: b\nroots: [Kick]\n"
                 "groups: {Kick: {needs: [Leg], packs: {work: [Leg], rest: []}}, Leg: {}}\n",
                 R"(scenario: the need stays, the request does not
behaviour: b.yaml
script:
  Kick:
    - {reason: new_task, pack: work, wait: 1 s}
    - {reason: wait, pack: rest}
steps:
  - request: Kick
  - advance: 10 s
  - cancel: Kick
)") == R"(0 "Kick" SLICE_BEGIN
0 "Leg" SLICE_BEGIN
1000000000 "Leg" SLICE_END
10000000000 "Kick" SLICE_END
)");
}

TEST_CASE("in a trace for Perfetto a request that runs without a grant is not queued any more") {
  CHECK(shown_of("language: 1\nbehaviour: b\nroots: {Kick: {priority: 10}, Guard: {priority: 20}}\n"
                 "groups: {Kick: {needs: [Leg], tasks: [Leg]}, Guard: {packs: {quiet: [], take: [Leg]}}, Leg: {}}\n",
                 R"(scenario: the guard might take the leg
behaviour: b.yaml
steps:
  - inputs: [{request: Kick}, {request: Guard}]
  - advance: 10 s
  - cancel: Guard
)") == R"(0 "Kick" SLICE_BEGIN
0 "Guard" SLICE_BEGIN
0 "queued tasks" COUNTER1
0 "queued tasks" COUNTER0
0 "Leg" SLICE_BEGIN
10000000000 "Guard" SLICE_END
10000000000 "Kick" SLICE_END
10000000000 "Leg" SLICE_END
)");
}

TEST_CASE("a run of the rover, as Perfetto reads it", "[golden]") {
  std::string of;
  const std::vector<Packet> packets = packets_of(decoded("tests/docs/rover/rover.scenario.yaml", of));
  std::map<std::string, std::string> names;
  std::string out;
  for (const Packet& packet : packets) {
    const auto unquoted = [](std::string text) { return text.size() < 2 ? text : text.substr(1, text.size() - 2); };
    if (!packet["uuid"].empty()) {
      names[packet["uuid"]] = unquoted(packet["name"].empty() ? packet["process_name"] : packet["name"]);
      continue;
    }
    const std::string type = packet["type"].substr(5);
    out += packet["timestamp"] + " " + names[packet["track_uuid"]] + " " + type;
    if (type == "INSTANT" || type == "SLICE_BEGIN") out += " " + unquoted(packet["name"]);
    if (type == "COUNTER") out += " " + packet["counter_value"];
    if (!packet["flow_ids"].empty()) out += " ->";
    if (!packet["terminating_flow_ids"].empty()) out += " <-";
    if (!packet["string_value"].empty()) out += " (" + unquoted(packet["string_value"]) + ")";
    out += "\n";
  }
  check_golden("tests/runtime/hosted/trace/golden/rover.perfetto.txt", out);
}

TEST_CASE("a trace that begins before 0 begins at 0 in Perfetto, and keeps its distances") {
  const Lamp lamp;
  const auto format = director::perfetto(lamp.names);
  std::string bytes, times;
  format->begin(bytes);
  for (const director::Time time : {-100'000'000, -99'000'000, 3'000'000}) {
    director::Event event = lamp.event(director::Event::Kind::exhausted, 0);
    event.time = time;
    format->event(event, bytes);
  }
  format->end(bytes);
  for (const Packet& packet : packets_in(bytes)) {
    if (packet["name"] == "\"budget_exhausted\"") times += packet["timestamp"] + " ";
  }
  CHECK(times == "0 1000000000 103000000000 ");
}
