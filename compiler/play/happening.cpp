// Door: compiler/play/happening.hpp. Test: tests/compiler/play/happening_test.cpp.
#include "compiler/play/happening.hpp"

#include "compiler/emit/json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace director::compiler {

namespace {

using Kind = Happening::Kind;

std::string_view name_of(Kind kind) {
  switch (kind) {
  case Kind::input: return "input";
  case Kind::run: return "run";
  case Kind::start: return "start";
  case Kind::stop: return "stop";
  case Kind::done: return "done";
  case Kind::failed: return "failed";
  case Kind::broken: return "broken";
  case Kind::budget_exhausted: return "budget_exhausted";
  case Kind::queue: return "queue";
  case Kind::push: return "push";
  case Kind::release: return "release";
  case Kind::set: break;
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

} // namespace

std::string to_text(const Happening& happening) {
  switch (happening.kind) {
  case Kind::input: return "> " + happening.words;
  case Kind::run: return fmt::format("run {} {}", short_name(happening), fmt::join(happening.reasons, "+"));
  case Kind::broken: return "broken " + short_name(happening);
  case Kind::budget_exhausted: return "budget_exhausted";
  case Kind::queue: return fmt::format("queue {}>{}: {}", happening.from, happening.group, happening.words);
  case Kind::push:
    return fmt::format("push {}.{} for {}>{}", happening.group, happening.provider, happening.from, happening.words);
  case Kind::set:
    return happening.value ? fmt::format("set {} {}", happening.state, *happening.value) : "unset " + happening.state;
  case Kind::start:
  case Kind::stop:
  case Kind::done:
  case Kind::failed:
  case Kind::release: break;
  }
  return fmt::format("{} {}", name_of(happening.kind), happening.group);
}

std::string to_json(const Happening& happening) {
  Json json = Json::object({{"step", Json::number(happening.step)}, {"event", text(name_of(happening.kind))}});
  switch (happening.kind) {
  case Kind::input: json.add("input", text(happening.words)); break;
  case Kind::run: {
    std::vector<Json> reasons;
    for (const std::string& reason : happening.reasons) reasons.push_back(text(reason));
    json.add("group", text(happening.group)).add("provider", text(happening.provider));
    json.add("reasons", Json::list(std::move(reasons)));
    break;
  }
  case Kind::broken: json.add("group", text(happening.group)).add("provider", text(happening.provider)); break;
  case Kind::budget_exhausted: break;
  case Kind::queue:
    json.add("from", text(happening.from)).add("group", text(happening.group)).add("why", text(happening.words));
    break;
  case Kind::push:
    json.add("group", text(happening.group)).add("provider", text(happening.provider));
    json.add("for", text(happening.from + ">" + happening.words));
    break;
  case Kind::set: json.add("state", text(happening.state)).add("value", value_of(happening)); break;
  case Kind::start:
  case Kind::stop:
  case Kind::done:
  case Kind::failed:
  case Kind::release: json.add("group", text(happening.group)); break;
  }
  return to_line(json);
}

} // namespace director::compiler
