// Header: compiler/trace/replay.hpp. Test: tests/property/replay_test.cpp.
// SPDX-License-Identifier: MIT
//
// Steps the engine one micro-step at a time. Each event has the micro-step in which it happened, so an input is posted
// when the next micro-step is the one that took it, and `until` is the time that the step was given then. Nothing else
// affects a micro-step: how many of them a step had made no difference. A micro-step without an event that follows the
// last event of a step has the time of that step.
//
// A step that continues one that ended early, because its budget was exhausted or a body failed, first takes what
// handlers set. If inputs wait then, this happens at the time of the step already, which the next event shows.
#include "compiler/trace/replay.hpp"

#include "compiler/base/seconds.hpp"
#include "compiler/trace/event_words.hpp"
#include "compiler/trace/recorded_events.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "runtime/hosted/trace/json_lines.hpp"

#include <fmt/format.h>

#include <deque>
#include <tuple>
#include <utility>
#include <vector>

namespace director::compiler {

namespace {

constexpr std::size_t most_records = 4096;           ///< of one input
constexpr std::uint32_t most_silent_steps = 100'000; ///< micro-steps without an event

using Kind = Event::Kind;

class Replayer {
public:
  Replayer(TraceLines& lines, const Model& model, const director::Names& names, ReplayWatch* watch,
           const director::Names* recorded)
      : lines_(lines),
        watch_(watch),
        names_(names),
        tables_(*names.tables),
        events_(lines, model, names, recorded),
        cells_(most_records),
        inbox_(cells_),
        memory_(tables_),
        engine_(tables_, memory_.state().data(), bodies(), inbox_, {&hear, this}) {
    engine_.set_budget(1);
  }

  Replayed play() {
    if (const RecordedEvent* const first = ahead(0))
      out_.begins_later = first->dropped == 0 && first->was.problem.empty() && first->was.event.kind != Kind::begin;
    give();
    std::uint32_t silent = 0;
    while (!over_) {
      const RecordedEvent* const next = coming();
      if (next == nullptr) break;
      const std::uint64_t steps = engine_.micro_steps();
      const std::size_t events = out_.events;
      post();
      if (over_) break;
      step(*next);
      if (over_) break;
      if (watch_ != nullptr) watch_->stepped(view_of(engine_));
      silent = out_.events == events ? silent + 1 : 0;
      if (silent == most_silent_steps || (engine_.micro_steps() == steps && out_.events == events)) differ(nullptr);
    }
    return out_;
  }

private:
  /// Makes one micro-step, in the step of this event or, if what is left of the step before has no event, in that.
  void step(const RecordedEvent& next) {
    const std::uint64_t before = engine_.micro_steps();
    bool continues = false;
    std::deque<Event>& early = events_.early_ends();
    for (; !early.empty() && early.front().micro_step <= before; early.pop_front())
      continues = early.front().micro_step == before;
    const bool is_silent = !early.empty() && early.front().micro_step < next.event.micro_step;
    const Event of = is_silent ? early.front() : next.event;
    // Only what handlers set is taken before an input: the micro-step belongs to an earlier step, of an unknown time.
    const bool is_earlier = from_outside(of) && of.micro_step > before + 2;
    if (before != 0 && (!continues || is_earlier) && of.micro_step > before + 1) engine_.step();
    if (over_ || engine_.micro_steps() != before) return;
    const bool is_timer = of.kind == Kind::input && !from_outside(of);
    if (continues && of.time == of.until && !is_timer) advance_to(of.until);
    engine_.step(of.until);
  }

  /// Sets the engine's time as a step does if inputs wait. The input itself may be missing, behind the end of the
  /// trace.
  void advance_to(Time until) {
    Counters& counters = *engine_.memory().counters;
    if (counters.now == until) return;
    counters.now = until;
    counters.serving = false;
  }

  // The trace.

  const RecordedEvent* ahead(std::size_t places) { return events_.ahead(places); }

  /// The next event; null: the trace ends here.
  const RecordedEvent* coming() {
    const RecordedEvent* const next = ahead(0);
    if (next == nullptr) {
      if (!lines_.problem().empty()) cannot_read(lines_.number(), lines_.problem());
    } else if (next->dropped != 0) {
      out_.dropped = next->dropped;
    } else if (next->problem.empty()) {
      return next;
    } else {
      differ(nullptr);
    }
    over_ = true;
    return nullptr;
  }

