// Header: runtime/live/moment_lines.hpp. Test: tests/runtime/live/moment_lines_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/moment_lines.hpp"

#include "runtime/core/api/event_names.hpp"
#include "runtime/core/inspect/why.hpp"
#include "runtime/hosted/trace/event_text.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/hosted/trace/json_text.hpp"
#include "runtime/hosted/why_notes.hpp"

namespace director::live {

namespace {

class MomentLines {
public:
  MomentLines(const View& view, const Names& names, std::string& out)
      : v_(view),
        t_(*view.tables),
        n_(names),
        out_(out) {}

  void write() {
    for (Index row = 0; row < t_.states.size(); ++row) given(row);
    for (Index row = 0; row < t_.providers.size(); ++row) {
      if (v_.enabled[row] == 0) disabled(row);
    }
    for (Index row = 0; row < t_.groups.size(); ++row) controlled(row);
    for (Index row = 0; row < t_.groups.size(); ++row) pushed(row);
    for (Index row = 0; row < t_.edges.size(); ++row) queued(row);
  }

private:
  Event event(Event::Kind kind) const {
    Event out;
    out.kind = kind;
    out.time = out.until = v_.now;
    out.micro_step = v_.micro_step;
    return out;
  }
  void append(const Event& event) {
    append_event(event, n_, out_);
    out_ += '\n';
  }

  void given(Index state) {
    Event out = event(Event::Kind::given);
    out.state = state;
    out.value = v_.values[state].value;
    append(out);
  }
  void disabled(Index provider) {
    Event out = event(Event::Kind::input);
    out.input = Event::Input::disable;
    out.group = t_.providers[provider].group;
    out.provider = provider;
    append(out);
  }
  void controlled(Index group) {
    const Index holder = v_.holder(group);
    Event out = event(holder == nil ? Event::Kind::lose : Event::Kind::grant);
    out.group = group;
    out.edge = holder;
    out.provider = v_.assignment[group].active;
    append(out);
  }
  void pushed(Index group) {
    const Push& push = v_.assignment[group].push;
    if (push.edge == nil) return;
    Event out = event(Event::Kind::push);
    out.group = group;
    out.provider = push.provider;
    out.edge = push.edge;
    out.condition = push.condition;
    append(out);
  }
  void queued(Index edge) {
    const Queued queued = v_.queued(edge);
    if (v_.state(edge) != RunState::queued || queued.why == Why::none) return;
    Event out = event(Event::Kind::queue);
    out.group = t_.edges[edge].target;
    out.edge = edge;
    out.why = queued.why;
    out.condition = queued.condition;
    append(out);
  }

  const View& v_;
  const Tables& t_;
  const Names& n_;
  std::string& out_;
};

/// The edges by which a group is requested now, as a JSON array.
void append_requests(const View& view, Index group, const Names& names, std::string& out) {
  const Range edges = view.tables->groups[group].edges;
  out += '[';
  for (Index edge = edges.begin; edge < edges.end; ++edge) {
    if (!view.requested(edge)) continue;
    if (out.back() != '[') out += ',';
    json::append_text(names.edge(names.self, edge), out);
  }
  out += ']';
}

} // namespace

void append_moment(const View& view, const Names& names, std::string& out) { MomentLines(view, names, out).write(); }

void append_standing(const View& view, const Names& names, std::string& out) {
  const Tables& tables = *view.tables;
  char between = '[';
  const auto begin = [&] {
    out += between;
    between = ',';
    return json::Members(out);
  };
  for (Index group = 0; group < tables.groups.size(); ++group) {
    if (view.holder(group) == nil || view.granted(group)) continue;
    const bool stays = view.assignment[group].active != nil;
    json::Members line = begin();
    line.text("event", stays ? "stays" : "held").text("group", names.group(names.self, group));
    if (stays) line.key("asks"), append_requests(view, group, names, out);
    line.end();
  }
  for (Index group = 0; group < tables.groups.size(); ++group) {
    const GroupAssignment& now = view.assignment[group];
    if (!now.granted() || now.push.edge == nil || now.push.provider != now.active || now.in_force()) continue;
    begin().text("event", "without_effect").text("group", names.group(names.self, group)).end();
  }
  for (Index edge = 0; edge < tables.edges.size(); ++edge) {
    const Queued queued = view.queued(edge);
    if (view.state(edge) != RunState::queued || queued.why == Why::none) continue;
    json::Members line = begin();
    line.text("event", "waits").text("edge", names.edge(names.self, edge)).text("why", name_of(queued.why));
    if (queued.condition != nil) line.text("condition", names.condition(names.self, queued.condition));
    line.end();
  }
  if (between == '[') out += between;
  out += ']';
}

void append_why(const View& view, Index group, const Names& names, std::string& out) {
  const Because because = why(view, group);
  json::Members answer(out);
  answer.text("group", names.group(names.self, group)).text("kind", name_of(because.kind));
  answer.text("text", to_text(because, names));
  if (is_blocked(because)) {
    answer.key("held");
    json::Members held(out);
    held.text("group", names.group(names.self, because.group)).text("by", names.edge(names.self, because.holder)).end();
  }
  answer.key("notes");
  char between = '[';
  for (const WhyNote& note : why_notes(view, because, names)) {
    out += between;
    json::append_text(note.text, out);
    between = ',';
  }
  if (between == '[') out += between;
  out += ']';
  answer.end();
}

} // namespace director::live
