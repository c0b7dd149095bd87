// SPDX-License-Identifier: MIT
// Tests compiler/trace/trace_order.cpp, and what `directorc trace` says of it.
#include "compiler/trace/trace_order.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace {

using director::Event;
using director::compiler::TraceOrder;
using Kind = Event::Kind;

struct Line {
  std::uint64_t micro_step;
  Kind kind;
  director::Index provider = 0;
};

/// The first problem.
std::string problem_of(const std::vector<Line>& lines) {
  TraceOrder order;
  for (const Line& line : lines) {
    Event event;
    event.kind = line.kind;
    event.micro_step = line.micro_step;
    event.provider = line.provider;
    if (const std::string problem = order.problem_of(event); !problem.empty()) return problem;
  }
  return {};
}

TEST_CASE("a trace may go on at a lower or a higher micro-step, after a load, and begin in the middle of a run") {
  CHECK(problem_of({{3, Kind::run}, {3, Kind::answer}, {3, Kind::ask}, {2, Kind::run}, {2, Kind::answer}}).empty());
  CHECK(problem_of({{3, Kind::run}, {3, Kind::answer}, {9, Kind::input}, {9, Kind::grant}, {2, Kind::set}}).empty());
  CHECK(problem_of({{3, Kind::ask}, {3, Kind::keep}, {4, Kind::run}, {4, Kind::answer}}).empty());
  CHECK(problem_of({{3, Kind::answer}, {3, Kind::keep}, {3, Kind::run}, {3, Kind::answer}, {3, Kind::wait}}).empty());
  CHECK(problem_of({{3, Kind::stop}, {4, Kind::grant}, {4, Kind::assign, director::nil}}).empty()); // of a handler
}

TEST_CASE("an answer without its run, and a request without its answer, follow lines that are missing") {
  CHECK(problem_of({{3, Kind::run}, {3, Kind::answer}, {4, Kind::answer}}) ==
        "`answer` without `run` before it in micro-step 4: lines are missing here, or are in another order");
  CHECK(problem_of({{3, Kind::input}, {3, Kind::answer}, {4, Kind::ask}}) ==
        "`ask` without `answer` before it in micro-step 4: lines are missing here, or are in another order");
  CHECK(problem_of({{3, Kind::run}, {3, Kind::wait}}) ==
        "`wait` without `answer` before it in micro-step 3: lines are missing here, or are in another order");
  CHECK(problem_of({{3, Kind::input}, {4, Kind::assign}}) ==
        "`assign` without `answer` before it in micro-step 4: lines are missing here, or are in another order");
}

TEST_CASE("a trace whose lines are missing or swapped is printed, and says so; one that tells of it is as it is") {
  director::tests::World world;
  world.files.add("lamp.yaml",
                  "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {tasks: [Bulb]}, Bulb: {}}\n");
  world.files.add("s.yaml", "scenario: light\nbehaviour: lamp.yaml\nsteps: [{request: Lamp}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  std::vector<std::string> lines{""};
  for (const char letter : world.outputs.files.at("run.jsonl")) {
    lines.back() += letter;
    if (letter == '\n') lines.emplace_back();
  }
  const auto trace = [&](const std::vector<std::size_t>& some, const std::string& gap = "") {
    std::string text;
    for (const std::size_t number : some) text += number == 0 ? gap : lines.at(number - 1);
    world.files.add("some.jsonl", text);
    const int status = world.directorc({"trace", "some.jsonl"});
    return std::to_string(status) + "\n" + world.err + world.out;
  };
  const std::string help =
      "  help: a recorder writes every event, in the order in which it happened, and says where it "
      "dropped some; what is printed behind this line may be wrong\n";
  const std::string begin = "[    0.000000] > request Lamp\n", lamp = "[    0.000000] run Lamp new_task\n",
                    bulb = "[    0.000000] run Bulb new_task\n";
  CHECK(trace({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) == "0\n" + begin + lamp + bulb);
  CHECK(trace({1, 2, 3, 4, 6, 7, 8, 9, 10}) ==
        "1\nsome.jsonl:5: error: `answer` without `run` before it in micro-step 2: lines are missing here, or are in "
        "another order\n" +
            help + begin + bulb);
  CHECK(trace({1, 2, 3, 4, 5, 7, 6, 8, 9, 10}) ==
        "1\nsome.jsonl:6: error: `ask` without `answer` before it in micro-step 2: lines are missing here, or are in "
        "another order\n" +
            help + begin + lamp + bulb);
  CHECK(trace({1, 2, 3, 4, 0, 6, 7, 8, 9, 10}, "{\"event\":\"dropped\",\"count\":1}\n") ==
        "0\n" + begin + "... 1 event is missing\n" + bulb);
  CHECK(trace({1, 6, 7, 8, 9, 10}) == "0\n" + bulb); // begins in the middle
}

} // namespace
