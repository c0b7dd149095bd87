#pragma once
// SPDX-License-Identifier: MIT
// What the words of Director are called that stand in events: the same for every behaviour. What its own rows are
// called is in the namespace `names` of generated code.

#include "runtime/core/base/observer.hpp"

namespace director {

constexpr const char* name_of(Event::Kind kind) {
  switch (kind) {
  case Event::Kind::input: return "input";
  case Event::Kind::run: return "run";
  case Event::Kind::start: return "start";
  case Event::Kind::stop: return "stop";
  case Event::Kind::done: return "done";
  case Event::Kind::failed: return "failed";
  case Event::Kind::grant: return "grant";
  case Event::Kind::lose: return "lose";
  case Event::Kind::queue: return "queue";
  case Event::Kind::push: return "push";
  case Event::Kind::release: return "release";
  case Event::Kind::set: return "set";
  case Event::Kind::refused: return "refused";
  case Event::Kind::broken: return "broken";
  case Event::Kind::fault: return "fault";
  case Event::Kind::exhausted: return "exhausted";
  case Event::Kind::ask: return "ask";
  case Event::Kind::keep: return "keep";
  case Event::Kind::withdraw: return "withdraw";
  case Event::Kind::wait: return "wait";
  case Event::Kind::lost: return "lost";
  case Event::Kind::answer: return "answer";
  case Event::Kind::assign: return "assign";
  case Event::Kind::begin: return "begin";
  case Event::Kind::given: return "given";
  }
  return "";
}

/// As steps of scenarios have it.
constexpr const char* name_of(Event::Input input) {
  switch (input) {
  case Event::Input::none: return "none";
  case Event::Input::request: return "request";
  case Event::Input::cancel: return "cancel";
  case Event::Input::set: return "set";
  case Event::Input::fire: return "trigger";
  case Event::Input::enable: return "enable";
  case Event::Input::disable: return "disable";
  case Event::Input::expire: return "expire";
  case Event::Input::wait: return "wait";
  case Event::Input::within: return "within";
  case Event::Input::every: return "every";
  }
  return "";
}

constexpr const char* name_of(Reason reason) {
  switch (reason) {
  case Reason::new_task: return "new_task";
  case Reason::pushed: return "pushed";
  case Reason::subtask_done: return "subtask_done";
  case Reason::wait: return "wait";
  case Reason::trigger: return "trigger";
  case Reason::started: return "started";
  case Reason::stopped: return "stopped";
  }
  return "";
}

constexpr const char* name_of(Why why) {
  switch (why) {
  case Why::none: return "none";
  case Why::blocked: return "blocked";
  case Why::waiting: return "waiting";
  case Why::outdated: return "outdated";
  case Why::deferred: return "deferred";
  }
  return "";
}

/// As scripts of scenarios have it.
constexpr const char* name_of(Outcome::Kind outcome) {
  switch (outcome) {
  case Outcome::Kind::pack: return "pack";
  case Outcome::Kind::done: return "done";
  case Outcome::Kind::failed: return "failed";
  case Outcome::Kind::keep: return "keep";
  case Outcome::Kind::fault: return "fault";
  }
  return "";
}

/// In the order in which a run lists them.
inline constexpr Reason all_reasons[] = {Reason::new_task, Reason::pushed,  Reason::subtask_done, Reason::wait,
                                         Reason::trigger,  Reason::started, Reason::stopped};

} // namespace director