  static bool is(const RecordedEvent* recorded, Kind kind) {
    return recorded != nullptr && recorded->dropped == 0 && recorded->problem.empty() && recorded->event.kind == kind;
  }

  /// An impossible event at this micro-step, or one that the engine has left behind.
  static bool is_impossible(const RecordedEvent& recorded, std::uint64_t micro_step) {
    return recorded.is_impossible && recorded.was.event.micro_step <= micro_step;
  }

  // Inputs.

  /// States that were set before the first step.
  void give() {
    if (!is(ahead(0), Kind::begin)) return;
    for (std::size_t i = 1; is(ahead(i), Kind::given); ++i) {
      engine_.preset(ahead(i)->event.state, ahead(i)->event.value);
    }
  }

  static bool from_outside(const Event& event) {
    return event.kind == Kind::input && event.input >= Event::Input::request && event.input <= Event::Input::disable;
  }

  static Input record(const Event& event) {
    Input out;
    out.value = event.value;
    switch (event.input) {
    case Event::Input::request:
      out.kind = Input::Kind::request;
      out.thing = event.edge;
      out.set_level(event.level);
      break;
    case Event::Input::cancel:
      out.kind = Input::Kind::cancel;
      out.thing = event.edge;
      break;
    case Event::Input::set:
      out.kind = Input::Kind::set;
      out.thing = event.state;
      break;
    case Event::Input::fire:
      out.kind = Input::Kind::fire;
      out.thing = event.trigger;
      break;
    case Event::Input::enable:
    case Event::Input::disable:
      out.kind = event.input == Event::Input::enable ? Input::Kind::enable : Input::Kind::disable;
      out.thing = event.provider;
      break;
    default: break;
    }
    return out;
  }

  /// Posts the input that the next micro-step took, if it took one.
  void post() {
    std::size_t place = 0;
    while (is(ahead(place), Kind::begin) || is(ahead(place), Kind::given)) ++place;
    if (!is(ahead(place), Kind::input)) return;
    const std::uint64_t step = engine_.micro_steps() + 1;
    if (place != 0 && ahead(place)->event.until != ahead(0)->event.until) return; // of a later step than the first one
    std::vector<Input> records;
    for (; is(ahead(place), Kind::input) && from_outside(ahead(place)->event) && ahead(place)->event.micro_step == step;
         ++place) {
      records.push_back(record(ahead(place)->event));
      if (records.front().kind == Input::Kind::cancel || records.size() == most_records)
        break; // of all: each is also an event
    }
    for (std::size_t i = 0; i + 1 < records.size(); ++i) records[i].more = true;
    if (!records.empty()) inbox_.post(records);
  }

  // Answers of bodies and handlers.

  Bodies bodies() {
    Bodies out;
    out.self = this;
    out.run = [](void* self, Run& run) { return static_cast<Replayer*>(self)->run(run); };
    out.start = out.stop = [](void* self, Handling& handling) { static_cast<Replayer*>(self)->handle(handling); };
    return out;
  }

  Outcome run(Run& run) {
    while (!over_ && is(ahead(0), Kind::refused)) {
      const Event refused = ahead(0)->event;
      run.refuse(refused.state, refused.value);
    }
    if (over_ || !is(ahead(0), Kind::answer)) return run.keep();
    if (events_.leaves_out_too_much()) {
      differ(nullptr);
      return run.keep();
    }
    const Event answer = ahead(0)->event;
    for (std::size_t i = 1; const RecordedEvent* const each = ahead(i); ++i) {
      if (is_impossible(*each, engine_.micro_steps())) continue; // the replay ends there
      if (!each->problem.empty() || !ask(run, each->event)) break;
    }
    switch (answer.outcome) {
    case Outcome::Kind::pack: return run.pack(answer.pack);
    case Outcome::Kind::done: return run.done();
    case Outcome::Kind::failed: return run.fail();
    case Outcome::Kind::keep: return run.keep();
    case Outcome::Kind::fault: break;
    }
    return run.fault();
  }

