// Header: behaviours/soccer/timeline/timeline.hpp. Test: tests/behaviours/soccer/timeline/timeline_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/timeline/timeline.hpp"

#include <algorithm>
#include <utility>

namespace {

using director::Event;
using director::Index;
using director::nil;
using director::Tables;

constexpr director::Time long_pause = 1'000'000; // after so long without a line, tell how many runs there were
constexpr std::size_t busiest = 4;               // of whom an aside tells

/// Groups that others need, and whatever is requested by such groups only: legs, and the servos below them.
std::vector<bool> resources_of(const Tables& tables) {
  std::vector<bool> resource(tables.groups.size());
  for (const director::Provider& provider : tables.providers)
    for (const Index edge : tables.list(provider.needs)) resource[tables.edges[edge].target] = true;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t group = 0; group < resource.size(); ++group) {
      const auto requesters = tables.list(tables.groups[group].requesters);
      const bool below = !requesters.empty() && std::all_of(requesters.begin(), requesters.end(), [&](Index edge) {
        return tables.edges[edge].requester != nil && resource[tables.edges[edge].requester];
      });
      if (!below || resource[group]) continue;
      resource[group] = more = true;
    }
  }
  return resource;
}

} // namespace

director::Observer Timeline::observer() {
  return {[](void* self, const Event& event) { static_cast<Timeline*>(self)->tell(event); }, this};
}

void Timeline::tell_of(const Tables& tables) {
  tables_ = tables;
  rows_.resize(tables.groups.size());
  const std::vector<bool> resource = resources_of(tables);
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].resource = resource[i];
  for (const director::StateVariable& state : tables.states) values_.push_back(state.initial);
  told_waiting_.resize(tables.edges.size());
}

void Timeline::finish() {
  flush();
  runs_so_far();
}

void Timeline::tell(const Event& event) {
  using Kind = Event::Kind;
  switch (event.kind) {
  case Kind::input: return input(event);
  case Kind::run: return run(event);
  case Kind::start: return line(event.time, "starts", group(event.group));
  case Kind::stop: return line(event.time, "stops", group(event.group));
  case Kind::done: return done(event);
  case Kind::failed: return done(event);
  case Kind::grant: return grant(event);
  case Kind::lose: return lose(event);
  case Kind::queue: return queue(event);
  case Kind::push: return push(event);
  case Kind::release:
  case Kind::ask:
  case Kind::keep:
  case Kind::withdraw:
  case Kind::wait:
  case Kind::answer:
  case Kind::assign:
  case Kind::begin:
  case Kind::given: return;
  case Kind::set: return set(event);
  case Kind::refused: return refused(event);
  case Kind::broken:
    return line(event.time, "broken", group(event.group), "promise of " + with_provider(event.provider));
  case Kind::fault: ++counts_.faults; return line(event.time, "fault", event.group == nil ? "" : group(event.group));
  case Kind::exhausted: ++counts_.faults; return line(event.time, "fault", "", "too many micro-steps in one step");
  case Kind::lost: ++counts_.faults; return line(event.time, "fault", "", std::to_string(event.count) + " inputs lost");
  }
}

void Timeline::input(const Event& event) {
  if (event.input == Event::Input::cancel && event.edge == nil) return; // of all: each is told
  const auto task = [&] { return group(tables_.edges[event.edge].target); };
  switch (event.input) {
  case Event::Input::set: return change(event, "sensed", "");
  case Event::Input::expire: expiring_ = event.state; return;
  case Event::Input::request: return line(event.time, "requested", task(), "by the program");
  case Event::Input::cancel: return line(event.time, "cancelled", task(), "by the program");
  default: return;
  }
}

void Timeline::run(const Event& event) {
  last_run_ = event;
  ++counts_.runs;
  ++runs_;
  Row& row = rows_[event.group];
  ++row.runs;
  if (event.reasons.has(director::Reason::new_task)) row.done = false;
  const bool pushed = event.reasons.has(director::Reason::pushed);
  if (row.resource || (row.provider == event.provider && !row.new_holder && !pushed)) return;
  std::string words = with_provider(event.provider);
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  if (pushed) add("pushed");
  if (const Index now = requester(row.edge); row.new_holder && now != nil)
    add(row.before == nil ? "for " + group(now) : "now for " + group(now) + ", no longer for " + group(row.before));
  row.provider = event.provider;
  row.new_holder = false;
  row.before = nil;
  line(event.time, "runs", group(event.group), words);
}

/// Only once for each task: a Done that is said again changes nothing.
void Timeline::done(const Event& event) {
  Row& row = rows_[event.group];
  if (row.resource || std::exchange(row.done, true)) return;
  line(event.time, event.kind == Event::Kind::done ? "done" : "failed", group(event.group));
}

