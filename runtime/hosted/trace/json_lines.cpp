// Header: runtime/hosted/trace/json_lines.hpp. Test: tests/runtime/hosted/trace/json_lines_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/hosted/trace/json_lines.hpp"

#include "runtime/core/api/event_names.hpp"
#include "runtime/hosted/trace/fingerprint.hpp"
#include "runtime/hosted/trace/json_text.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

#include <utility>

namespace director {

namespace {

using json::append_text, json::Members;

class EventLine {
public:
  EventLine(const Event& event, const Names& names, std::string& out)
      : e_(event),
        n_(names),
        t_(*names.tables),
        out_(out),
        line_(out) {}

  void write() {
    line_.number("t", e_.time);
    if (e_.until != e_.time) line_.number("until", e_.until);
    line_.number("n", e_.micro_step).text("event", name_of(e_.kind));
    if (e_.input != Event::Input::none) line_.text("input", name_of(e_.input));
    const bool implied = e_.edge < t_.edges.size() && t_.edges[e_.edge].target == e_.group;
    if (e_.group != nil && !implied) line_.text("group", n_.group(n_.self, e_.group));
    if (e_.edge != nil) edge("edge", e_.edge);
    if (e_.other != nil) edge("from", e_.other);
    if (e_.provider != nil) line_.text("provider", n_.provider(n_.self, e_.provider));
    if (e_.reasons.bits() != 0) reasons();
    if (e_.why != Why::none) line_.text("why", name_of(e_.why));
    if (e_.condition != nil) line_.text("condition", n_.condition(n_.self, e_.condition));
    if (e_.state != nil) state();
    if (e_.trigger != nil) line_.text("trigger", n_.trigger(n_.self, e_.trigger));
    if (e_.level != nil) level();
    if (e_.kind == Event::Kind::answer) line_.text("answer", name_of(e_.outcome));
    if (e_.pack != 0) line_.number("pack", e_.pack);
    if (e_.due != never) line_.number("due", e_.due);
    if (e_.count != 0) line_.number("count", e_.count);
    line_.end();
  }

private:
  void edge(std::string_view key, Index row) {
    line_.text(key, row < t_.edges.size() ? n_.edge(n_.self, row) : "limbo");
  }

  void reasons() {
    line_.key("reasons");
    char between = '[';
    for (const Reason reason : all_reasons) {
      if (!e_.reasons.has(reason)) continue;
      out_ += between;
      append_text(name_of(reason), out_);
      between = ',';
    }
    out_ += ']';
  }

  void state() {
    line_.text("state", n_.state(n_.self, e_.state));
    if (e_.kind == Event::Kind::input && e_.input != Event::Input::set) return; // it expires
    if (e_.value == unset) {
      line_.key("value");
      out_ += "null";
      return;
    }
    const std::string_view name = n_.value(n_.self, e_.state, e_.value);
    if (name.empty())
      line_.number("value", e_.value);
    else
      line_.text("value", name);
  }

  /// Writes a level by its name if that is unique among the edge's, else by its place; the first level is not written.
  void level() {
    const Range levels = t_.edges[e_.edge].levels;
    if (e_.level == levels.begin) return;
    const std::string_view name = n_.level(n_.self, e_.level);
    Index first = levels.begin;
    while (name != n_.level(n_.self, first)) ++first;
    if (!name.empty() && first == e_.level)
      line_.text("level", name);
    else
      line_.number("level", e_.level - levels.begin);
  }

  const Event& e_;
  const Names& n_;
  const Tables& t_;
  std::string& out_;
  Members line_;
};

class JsonLines final : public TraceFormat {
public:
  JsonLines(const Names& names, std::string file) : names_(names), file_(std::move(file)) {}

