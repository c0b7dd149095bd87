// SPDX-License-Identifier: MIT
// Tests runtime/hosted/decision_printer.hpp: compares it with `simulate --decisions` in every scenario of
// tests/conformance; tests/docs/rover does so with a program.
#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "runtime/core/api/event_names.hpp"
#include "runtime/hosted/decision_printer.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace director;

namespace {

/// Removes the first level of a root task, which a scenario may name.
std::string without_first_level(const std::string& line, const compiler::Model& model) {
  for (const compiler::Task& task : model.roots) {
    const std::string& group = model.groups[task.target].name.value;
    if (line == "> request {" + group + ": {level: " + task.levels.front().name + "}}") return "> request " + group;
  }
  return line;
}

/// The lines of both; inputs separately, because a scenario prints all inputs of a step before the engine takes any.
struct Traces {
  std::vector<std::string> simulated, printed;
  std::vector<std::string> given, taken;
};

struct Printing {
  Names names;
  std::vector<std::string>*lines, *inputs;
  static void tell(void* self, const Event& event) {
    const auto& printing = *static_cast<Printing*>(self);
    std::array<char, 1000> buffer{};
    const std::string line = to_text(event, printing.names, buffer);
    if (!line.empty()) (line.starts_with(">") ? printing.inputs : printing.lines)->push_back(line);
  }
};

Traces play_both(const std::string& path) {
  dsl::DiskFiles files;
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, files, sources);
  const compiler::Checked checked = compiler::check(read.scenario.behaviour_path, files, sources);
  const auto resolved = compiler::resolve_scenario(read.scenario, checked.model);
  const compiler::Lowered lowered = compiler::lower(checked.model);
  Traces out;
  const compiler::RowNames names(checked.model, lowered); // as in generated code
  Printing printing{names.names(), &out.printed, &out.taken};
  compiler::play(resolved.scenario, checked.model, lowered, {.decisions = true, .events = {Printing::tell, &printing}},
                 [&](const compiler::Happening& happening) {
                   const std::string line = compiler::to_text(happening);
                   if (happening.kind != compiler::Happening::Kind::input)
                     out.simulated.push_back(line);
                   else if (!line.starts_with("> advance"))
                     out.given.push_back(without_first_level(line, checked.model));
                 });
  return out;
}

const char* word(const void*, Index) { return "x"; }

} // namespace

TEST_CASE("the printer prints the same as simulate, in every scenario of the conformance tests") {
  int scenarios = 0, lines = 0, plain = 0, levels = 0;
  for (const auto& entry : std::filesystem::directory_iterator(tests::source_dir() / "tests/conformance")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".scenario.yaml")) continue;
    CAPTURE(path);
    const Traces traces = play_both(path);
    CHECK(traces.printed == traces.simulated);
    // The program's data are not printed; an input of several is a line for each; the first level need not be named.
    const bool is_plain = std::none_of(traces.given.begin(), traces.given.end(), [](const std::string& line) {
      return line.find("data:") != std::string::npos || line.find(", ") != std::string::npos;
    });
    if (is_plain) CHECK(traces.taken == traces.given);
    for (const std::string& line : traces.taken) levels += line.find("{level: ") != std::string::npos ? 1 : 0;
    plain += is_plain ? 1 : 0;
    ++scenarios;
    lines += static_cast<int>(traces.printed.size());
  }
  CHECK(scenarios > 50);
  CHECK(plain > 40);
  CHECK(levels > 0);
  CHECK(lines > 500);
}

TEST_CASE("inputs are printed as in the steps of a scenario") {
  const Names names{.self = nullptr,
                    .group = word,
                    .provider = word,
                    .edge = word,
                    .condition = word,
                    .state = word,
                    .value = [](const void*, Index, std::int32_t value) { return value == 7 ? "" : "high"; },
                    .trigger = word};
  const auto line = [&](Event::Input input, std::int32_t value = 0) {
    Event event;
    event.kind = Event::Kind::input;
    event.input = input;
    event.group = event.provider = event.state = event.trigger = 0;
    event.value = value;
    std::array<char, 100> buffer{};
    return std::string(to_text(event, names, buffer));
  };
  CHECK(line(Event::Input::request) == "> request x");
  CHECK(line(Event::Input::cancel) == "> cancel x");
  CHECK(line(Event::Input::set) == "> set {x: high}");
  CHECK(line(Event::Input::set, 7) == "> set {x: 7}");
  CHECK(line(Event::Input::fire) == "> trigger x");
  CHECK(line(Event::Input::enable) == "> enable x.x");
  CHECK(line(Event::Input::disable) == "> disable x.x");
  CHECK(line(Event::Input::wait).empty());
  Names leveled = names;
  leveled.level = [](const void*, Index row) { return row == 0 ? "" : "urgent"; };
  Event request;
  request.input = Event::Input::request;
  request.group = request.level = 0;
  std::array<char, 100> buffer{};
  CHECK(std::string(to_text(request, leveled, buffer)) == "> request x");
  request.level = 1;
  CHECK(std::string(to_text(request, leveled, buffer)) == "> request {x: {level: urgent}}");
}

TEST_CASE("a line that does not fit is cut off") {
  Event event;
  event.kind = Event::Kind::done;
  event.group = 0;
  Names names;
  names.group = word;
  std::array<char, 4> buffer{'?', '?', '?', '?'};
  CHECK(std::string(to_text(event, names, buffer)) == "don");
  std::array<char, 1> none{'?'};
  CHECK(std::string(to_text(event, names, none)).empty());
}

TEST_CASE("a line of any length is printed whole") {
  static const std::string name(2500, 'x');
  Names names;
  names.group = [](const void*, Index) { return name.c_str(); };
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "out").string();
  std::FILE* const out = std::fopen(path.c_str(), "w");
  REQUIRE(out != nullptr);
  DecisionPrinter printer{names, out, DecisionPrinter::Times::yes};
  Event event;
  event.group = 0;
  for (const auto kind : {Event::Kind::grant, Event::Kind::done, Event::Kind::stop}) { // a grant is not printed
    event.kind = kind;
    printer.tell(event);
  }
  std::fclose(out);
  CHECK(tests::read_file(path) == "[    0.000000] done " + name + "\n[    0.000000] stop " + name + "\n");
}

TEST_CASE("the time before a line is in seconds") {
  std::array<char, 40> buffer{};
  CHECK(std::string(time_text(0, buffer)) == "[    0.000000] ");
  CHECK(std::string(time_text(1'500'007, buffer)) == "[    1.500007] ");
  CHECK(std::string(time_text(1'000'000'000'000'000, buffer)) == "[1000000000.000000] ");
  CHECK(std::string(time_text(-5, buffer)) == "[   -0.000005] ");
  CHECK(std::string(time_text(std::numeric_limits<Time>::min(), buffer)) == "[-9223372036854.775808] ");
}

TEST_CASE("each enumerator of an event has its own name") {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(Event::Kind::given); ++i)
    names.emplace_back(name_of(static_cast<Event::Kind>(i)));
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(!name.empty());
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  for (int i = 0; i <= static_cast<int>(Event::Input::every); ++i)
    CHECK(*name_of(static_cast<Event::Input>(i)) != '\0');
  for (const Reason reason : all_reasons) CHECK(*name_of(reason) != '\0');
  for (int i = 0; i <= static_cast<int>(Why::deferred); ++i) CHECK(*name_of(static_cast<Why>(i)) != '\0');
}
