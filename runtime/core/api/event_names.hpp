#pragma once
// SPDX-License-Identifier: MIT
// What the words of Director are called that stand in events: the same for every behaviour. What its own rows are
// called is in the namespace `names` of generated code.

#include "runtime/core/base/observer.hpp"

#include <array>
#include <bit>

namespace director {

namespace detail {

/// In the order in which the enumeration declares them; of what it does not declare, empty.
template <std::size_t count, class Row>
constexpr const char* name_in(const std::array<const char*, count>& names, Row row) {
  const auto at = static_cast<std::size_t>(row);
  return at < count ? names[at] : "";
}

} // namespace detail

constexpr const char* name_of(Event::Kind row) {
  constexpr std::array names{"input",  "run",       "start", "stop",    "done",     "failed",  "grant",
                             "lose",   "queue",     "push",  "release", "set",      "refused", "broken",
                             "fault",  "exhausted", "ask",   "keep",    "withdraw", "wait",    "lost",
                             "answer", "assign",    "begin", "given"};
  static_assert(names.size() == static_cast<std::size_t>(Event::Kind::given) + 1);
  return detail::name_in(names, row);
}

/// As steps of scenarios have it.
constexpr const char* name_of(Event::Input row) {
  constexpr std::array names{"none",    "request", "cancel", "set",    "trigger", "enable",
                             "disable", "expire",  "wait",   "within", "every"};
  static_assert(names.size() == static_cast<std::size_t>(Event::Input::every) + 1);
  return detail::name_in(names, row);
}

/// In the order of their bits.
constexpr const char* name_of(Reason reason) {
  constexpr std::array names{"new_task", "pushed", "subtask_done", "wait", "trigger", "started", "stopped"};
  return detail::name_in(names, std::countr_zero(static_cast<std::uint8_t>(reason)));
}

constexpr const char* name_of(Why row) {
  constexpr std::array names{"none", "blocked", "waiting", "outdated", "deferred"};
  static_assert(names.size() == static_cast<std::size_t>(Why::deferred) + 1);
  return detail::name_in(names, row);
}

/// As scripts of scenarios have it.
constexpr const char* name_of(Outcome::Kind row) {
  constexpr std::array names{"pack", "done", "failed", "keep", "fault"};
  static_assert(names.size() == static_cast<std::size_t>(Outcome::Kind::fault) + 1);
  return detail::name_in(names, row);
}

/// In the order in which a run lists them.
inline constexpr Reason all_reasons[] = {Reason::new_task, Reason::pushed,  Reason::subtask_done, Reason::wait,
                                         Reason::trigger,  Reason::started, Reason::stopped};

} // namespace director
