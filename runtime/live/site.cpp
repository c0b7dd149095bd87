// Header: runtime/live/site.hpp. Test: tests/runtime/live/site_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/site.hpp"

#include "runtime/hosted/trace/json_text.hpp"
#include "runtime/live/access.hpp"
#include "runtime/live/moment_lines.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace director::live {

namespace {

Reply text_reply(int status, std::string text) {
  text += '\n';
  return {.status = status, .body = std::make_shared<const std::string>(std::move(text))};
}

Reply json(std::string text) {
  Reply out = text_reply(200, std::move(text));
  out.type = "application/json";
  return out;
}

/// Nothing: there is none with that name.
std::optional<std::string> parameter(const Request& request, const char* name) {
  const auto found = request.parameters.find(name);
  return found == request.parameters.end() ? std::nullopt : std::optional(found->second);
}

/// With the methods that there are for this address.
Reply not_allowed(const std::string& text, const char* methods) {
  Reply out = text_reply(405, text);
  out.headers.emplace_back("Allow", methods);
  return out;
}

bool is_command(std::string_view what) {
  return what == "request" || what == "cancel" || what == "cancel_all" || what == "set";
}

/// The parameters behind the `?`.
std::vector<std::string_view> parameters_of(std::string_view what) {
  if (what == "why") return {"group"};
  if (what == "request") return {"task", "level"};
  if (what == "cancel") return {"task"};
  if (what == "set") return {"state", "value"};
  return {};
}

/// Nothing: a parameter is unknown or repeated. To ignore it would change the meaning: all groups instead of one, or a
/// request at another level.
std::optional<Reply> misread(std::string_view what, const Request& request) {
  const std::vector<std::string_view> known = parameters_of(what);
  for (auto each = request.parameters.begin(); each != request.parameters.end(); ++each) {
    const std::string& name = each->first;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string there = known.empty() ? "; it takes none" : known.size() == 1 ? "; there is: " : "; there are: ";
      for (const std::string_view one : known) there.append(one == known.front() ? "" : ", ").append(one);
      return text_reply(400, std::string(what) + " has no parameter \"" + name + "\"" + there + ".");
    }
    if (request.parameters.count(name) > 1)
      return text_reply(400,
                        "The parameter " + name + " is given more than once: " + std::string(what) + " takes one.");
  }
  return std::nullopt;
}

template <class Rows>
std::string list_of(std::size_t count, Rows name) {
  std::string out;
  for (Index row = 0; row < count; ++row) out += (out.empty() ? "" : ", ") + std::string(name(row));
  return out;
}

} // namespace

Site::Site(const Names& names, std::optional<Page> page, std::string token, std::vector<std::string> own_names)
    : names_(names),
      token_(std::move(token)),
      own_names_(std::move(own_names)) {
  if (!page) return;
  page_ = std::make_shared<const std::string>(std::move(page->html));
  policy_ = std::move(page->policy);
}

Reply Site::answer(const Request& request, const Moment& moment, Time until) const {
  const auto checked = [&]() -> Reply {
    if (!is_own_host(request.host, own_names_))
      return text_reply(403, "This is not called \"" + request.host + "\": use the address that the program printed.");
    std::string_view path = request.path;
    if (path == "/favicon.ico") return {.status = 204};
    path.remove_prefix(path.starts_with('/') ? 1 : 0);
    const std::size_t end = path.find('/');
    if (!is_token(path.substr(0, end), token_))
      return text_reply(403, "The address needs the token that the program printed when it began: http://.../TOKEN/");
    if (end == std::string_view::npos) {
      Reply moved = text_reply(308, "The address ends with a slash.");
      moved.headers.emplace_back("Location", token_ + "/");
      return moved;
    }
    const std::string_view what = path.substr(end + 1);
    if (request.method == "GET" || request.method == "HEAD") return look(what, request, moment, until);
    if (request.method == "POST") return command(what, request);
    return is_command(what) ? not_allowed(request.method + " is not allowed here, only POST.", "POST")
                            : not_allowed(request.method + " is not allowed here, only GET and HEAD.", "GET, HEAD");
  };
  Reply out = checked();
  out.headers.emplace_back("Cache-Control", "no-store");
  out.headers.emplace_back("Referrer-Policy", "no-referrer");
  out.headers.emplace_back("X-Content-Type-Options", "nosniff");
  out.headers.emplace_back("Cross-Origin-Resource-Policy", "same-origin");
  out.headers.emplace_back("Content-Security-Policy",
                           out.type.starts_with("text/html") ? policy_ : "default-src 'none'; frame-ancestors 'none'");
  return out;
}

Reply Site::look(std::string_view what, const Request& request, const Moment& moment, Time until) const {
  if (what == "events" || what == "why") {
    if (std::optional<Reply> problem = misread(what, request)) return std::move(*problem);
    return what == "why" ? why(request, moment, until) : Reply{.type = "text/event-stream", .stream = true};
  }
  if (what.empty() && page_ != nullptr) return {.type = "text/html; charset=utf-8", .body = page_};
  if (what.empty())
    return text_reply(404,
                      "The program has no page: it gives LiveView `page` or `html`, what `directorc docs` wrote. What "
                      "happens is at events, and why at why.");
  if (is_command(what)) return not_allowed("A command is posted: curl -X POST ...", "POST");
  return text_reply(404,
                    "There is nothing here: the page is at the address that ends behind the token, what happens at "
                    "events, and why at why.");
}

