#pragma once
// SPDX-License-Identifier: MIT
// The names of enumerators in events. Those of a behaviour's rows are in the namespace `names` of generated code.

#include "runtime/core/base/observer.hpp"

#include <array>
#include <bit>

/// @file
/// The names of enumerators in events.

namespace director {

namespace detail {

/// The name at this place of an enumeration that ends with `last`; empty behind it.
template <std::size_t last, std::size_t count>
constexpr const char* name_in(const std::array<const char*, count>& names, std::size_t at) {
  static_assert(count == last + 1);
  return at < count ? names[at] : "";
}

} // namespace detail

/// `run`, `start`, ...
constexpr const char* name_of(Event::Kind row) {
  constexpr std::array names{"input",  "run",       "start", "stop",    "done",     "failed",  "grant",
                             "lose",   "queue",     "push",  "release", "set",      "refused", "broken",
                             "fault",  "exhausted", "ask",   "keep",    "withdraw", "wait",    "lost",
                             "answer", "assign",    "begin", "given"};
  return detail::name_in<std::size_t(Event::Kind::given)>(names, std::size_t(row));
}

/// The word in the steps of scenarios.
constexpr const char* name_of(Event::Input row) {
  constexpr std::array names{"none",    "request", "cancel", "set",    "trigger", "enable",
                             "disable", "expire",  "wait",   "within", "every"};
  return detail::name_in<std::size_t(Event::Input::every)>(names, std::size_t(row));
}

/// The names are in the order of the bits.
constexpr const char* name_of(Reason reason) {
  constexpr std::array names{"new_task", "pushed", "subtask_done", "wait", "trigger", "started", "stopped"};
  constexpr auto bit_of = [](Reason row) { return std::size_t(std::countr_zero(std::uint8_t(row))); };
  return detail::name_in<bit_of(Reason::stopped)>(names, bit_of(reason));
}

/// `blocked`, `waiting`, ...
constexpr const char* name_of(Why row) {
  constexpr std::array names{"none", "blocked", "waiting", "outdated", "deferred"};
  return detail::name_in<std::size_t(Why::deferred)>(names, std::size_t(row));
}

/// The word in the scripts of scenarios.
constexpr const char* name_of(Outcome::Kind row) {
  constexpr std::array names{"pack", "done", "failed", "keep", "fault"};
  return detail::name_in<std::size_t(Outcome::Kind::fault)>(names, std::size_t(row));
}

/// All reasons, in the order in which a run lists them. Hidden: g++ gives such data one address in a process, and so
/// never unloads a shared library with it.
[[gnu::visibility("hidden")]] inline constexpr Reason all_reasons[] = {
    Reason::new_task, Reason::pushed,  Reason::subtask_done, Reason::wait,
    Reason::trigger,  Reason::started, Reason::stopped};

} // namespace director