void Timeline::grant(const Event& event) {
  Row& row = rows_[event.group];
  if (const Index old = requester(event.other); old != nil) row.before = old;
  row.edge = event.edge;
  const Index now = requester(event.edge);
  if (now == nil) return; // limbo: a stale group may request it again
  told_waiting_[event.edge] = 0;
  row.new_holder = true;
  if (row.before == now) row.before = nil;
  if (row.before == nil) return;
  if (!row.resource) {
    ++counts_.hand_overs;
    return;
  }
  const Index old = std::exchange(row.before, nil);
  const bool by_force = rows_[old].displaced == event.micro_step;
  join(event, by_force ? "takes" : "gets", group(now), group(event.group), " from " + group(old));
}

void Timeline::lose(const Event& event) {
  Row& row = rows_[event.group];
  const bool told = row.provider != nil && !row.resource;
  row = {.resource = row.resource, .displaced = row.displaced, .runs = row.runs};
  if (told && !tables_.groups[event.group].stop)
    join(event, "ends", "", group(event.group), ""); // else its stop is told
}

void Timeline::queue(const Event& event) {
  Row& row = rows_[tables_.edges[event.edge].target];
  if (row.edge == event.edge) row.displaced = event.micro_step;
  if (event.why != director::Why::waiting || std::exchange(told_waiting_[event.edge], 1) != 0) return;
  line(event.time, "waits", group(tables_.edges[event.edge].target),
       event.condition == nil ? "" : "for " + condition(event.condition));
}

void Timeline::push(const Event& event) {
  ++counts_.pushes;
  const std::string task = group(tables_.edges[event.edge].target);
  told_waiting_[event.edge] = 1;
  line(event.time, "pushed", group(event.group),
       "to " + with_provider(event.provider) + ", as " + task + " waits for " + condition(event.condition));
}

void Timeline::set(const Event& event) {
  if (std::exchange(expiring_, nil) == event.state) return change(event, "expired", "");
  const bool by_body = last_run_.group != nil && last_run_.micro_step == event.micro_step;
  change(event, "set", by_body ? ", by " + group(last_run_.group) : "");
}

void Timeline::change(const Event& event, std::string_view what, const std::string& by) {
  if (std::exchange(values_[event.state], event.value) == event.value) return;
  line(event.time, what, state(event.state), value(event) + by);
}

void Timeline::refused(const Event& event) {
  ++counts_.faults;
  line(event.time, "refused", state(event.state), value(event) + ", which " + group(event.group) + " does not declare");
}

Index Timeline::requester(Index edge) const {
  return edge == nil || edge >= tables_.edges.size() ? nil : tables_.edges[edge].requester;
}

/// Nothing for the only provider of a group.
std::string Timeline::with_provider(Index provider) const {
  const director::Group& group = tables_.groups[tables_.providers[provider].group];
  return group.providers.size() > 1 ? names_.provider(provider) : "";
}

void Timeline::join(const Event& event, std::string_view what, const std::string& who, const std::string& item,
                    const std::string& rest) {
  const bool same = joined_.what == what && joined_.who == who && joined_.rest == rest;
  if (!same || joined_.micro_step != event.micro_step) {
    flush();
    joined_ = {what, who, "", rest, event.micro_step, event.time};
  }
  joined_.list += (joined_.list.empty() ? "" : ", ") + item;
}

void Timeline::flush() {
  if (joined_.what.empty()) return;
  const Joined all = std::exchange(joined_, {});
  if (all.what == "takes") ++counts_.take_overs;
  if (all.who.empty()) return line(all.time, all.what, all.list);
  line(all.time, all.what, all.who, all.list + all.rest);
}

void Timeline::line(director::Time time, std::string_view what, std::string_view who, std::string_view words) {
  flush();
  std::string text = std::string(what) + " " + std::string(who) + " " + std::string(words);
  if (text == last_text_) return; // step after step, done after done
  last_text_ = std::move(text);
  if (time - last_line_ >= long_pause) runs_so_far();
  last_line_ = time;
  page_.line(time, what, who, words);
}

void Timeline::runs_so_far() {
  if (runs_ == 0) return;
  std::vector<Index> busy;
  for (Index i = 0; i < rows_.size(); ++i)
    if (rows_[i].runs > 0) busy.push_back(i);
  std::sort(busy.begin(), busy.end(),
            [&](Index a, Index b) { return std::pair(-rows_[a].runs, a) < std::pair(-rows_[b].runs, b); });
  std::string words = std::to_string(runs_) + " runs: ";
  for (std::size_t i = 0; i < busy.size() && i < busiest; ++i)
    words += (i == 0 ? "" : ", ") + group(busy[i]) + " " + std::to_string(rows_[busy[i]].runs);
  page_.aside(words + (busy.size() > busiest ? ", ..." : ""));
  runs_ = 0;
  for (Row& row : rows_) row.runs = 0;
}
