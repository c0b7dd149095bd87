#pragma once
// SPDX-License-Identifier: MIT
// The tasks that a body, or the program, may request, as types: generated code lists them, and a request that does not
// fit the list does not compile. At run time only the numbers of edges and levels are left.

#include "runtime/core/api/slots.hpp"

namespace director {

/// An entry of a pack, of `tasks` or of `roots`. `edge`: from the requester to the task. `rows`: rows of
/// Tables::levels, first that of the entry's first level, then one for each named level of the task (LevelOf::number),
/// nil if this entry does not have it.
template <class T, Index edge_row, Index... rows>
struct Member {
  using Task = T;
  static constexpr Index edge = edge_row;
  static constexpr Index row(LevelOf<T> level) {
    constexpr std::array<Index, sizeof...(rows)> all{rows...};
    const std::size_t at = level.number == LevelOf<T>::first ? 0U : level.number + 1U;
    return at < all.size() ? all[at] : nil;
  }
};

namespace detail {

template <class T, Index edge, Index... rows>
Member<T, edge, rows...> member_for(const Member<T, edge, rows...>&);

template <class Task, class... Given>
inline constexpr std::size_t times = (std::size_t{std::is_same_v<Task, TaskOf<Given>>} + ... + 0U);

} // namespace detail

template <class... Members>
struct Pack : Members... {
  static constexpr std::size_t size = sizeof...(Members);

  template <class Task>
  static constexpr bool has = (std::is_same_v<Task, typename Members::Task> || ...);

  /// Every given task is in the pack.
  template <class... Given>
  static constexpr bool takes = (has<TaskOf<Given>> && ...);

  /// No task is given twice.
  template <class... Given>
  static constexpr bool once = ((detail::times<TaskOf<Given>, Given...> == 1) && ...);

  /// The target of this edge is a task of the pack without data.
  static constexpr bool bare_at(Index edge) {
    return ((Members::edge == edge && !has_data<typename Members::Task>) || ...);
  }

  template <class Task>
  using For = decltype(detail::member_for<Task>(std::declval<const Pack&>()));
};

/// The named packs of a provider, in the order in which they are declared.
template <class... All>
struct Packs {
  template <class Task>
  static constexpr bool has = (All::template has<Task> || ...);
};

/// The task is among those given.
template <class Task, class... Given>
inline constexpr bool given = detail::times<Task, Given...> > 0;

/// Requests one task of a pack. False: the entry does not have this level.
template <class Pack, class Data, class Task>
bool ask_for(Run& run, Data& data, Task& request, bool kept = false) {
  using Member = typename Pack::template For<Task>;
  TaskBase<Task>& task = request;
  const Index row = Member::row(task.level);
  if (row == nil) return false;
  const bool anew = run.request(Member::edge, row, kept);
  if constexpr (has_data<Task>) {
    if (anew) data.template of<Task>().stage(std::move(task.data));
  }
  return true;
}

template <class Pack, class Data, class Task>
bool ask_for(Run& run, Data& data, Kept<Task>& request) {
  return ask_for<Pack>(run, data, request.task, true);
}

/// Requests all given tasks and no others, also none of an earlier call in the same run. A level that the requester
/// does not declare for a task is a fault of the body: nothing is requested, the observer is called, and step() returns
/// StepResult::fault.
template <class Pack, class Data, class... Given>
Outcome ask(Run& run, Data& data, std::uint16_t number, Given&... requests) {
  run.begin_pack();
  const bool declared = (ask_for<Pack>(run, data, requests) && ...);
  return declared ? run.pack(number) : run.fault();
}

} // namespace director
