// Header: compiler/trace/lookup.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/lookup.hpp"

#include "runtime/core/api/event_names.hpp"

#include <fmt/format.h>

#include <limits>

namespace director::compiler {

Lookup::Rows Lookup::rows(const char* (*name)(const void*, Index), std::size_t count) const {
  Rows out;
  for (Index row = 0; row < count; ++row) out.emplace(name(names_.self, row), row);
  return out;
}

Lookup::Lookup(const director::Names& names)
    : names_(names),
      tables_(*names.tables),
      groups_(rows(names.group, tables_.groups.size())),
      edges_(rows(names.edge, tables_.edges.size())),
      states_(rows(names.state, tables_.states.size())),
      triggers_(rows(names.trigger, tables_.triggers.size())),
      conditions_(rows(names.condition, tables_.conditions.size())),
      providers_(tables_.groups.size()) {
  for (Index g = 0; g < tables_.groups.size(); ++g) {
    const Range own = tables_.groups[g].providers;
    for (Index p = own.begin; p != own.end; ++p) providers_[g].emplace(names.provider(names.self, p), p);
  }
}

namespace {

/// The enumerator with this name.
template <class Word>
bool find_word(Word& out, Word last, const std::string& name) {
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    out = static_cast<Word>(i);
    if (name == director::name_of(out)) return true;
  }
  return false;
}

} // namespace

class EventReading {
public:
  EventReading(const Lookup& lookup, const Json& line, bool reads_level)
      : l_(lookup),
        json_(line),
        reads_level_(reads_level) {}

  Lookup::Found read() {
    if (json_.is_object() && !json_["director_trace"].is_null())
      return fail("another recording begins here, and each is read by itself");
    if (!json_.is_object() || !json_["event"].is_text()) return fail("it names no event");
    if (json_["event"].as_text() == "dropped") return fail("`dropped` needs a `count` from 1");
    if (!find_word(e_.kind, Event::Kind::given, json_["event"].as_text()))
      return fail(fmt::format("no event is called `{}`", json_["event"].as_text()));
    for (std::size_t i = 0; i < json_.keys().size() && problem_.empty(); ++i) member(json_.keys()[i], json_.items()[i]);
    if (!problem_.empty()) return fail(problem_);
    if (json_["until"].is_null()) e_.until = e_.time;
    finish();
    if (problem_.empty()) whole();
    return problem_.empty() ? Lookup::Found{e_, {}} : fail(problem_);
  }

private:
  static Lookup::Found fail(std::string problem) { return {{}, std::move(problem)}; }

  void member(const std::string& key, const Json& value) {
    if (key == "t")
      e_.time = value.as_number();
    else if (key == "until")
      e_.until = value.as_number();
    else if (key == "n")
      e_.micro_step = static_cast<std::uint64_t>(value.as_number());
    else if (key == "input")
      word(key, value, e_.input, Event::Input::every);
    else if (key == "why")
      word(key, value, e_.why, Why::deferred);
    else if (key == "answer")
      word(key, value, e_.outcome, Outcome::Kind::fault);
    else if (key == "group")
      row(key, value, l_.groups_, e_.group);
    else if (key == "state")
      row(key, value, l_.states_, e_.state);
    else if (key == "trigger")
      row(key, value, l_.triggers_, e_.trigger);
    else if (key == "condition")
      row(key, value, l_.conditions_, e_.condition);
    else if (key == "pack")
      e_.pack = static_cast<std::uint16_t>(value.as_number());
    else if (key == "count")
      e_.count = static_cast<std::uint32_t>(value.as_number());
    else if (key == "due")
      e_.due = value.as_number();
    else if (key == "reasons")
      reasons(value);
    else if (key != "event" && key != "edge" && key != "from" && key != "provider" && key != "value" && key != "level")
      problem_ = fmt::format("unknown key `{}`", key);
  }

  template <class Word>
  void word(const std::string& key, const Json& value, Word& out, Word last) {
    if (!find_word(out, last, value.as_text())) problem_ = fmt::format("`{}` cannot be `{}`", key, value.as_text());
  }

  void row(std::string_view kind, const Json& value, const Lookup::Rows& rows, Index& out) {
    const auto found = rows.find(value.as_text());
    if (found == rows.end())
      problem_ = fmt::format("the behaviour has no {} called `{}`", kind, value.as_text());
    else
      out = found->second;
  }

  void reasons(const Json& value) {
    std::uint8_t bits = 0;
    for (const Json& each : value.items()) {
      for (const Reason reason : all_reasons) {
        if (each.as_text() == name_of(reason)) bits |= static_cast<std::uint8_t>(reason);
      }
    }
    e_.reasons = Reasons{bits};
  }