  void begin(std::string& out) override {
    append_header(names_, file_, out);
    out += '\n';
  }
  void event(const Event& event, std::string& out) override {
    append_event(event, names_, out);
    out += '\n';
  }
  void dropped(std::uint64_t count, std::string& out) override {
    append_dropped(count, out);
    out += '\n';
  }

private:
  const Names names_;
  const std::string file_;
};

/// Writes nothing if the state is unset at the beginning.
void initial_value(const Names& names, Index state, Members& row) {
  const std::int32_t initial = names.tables->states[state].initial;
  if (initial == unset) return;
  const std::string_view name = names.value(names.self, state, initial);
  if (name.empty())
    row.number("initial", initial);
  else
    row.text("initial", name);
}

void level_use(const Names& names, const LevelUse& use, std::string& out) {
  const Level& level = names.tables->levels[use.level];
  Members row(out);
  row.text("edge", names.edge(names.self, use.edge));
  if (use.provider != nil) row.text("provider", names.provider(names.self, use.provider));
  if (use.pack != 0) row.number("pack", use.pack);
  if (*use.pack_name != '\0') row.text("pack_name", use.pack_name);
  if (*use.name != '\0') row.text("name", use.name);
  row.number("level", use.level - names.tables->edges[use.edge].levels.begin).number("priority", level.priority);
  if (level.optional) row.flag("optional");
  if (level.apart) row.flag("apart");
  row.end();
}

} // namespace

void append_event(const Event& event, const Names& names, std::string& out) { EventLine(event, names, out).write(); }

void append_header(const Names& names, std::string_view file, std::string& out) {
  const Tables& t = *names.tables;
  const auto list = [&](std::size_t count, const auto& each) {
    out += '[';
    for (Index row = 0; row < count; ++row) {
      if (row != 0) out += ',';
      each(row);
    }
    out += ']';
  };
  Members header(out);
  header.number("director_trace", trace_version).text("behaviour", names.behaviour == nullptr ? "" : names.behaviour);
  if (!file.empty()) header.text("file", file);
  header.text("fingerprint", fingerprint_text(names));
  header.key("groups");
  list(t.groups.size(), [&](Index group) {
    Members row(out);
    row.text("name", names.group(names.self, group)).key("providers");
    const Range providers = t.groups[group].providers;
    list(providers.size(),
         [&](Index i) { append_text(names.provider(names.self, static_cast<Index>(providers.begin + i)), out); });
    row.end();
  });
  header.key("edges");
  list(t.edges.size(), [&](Index edge) {
    Members row(out);
    row.text("name", names.edge(names.self, edge)).text("target", names.group(names.self, t.edges[edge].target));
    row.key("levels");
    const Range levels = t.edges[edge].levels;
    list(levels.size(),
         [&](Index i) { append_text(names.level(names.self, static_cast<Index>(levels.begin + i)), out); });
    row.end();
  });
  header.key("states");
  list(t.states.size(), [&](Index state) {
    Members row(out);
    row.text("name", names.state(names.self, state));
    if (*names.value(names.self, state, 0) != '\0') {
      row.key("values");
      out += '[';
      for (std::int32_t value = 0; *names.value(names.self, state, value) != '\0'; ++value) {
        if (value != 0) out += ',';
        append_text(names.value(names.self, state, value), out);
      }
      out += ']';
    }
    initial_value(names, state, row);
    row.end();
  });
  header.key("triggers");
  list(t.triggers.size(), [&](Index row) { append_text(names.trigger(names.self, row), out); });
  header.key("conditions");
  list(t.conditions.size(), [&](Index row) { append_text(names.condition(names.self, row), out); });
  if (!names.level_uses.empty()) {
    header.key("level_uses"); // the last one: traces of earlier programs are without it
    list(names.level_uses.size(), [&](Index row) { level_use(names, names.level_uses[row], out); });
  }
  header.end();
}

void append_dropped(std::uint64_t count, std::string& out) {
  Members(out).text("event", "dropped").number("count", count).end();
}

std::unique_ptr<TraceFormat> json_lines(const Names& names, std::string file) {
  return std::make_unique<JsonLines>(names, std::move(file));
}

} // namespace director