Reply Site::why(const Request& request, const Moment& moment, Time until) const {
  if (moment.view.tables == nullptr)
    return text_reply(503,
                      "The program has shown nothing yet: it calls show(behaviour) of its LiveView after each step.");
  std::string out;
  json::Members answer(out);
  answer.number("t", until).number("n", moment.view.micro_step).key("groups");
  char between = '[';
  const std::optional<std::string> wanted = parameter(request, "group");
  for (Index row = 0; row < names_.tables->groups.size(); ++row) {
    const bool waits = director::why(moment.view, row).edge != nil && !moment.view.granted(row);
    if (wanted ? *wanted != names_.group(names_.self, row) : !waits) continue;
    out += between;
    append_why(moment.view, row, names_, out);
    between = ',';
  }
  if (between == '[' && wanted) return text_reply(404, "There is no group \"" + *wanted + "\".");
  if (between == '[') out += between;
  out += ']';
  answer.end();
  return json(std::move(out));
}

void Site::allow(Commands commands) {
  const std::lock_guard lock(mutex_);
  commands_ = std::move(commands);
}

Reply Site::command(std::string_view what, const Request& request) const {
  if (!is_own_origin(request.origin, request.host))
    return text_reply(403, "A command is not taken from the page of another server, " + request.origin + ".");
  if (request.has_body)
    return text_reply(413, "A command has no body: all stands in the address, as in request?task=NAME.");
  const std::lock_guard lock(mutex_);
  if (!commands_)
    return text_reply(
        403, "Commands are not allowed: the program has not called allow_commands(behaviour.post()) of its LiveView.");
  if (what.empty() || what == "events" || what == "why")
    return not_allowed("This is no command: POST is not allowed here, only GET and HEAD.", "GET, HEAD");
  if (!is_command(what))
    return text_reply(404, "There is no such command: there are request, cancel, cancel_all and set.");
  if (std::optional<Reply> problem = misread(what, request)) return std::move(*problem);
  if (what == "request") return request_task(request);
  if (what == "cancel") return cancel_task(request);
  if (what == "set") return set_state(request);
  return commands_.cancel_all() ? text_reply(202, "posted: cancel all")
                                : text_reply(503, "not posted: the inbox is full");
}

std::optional<Index> Site::root_edge(const Request& request, Reply& problem) const {
  const Tables& t = *names_.tables;
  const auto name = [&](Index edge) { return names_.group(names_.self, t.edges[edge].target); };
  const std::optional<std::string> task = parameter(request, "task");
  for (Index edge = 0; task && edge < t.root_edges; ++edge) {
    if (*task == name(edge)) return edge;
  }
  problem = text_reply(task ? 404 : 400,
                       (task ? "\"" + *task + "\" is not a root task" : std::string("The task is missing: task=NAME")) +
                           "; there are: " + list_of(t.root_edges, name) + ".");
  return std::nullopt;
}

Reply Site::request_task(const Request& request) const {
  Reply problem;
  const std::optional<Index> edge = root_edge(request, problem);
  if (!edge) return problem;
  const Range levels = names_.tables->edges[*edge].levels;
  std::vector<std::string_view> names;
  for (Index row = levels.begin; row < levels.end && names_.level != nullptr; ++row)
    names.emplace_back(names_.level(names_.self, row));
  Index level = levels.begin;
  const std::optional<std::string> wanted = parameter(request, "level");
  if (wanted) {
    const auto found = wanted->empty() ? names.end() : std::find(names.begin(), names.end(), *wanted);
    const std::string task = *parameter(request, "task");
    if (found == names.end() && (names.empty() || names.front().empty()))
      return text_reply(404, task + " has no named levels: it is requested without `level`.");
    if (found == names.end())
      return text_reply(404, "\"" + *wanted + "\" is not a level of " + task +
                                 "; there are: " + list_of(names.size(), [&](Index row) { return names[row]; }) + ".");
    level = static_cast<Index>(levels.begin + (found - names.begin()));
  }
  if (!commands_.request(*edge, level))
    return text_reply(409, "not posted: the task carries data, which only the program can give");
  return text_reply(202, "posted: request " + *parameter(request, "task") + (wanted ? " at " + *wanted : ""));
}

Reply Site::cancel_task(const Request& request) const {
  Reply problem;
  const std::optional<Index> edge = root_edge(request, problem);
  if (!edge) return problem;
  if (!commands_.cancel(*edge)) return text_reply(503, "not posted: the inbox is full");
  return text_reply(202, "posted: cancel " + *parameter(request, "task"));
}

Reply Site::set_state(const Request& request) const {
  const Tables& t = *names_.tables;
  const std::optional<std::string> state = parameter(request, "state"), value = parameter(request, "value");
  if (!state || !value) return text_reply(400, "A state and a value are needed: set?state=NAME&value=VALUE.");
  Index row = 0;
  while (row < t.states.size() && *state != names_.state(names_.self, row)) ++row;
  if (row == t.states.size()) return text_reply(404, "There is no state \"" + *state + "\".");
  if (!t.states[row].external)
    return text_reply(409,
                      "\"" + *state + "\" is set by the behaviour itself: only external states are set from outside.");
  std::int32_t number = 0;
  bool in_range = true;
  const bool named = *names_.value(names_.self, row, 0) != '\0';
  if (named) {
    while (*names_.value(names_.self, row, number) != '\0' && *value != names_.value(names_.self, row, number))
      ++number;
    if (*names_.value(names_.self, row, number) == '\0')
      return text_reply(404, "\"" + *value + "\" is no value of " + *state + ".");
  } else {
    const auto [end, error] = std::from_chars(value->data(), value->data() + value->size(), number);
    in_range = error != std::errc::result_out_of_range;
    if ((in_range && error != std::errc{}) || end != value->data() + value->size())
      return text_reply(400, "\"" + *value + "\" is not a whole number.");
  }
  if (!in_range || !commands_.set(row, number))
    return text_reply(409, "not posted: " + *value + " is not within the range of " + *state);
  return text_reply(202, "posted: set " + *state + " " + *value);
}

} // namespace director::live
