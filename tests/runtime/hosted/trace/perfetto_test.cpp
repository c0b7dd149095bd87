// SPDX-License-Identifier: MIT
// Tests the traces for Perfetto: what protoc reads of them with the numbers of Perfetto's schema.
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <sstream>

using namespace director::tests;

namespace {

/// One packet as protoc prints it: `name: value` at any depth.
struct Packet {
  std::multimap<std::string, std::string> fields;
  std::string operator[](const std::string& name) const {
    const auto [first, end] = fields.equal_range(name); // the outermost comes last
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

} // namespace

TEST_CASE("in a trace for Perfetto slices nest, flows have both ends, and time goes on") {
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
        if (!packet["parent_uuid"].empty()) CHECK(packet["parent_uuid"] == "1");
        continue;
      }
      const std::string track = packet["track_uuid"], type = packet["type"];
      CHECK(tracks.contains(track));
      const std::uint64_t time = std::stoull("0" + packet["timestamp"]);
      CHECK(time >= now);
      now = time;
      if (type == "TYPE_SLICE_BEGIN") CHECK(++open[track] == 1); // one provider at a time is in charge
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

TEST_CASE("what a rover does, as Perfetto reads it", "[golden]") {
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