  /// Members that depend on others.
  void finish() {
    edge("edge", e_.edge);
    if (e_.group == nil && e_.edge < l_.tables_.edges.size()) e_.group = l_.tables_.edges[e_.edge].target;
    edge("from", e_.other);
    if (!json_["provider"].is_null()) {
      if (e_.group == nil)
        problem_ = "a provider without its group";
      else
        row("provider", json_["provider"], l_.providers_[e_.group], e_.provider);
    }
    if (problem_.empty() && !json_["value"].is_null()) value();
    const bool asks = e_.kind == Event::Kind::ask || e_.kind == Event::Kind::keep || e_.input == Event::Input::request;
    if (problem_.empty() && asks && reads_level_) level();
  }

  /// Members that a handler of the event assumes to be present.
  void whole() {
    using Kind = Event::Kind;
    const auto missing = [&](bool is, const char* what) {
      if (is && problem_.empty()) problem_ = fmt::format("`{}` without its {}", json_["event"].as_text(), what);
    };
    const auto is = [&](auto... kinds) { return ((e_.kind == kinds) || ...); };
    const bool in = e_.kind == Kind::input;
    missing(e_.group == nil &&
                is(Kind::run, Kind::start, Kind::stop, Kind::done, Kind::failed, Kind::grant, Kind::lose, Kind::push,
                   Kind::release, Kind::broken, Kind::fault, Kind::answer, Kind::assign, Kind::wait, Kind::refused),
            "group");
    missing(
        in && (e_.input == Event::Input::wait || e_.input == Event::Input::within || e_.input == Event::Input::every) &&
            e_.group == nil,
        "group");
    missing(e_.provider == nil && (is(Kind::run, Kind::push, Kind::broken, Kind::answer) ||
                                   (in && (e_.input == Event::Input::enable || e_.input == Event::Input::disable))),
            "provider");
    const bool is_request =
        is(Kind::queue, Kind::push, Kind::ask, Kind::keep, Kind::withdraw) || (in && e_.input == Event::Input::request);
    missing(is_request && e_.edge >= l_.tables_.edges.size(), "edge");
    missing(e_.state == nil && (is(Kind::set, Kind::refused, Kind::assign, Kind::given) ||
                                (in && (e_.input == Event::Input::set || e_.input == Event::Input::expire))),
            "state");
    missing(in && e_.input == Event::Input::fire && e_.trigger == nil, "trigger");
    missing(in && e_.input == Event::Input::none, "kind");
    missing(in && (e_.input == Event::Input::request || (e_.input == Event::Input::cancel && e_.edge != nil)) &&
                e_.edge >= l_.tables_.root_edges,
            "edge of root");
  }

  void edge(std::string_view key, Index& out) {
    const Json& value = json_[key];
    if (value.is_null() || !problem_.empty()) return;
    if (value.as_text() != "limbo") return row("task", value, l_.edges_, out);
    if (e_.group == nil)
      problem_ = "limbo without a group";
    else
      out = static_cast<Index>(l_.tables_.edges.size() + e_.group);
  }

  void value() {
    const Json& value = json_["value"];
    if (e_.state == nil) {
      problem_ = "a value without its state";
      return;
    }
    const bool has_names = *l_.names_.value(l_.names_.self, e_.state, 0) != 0;
    if (!value.is_text()) {
      e_.value = static_cast<std::int32_t>(value.as_number());
      if (has_names && e_.kind != Event::Kind::refused) // any number can be refused
        problem_ = fmt::format("`{}` cannot be {}", l_.names_.state(l_.names_.self, e_.state), value.as_number());
      return;
    }
    for (std::int32_t i = 0;; ++i) {
      const std::string_view name = l_.names_.value(l_.names_.self, e_.state, i);
      if (name.empty()) break;
      e_.value = i;
      if (name == value.as_text()) return;
    }
    problem_ = fmt::format("`{}` cannot be `{}`", l_.names_.state(l_.names_.self, e_.state), value.as_text());
  }

  void level() {
    const Json& value = json_["level"];
    if (e_.edge >= l_.tables_.edges.size()) return;
    const Range levels = l_.tables_.edges[e_.edge].levels;
    e_.level = levels.begin;
    if (value.is_null()) return;
    if (!value.is_text()) {
      const std::int64_t place = value.as_number();
      e_.level = static_cast<Index>(levels.begin + place);
      if (place < 0 || place >= levels.size()) problem_ = fmt::format("the request has no level {}", place);
      return;
    }
    while (e_.level != levels.end && value.as_text() != l_.names_.level(l_.names_.self, e_.level)) ++e_.level;
    if (e_.level == levels.end) problem_ = fmt::format("the request has no level `{}`", value.as_text());
  }

  const Lookup& l_;
  const Json& json_;
  const bool reads_level_;
  Event e_;
  std::string problem_;
};

Lookup::Found Lookup::event(const Json& line) const { return EventReading(*this, line, true).read(); }
Lookup::Found Lookup::event_without_level(const Json& line) const { return EventReading(*this, line, false).read(); }

} // namespace director::compiler