  /// The requests of a run are between its answer and their effects. False: there are no more.
  bool ask(Run& run, const Event& event) {
    if (event.micro_step != engine_.micro_steps()) return false;
    const auto own = [&] {
      const Range edges = tables_.groups[run.group()].edges;
      return event.edge >= edges.begin && event.edge < edges.end;
    };
    switch (event.kind) {
    case Kind::assign:
      if (event.provider == nil) return false;
      run.set(event.state, event.value);
      return true;
    case Kind::ask:
    case Kind::keep:
      if (own()) run.request(event.edge, event.level, event.kind == Kind::keep);
      return true;
    case Kind::wait: run.wait(event.due == never ? never : event.due - event.time); return true;
    case Kind::set:
    case Kind::withdraw:
    case Kind::done:
    case Kind::failed: return true;
    default: return false;
    }
  }

  void handle(Handling& handling) {
    const auto own = [&](Kind kind) {
      return is(ahead(0), kind) && ahead(0)->event.group == handling.group() && ahead(0)->event.provider == nil;
    };
    while (!over_ && (own(Kind::assign) || own(Kind::refused))) {
      const Event event = ahead(0)->event;
      if (event.kind == Kind::assign)
        handling.set(event.state, event.value);
      else
        handling.refuse(event.state, event.value);
    }
    if (over_ || ahead(0) == nullptr) return;
    if (is_impossible(*ahead(0), engine_.micro_steps())) return differ(nullptr);
    if (own(Kind::fault)) handling.fault();
  }

  // Events of the engine.

  static void hear(void* self, const Event& event) { static_cast<Replayer*>(self)->tell(event); }

  void tell(const Event& event) {
    if (over_ || event.kind == Kind::exhausted) return;
    const RecordedEvent* recorded = ahead(0);
    if (recorded == nullptr || recorded->dropped != 0) {
      coming(); // the trace ended in the middle of a micro-step
      over_ = true;
      return;
    }
    if (is_impossible(*recorded, event.micro_step)) return differ(nullptr);
    line_.clear();
    append_event(event, names_, line_);
    if (line_ != events_.expected(*recorded) && !(events_.is_other() && events_.bring_forward(line_)))
      return differ(&event);
    recorded = ahead(0);
    if (recorded->is_impossible) return differ(nullptr);
    if (events_.is_other()) {
      const std::string damage = events_.damage_of(*recorded);
      if (!damage.empty()) return cannot_read(recorded->line, damage);
    }
    if (watch_ != nullptr) watch_->event(event, recorded->line);
    events_.pop();
    ++out_.events;
  }

  void cannot_read(std::size_t line, std::string problem) {
    over_ = true;
    out_.problem = std::move(problem);
    out_.problem_line = line;
  }

  /// It differs from what is recorded next. `event`: the engine's event; null: none.
  void differ(const Event* event) {
    over_ = true;
    const RecordedEvent& recorded = *ahead(0);
    const Event& was = recorded.was.event;
    if (const std::string damage = events_.damage_of(recorded); !damage.empty())
      return cannot_read(recorded.line, damage);
    Replayed::Difference found;
    found.event = recorded.line - 1; // behind the header
    found.line = recorded.line;
    found.time = was.time;
    found.recorded_line = recorded.text;
    if (event != nullptr) {
      found.replayed_line = line_;
      std::tie(found.recorded, found.replayed) = words_of_both(was, events_.recorded_names(), *event, names_);
      if (event->time != was.time) found.replayed += fmt::format(", at {} s", in_seconds(event->time));
    } else {
      found.recorded = words_of(was, events_.recorded_names());
      found.replayed = recorded.problem.empty() ? "nothing" : recorded.problem;
      found.is_impossible = recorded.is_impossible;
      found.help = recorded.help;
    }
    out_.difference = found;
  }

  TraceLines& lines_;
  ReplayWatch* const watch_;
  const director::Names names_;
  const Tables& tables_;
  RecordedEvents events_;
  Replayed out_;
  bool over_ = false;
  std::string line_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  EngineMemory memory_;
  Engine engine_;
};

} // namespace

Replayed replay(TraceLines& lines, const Model& model, const director::Names& names, ReplayWatch* watch,
                const director::Names* recorded) {
  return Replayer(lines, model, names, watch, recorded).play();
}

} // namespace director::compiler
