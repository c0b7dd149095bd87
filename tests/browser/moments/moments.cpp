// SPDX-License-Identifier: MIT
// moments FIRST COUNT: random scenarios as traces, each with its header, and behind the events of each micro-step a
// line {"moment": …} with what the engine's own view says then. tests/browser/moments.mjs compares what the page's
// script finds from the events alone.
#include "compiler/base/json.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/play/moment.hpp"
#include "compiler/play/play.hpp"
#include "compiler/trace/waits.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "tests/property/compiled.hpp"
#include "tests/property/generate.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace director::compiler;
using director::property::Compiled;

constexpr std::array<const char*, 5> marks{"inactive", "running", "queued", "pushed", "held"}; // as Moment::Mark

const char* name_of(Moment::Mark mark) { return marks[static_cast<std::size_t>(mark)]; }

std::string record(const Compiled& compiled, const RowNames& rows) {
  struct Tape {
    director::Names names;
    std::string text;
  };
  Tape tape{rows.names(), {}};
  PlayOptions options;
  options.events = {[](void* self, const director::Event& event) {
                      auto& to = *static_cast<Tape*>(self);
                      director::append_event(event, to.names, to.text);
                      to.text += '\n';
                    },
                    &tape};
  play(compiled.scenario, compiled.model, compiled.lowered, options, [](const Happening&) {});
  return tape.text;
}

class Telling final : public ReplayWatch {
public:
  Telling(const Compiled& compiled, const RowNames& rows, const Waits& waits)
      : of_(compiled),
        names_(rows.names()),
        waits_(waits) {}

  void event(const director::Event& event, std::size_t number) override {
    std::string line;
    director::append_event(event, names_, line);
    std::cout << line << '\n';
    for (; held_ < waits_.held.size() && waits_.held[held_].line == number; ++held_)
      std::cout << R"({"event":"held","group":")" << of_.model.groups[GroupId{waits_.held[held_].group}].name.value
                << "\"}\n";
  }

  void stepped(const director::View& view) override {
    const Moment moment = moment_of(view, of_.model, of_.lowered);
    Json groups = Json::list({}), edges = Json::list({}), pushes = Json::list({});
    for (const Moment::Standing& standing : moment.groups)
      groups.add(Json::list({Json::text(name_of(standing.mark)),
                             standing.active ? Json::text(of_.model.providers[*standing.active].name) : Json{}}));
    for (const Moment::Mark mark : moment.edges) edges.add(Json::text(name_of(mark)));
    for (const Moment::Push& push : moment.pushes)
      pushes.add(Json::list({Json::text(of_.model.groups[push.waits].name.value),
                             Json::text(of_.model.groups[push.pushed].name.value),
                             Json::text(of_.model.providers[push.to].name)}));
    std::cout << to_line(Json::object({{"moment", Json::object({{"groups", std::move(groups)},
                                                                {"edges", std::move(edges)},
                                                                {"pushes", std::move(pushes)},
                                                                {"values", Json::texts(moment.values)}})}}))
              << '\n';
  }

private:
  const Compiled& of_;
  const director::Names names_;
  const Waits& waits_;
  std::size_t held_ = 0;
};

} // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const auto first = std::strtoull(words[1], nullptr, 10), cases = std::strtoull(words[2], nullptr, 10);
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const director::property::Documents documents = director::property::generate(seed);
    const auto result = director::property::compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    if (!result.compiled) return 1;
    const RowNames rows(result.compiled->model, result.compiled->lowered);
    Json initial = Json::object({});
    for (const State& state : result.compiled->model.states)
      initial.add(state.name.value, state.initial ? Json::text(state.value_text(*state.initial)) : Json{});
    std::cout << to_line(Json::object({{"seed", Json::count(seed)}, {"initial", std::move(initial)}})) << '\n';
    std::string header;
    director::append_header(rows.names(), "", header);
    std::cout << header << '\n';
    const std::string recorded = record(*result.compiled, rows);
    TraceLines asked(recorded), lines(recorded);
    director::dsl::Sources sources; // for the places that answers name
    sources.add("scenario.yaml", to_yaml(documents.scenario));
    sources.add("behaviour.yaml", to_yaml(documents.behaviour));
    const Waits waits = find_waits(asked, result.compiled->model, result.compiled->lowered, sources);
    Telling telling(*result.compiled, rows, waits);
    replay(lines, rows.names(), &telling);
  }
  return 0;
}
