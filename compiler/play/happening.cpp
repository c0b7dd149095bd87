// Header: compiler/play/happening.hpp. Test: tests/compiler/play/happening_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/happening.hpp"

#include "compiler/base/json.hpp"
#include "dsl/source/colours.hpp"
#include "dsl/source/harmless.hpp"
#include "runtime/hosted/decision_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace director::compiler {

namespace {

std::string_view name_of(Happening::Kind kind) {
  switch (kind) {
  case Happening::Kind::input: return "input";
  case Happening::Kind::run: return "run";
  case Happening::Kind::start: return "start";
  case Happening::Kind::stop: return "stop";
  case Happening::Kind::done: return "done";
  case Happening::Kind::failed: return "failed";
  case Happening::Kind::broken: return "broken";
  case Happening::Kind::budget_exhausted: return "budget_exhausted";
  case Happening::Kind::queue: return "queue";
  case Happening::Kind::push: return "push";
  case Happening::Kind::release: return "release";
  case Happening::Kind::set: break;
  }
  return "set";
}

/// In runs and broken promises the name `default` is left out.
std::string short_name(const Happening& happening) {
  return happening.provider == "default" ? happening.group : happening.group + "." + happening.provider;
}

Json text(std::string_view value) { return Json::text(value); }

Json value_of(const Happening& happening) {
  if (!happening.value) return Json{};
  return happening.is_number ? Json::number(std::stoll(*happening.value)) : text(*happening.value);
}

std::string line_of(const Happening& happening) {
  switch (happening.kind) {
  case Happening::Kind::input: return "> " + happening.words;
  case Happening::Kind::run: return fmt::format("run {} {}", short_name(happening), fmt::join(happening.reasons, "+"));
  case Happening::Kind::broken: return "broken " + short_name(happening);
  case Happening::Kind::budget_exhausted: return "budget_exhausted";
  case Happening::Kind::queue: return fmt::format("queue {}>{}: {}", happening.from, happening.group, happening.words);
  case Happening::Kind::push:
    return fmt::format("push {}.{} for {}>{}", happening.group, happening.provider, happening.from, happening.words);
  case Happening::Kind::set:
    return happening.value ? fmt::format("set {} {}", happening.state, *happening.value) : "unset " + happening.state;
  case Happening::Kind::start:
  case Happening::Kind::stop:
  case Happening::Kind::done:
  case Happening::Kind::failed:
  case Happening::Kind::release: break;
  }
  return fmt::format("{} {}", name_of(happening.kind), happening.group);
}

std::string_view colour_of(Happening::Kind kind) {
  switch (kind) {
  case Happening::Kind::input: return dsl::colours::bold;
  case Happening::Kind::run:
  case Happening::Kind::start:
  case Happening::Kind::done: return dsl::colours::blue;
  case Happening::Kind::stop:
  case Happening::Kind::release: return dsl::colours::grey;
  case Happening::Kind::queue: return dsl::colours::red;
  case Happening::Kind::failed:
  case Happening::Kind::broken:
  case Happening::Kind::budget_exhausted: return dsl::colours::bold_red;
  case Happening::Kind::push: return dsl::colours::green;
  case Happening::Kind::set: break;
  }
  return dsl::colours::cyan;
}

} // namespace

std::string to_text(const Happening& happening, ShowTimes times, bool has_colours) {
  const std::string line = dsl::painted(dsl::harmless(line_of(happening)), colour_of(happening.kind), has_colours);
  if (times == ShowTimes::no) return line;
  std::array<char, 40> buffer{};
  return time_text(happening.time, buffer) + line;
}

std::string to_json(const Happening& happening, ShowTimes times) {
  Json json = Json::object({{"step", Json::number(happening.step)}});
  if (times == ShowTimes::yes) json.add("time_us", Json::number(happening.time));
  json.add("event", text(name_of(happening.kind)));
  switch (happening.kind) {
  case Happening::Kind::input: json.add("input", text(happening.words)); break;
  case Happening::Kind::run: {
    std::vector<Json> reasons;
    for (const std::string& reason : happening.reasons) reasons.push_back(text(reason));
    json.add("group", text(happening.group)).add("provider", text(happening.provider));
    json.add("reasons", Json::list(std::move(reasons)));
    break;
  }
  case Happening::Kind::broken:
    json.add("group", text(happening.group)).add("provider", text(happening.provider));
    break;
  case Happening::Kind::budget_exhausted: break;
  case Happening::Kind::queue:
    json.add("from", text(happening.from)).add("group", text(happening.group)).add("why", text(happening.words));
    break;
  case Happening::Kind::push:
    json.add("group", text(happening.group)).add("provider", text(happening.provider));
    json.add("for", text(happening.from + ">" + happening.words));
    break;
  case Happening::Kind::set: json.add("state", text(happening.state)).add("value", value_of(happening)); break;
  case Happening::Kind::start:
  case Happening::Kind::stop:
  case Happening::Kind::done:
  case Happening::Kind::failed:
  case Happening::Kind::release: json.add("group", text(happening.group)); break;
  }
  return to_line(json);
}

} // namespace director::compiler
