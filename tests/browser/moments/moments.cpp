// SPDX-License-Identifier: MIT
// moments FIRST COUNT [NUMBER...]: random scenarios as traces, each with its header, and behind the events of each
// micro-step a line {"moment": …} with what the engine's own view says then. Before time goes on, where a program shows
// its moment, stand a line {"live": …} with what a viewer of the live view was sent since then, and {"late": …} with
// what one is sent who comes then. tests/browser/moments.mjs compares what the page's script finds from each of them.
// Each number is that of a random behaviour, and of one with a unit that
// moves.
#include "compiler/base/json.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/why/moment.hpp"
#include "compiler/trace/waits.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/live/feed.hpp"
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

/// A live view without its server: what viewers are sent, when the program has shown a moment.
class Shown {
public:
  explicit Shown(const director::Names& names) : moments_(*names.tables), feed_(queue_, moments_, names, 1 << 20) {}

  void event(const director::Event& event) {
    if (event.time > time_) tell();
    time_ = event.time;
    if (!queue_.put(event)) queue_.drop();
  }
  void stepped(const director::View& view) { moments_.show(view, queue_.total()); }
  void tell() {
    feed_.take();
    tell("live", place_);
    director::live::Place late;
    tell("late", late);
  }

private:
  void tell(const char* viewer, director::live::Place& place) {
    std::string text;
    while (const auto message = feed_.next(place)) text += *message;
    std::cout << to_line(Json::object({{viewer, Json::text(text)}})) << '\n';
  }

  director::EventQueue queue_{1 << 16};
  director::live::Moments moments_;
  director::live::Feed feed_;
  director::live::Place place_;
  director::Time time_ = -1;
};

class Telling final : public ReplayWatch {
public:
  Telling(const Compiled& compiled, const RowNames& rows, const Waits& waits)
      : of_(compiled),
        names_(rows.names()),
        waits_(waits),
        shown_(names_) {}

  void event(const director::Event& event, std::size_t number) override {
    shown_.event(event);
    std::string line;
    director::append_event(event, names_, line);
    std::cout << line << '\n';
    untold("held", waits_.held, held_, number);
    untold("stays", waits_.stays, stays_, number);
    untold("without_effect", waits_.without_effect, without_effect_, number);
    untold("in_force", waits_.in_force, in_force_, number);
  }

  void end() { shown_.tell(); }

  void stepped(const director::View& view) override {
    shown_.stepped(view);
    const Moment moment = moment_of(view, of_.model, of_.lowered);
    Json groups = Json::list({}), edges = Json::list({}), levels = Json::list({}), pushes = Json::list({});
    for (const Moment::Standing& standing : moment.groups)
      groups.add(Json::list({Json::text(name_of(standing.mark)),
                             standing.active ? Json::text(of_.model.providers[*standing.active].name) : Json{}}));
    for (const Moment::Mark mark : moment.edges) edges.add(Json::text(name_of(mark)));
    for (const EdgeId id : of_.model.edges.ids()) {
      const std::optional<std::uint32_t> level = moment.levels[id.value];
      levels.add(level && of_.model.edges[id].requester ? Json::count(*level) : Json{});
    }
    for (const Moment::Push& push : moment.pushes)
      pushes.add(Json::list({Json::text(of_.model.groups[push.waits].name.value),
                             Json::text(of_.model.groups[push.pushed].name.value),
                             Json::text(of_.model.providers[push.to].name)}));
    std::cout << to_line(Json::object({{"moment", Json::object({{"groups", std::move(groups)},
                                                                {"edges", std::move(edges)},
                                                                {"levels", std::move(levels)},
                                                                {"pushes", std::move(pushes)},
                                                                {"values", Json::texts(moment.values)}})}}))
              << '\n';
  }

private:
  void untold(const char* event, const std::vector<Waits::Held>& all, std::size_t& next, std::size_t number) {
    for (; next < all.size() && all[next].line == number; ++next)
      std::cout << R"({"event":")" << event << R"(","group":")" << of_.model.groups[GroupId{all[next].group}].name.value
                << "\"}\n";
  }

  const Compiled& of_;
  const director::Names names_;
  const Waits& waits_;
  Shown shown_;
  std::size_t held_ = 0, stays_ = 0, without_effect_ = 0, in_force_ = 0;
};

bool tell(const director::property::Documents& documents, std::uint64_t seed, const char* of) {
  const auto result = director::property::compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
  if (!result.compiled) return false;
  const RowNames rows(result.compiled->model, result.compiled->lowered);
  Json initial = Json::object({});
  for (const State& state : result.compiled->model.states)
    initial.add(state.name.value, state.initial ? Json::text(state.value_text(*state.initial)) : Json{});
  std::cout << to_line(
                   Json::object({{"seed", Json::count(seed)}, {"of", Json::text(of)}, {"initial", std::move(initial)}}))
            << '\n';
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
  replay(lines, result.compiled->model, rows.names(), &telling);
  telling.end();
  return true;
}

} // namespace

int main(int count, char** words) {
  if (count < 3) return 2;
  const auto number = [&](int at) { return std::strtoull(words[at], nullptr, 10); };
  const auto tell_both = [](std::uint64_t seed) {
    return tell(director::property::generate(seed), seed, "any") &&
           tell(director::property::generate_moving_unit(seed), seed, "a unit that moves");
  };
  for (std::uint64_t seed = number(1); seed < number(1) + number(2); ++seed) {
    if (!tell_both(seed)) return 1;
  }
  for (int i = 3; i < count; ++i) {
    if (!tell_both(number(i))) return 1;
  }
  return 0;
}
