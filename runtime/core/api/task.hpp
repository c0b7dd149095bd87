#pragma once
// SPDX-License-Identifier: MIT
// Requests in C++: a task type, derived from Task by generated code, with its data and its level. It may have members
// with any name of the specification, so everything here is found through Task itself, never by name.

#include "runtime/core/base/tables.hpp"

#include <type_traits>
#include <utility>

namespace director {

/// One of the named levels of a task; without a number, the first level that the requester declares for it.
template <class Task>
struct LevelOf {
  static constexpr std::uint8_t first = 255; ///< the first level that the requester has
  std::uint8_t number = first;               ///< the place of its name among those of the task's levels, or `first`
};

/// Base of a task type with data: `soccer::Walk{command}`, `soccer::Kick{command, soccer::Kick::urgent}`. The data move
/// between slots inside the Behaviour, where nothing may throw.
template <class Self, class Data = void>
struct Task {
  static_assert(std::is_object_v<Data> && !std::is_array_v<Data> && !std::is_const_v<Data> && !std::is_volatile_v<Data>,
                "the data of a task are stored by value: `data` must name a class, an enum, a number or a pointer");
  static_assert(
      requires { sizeof(Data); },
      "the data of a task are stored by value: the headers that `cpp` lists must define this type whole");
  static_assert(!std::is_abstract_v<Data>, "the data of a task are stored by value, and this class is abstract");
  // First, because a type whose destructor throws also counts as one whose move throws.
  static_assert(std::is_nothrow_destructible_v<Data>,
                "the data of a task are kept without heap: their destructor must be public and noexcept");
  static_assert(std::is_nothrow_move_constructible_v<Data>,
                "the data of a task are kept without heap: their move constructor must be noexcept");
  using data_type = Data; ///< the type named by `data` of the group
  /// The data of the request, and its level.
  explicit Task(Data given, LevelOf<Self> at = {}) : data(std::move(given)), level(at) {}
  template <class Other>
  explicit Task(LevelOf<Other>) = delete; ///< the data come first: `std::any` would take the level for them
  Data data;                              ///< moved by the request
  LevelOf<Self> level;                    ///< one that the requester declares
};

/// Base of a task type without data: `soccer::Look{}`, `soccer::Look{soccer::Look::urgent}`.
template <class Self>
struct Task<Self, void> {
  using data_type = void; ///< no data
  constexpr Task() = default;
  /// A request at this level.
  constexpr explicit Task(LevelOf<Self> at) : level(at) {}
  LevelOf<Self> level{}; ///< one that the requester declares
};

/// A request that keeps one of the same level as it is; made by keep().
template <class T>
struct Kept {
  T task; ///< requested if there is nothing to keep
};
/// Whether it is Kept.
template <class>
inline constexpr bool is_kept = false;
template <class T>
inline constexpr bool is_kept<Kept<T>> = true;

namespace detail {

template <class Self, class Data>
Task<Self, Data> base_of(const Task<Self, Data>&);

template <class T>
T task_in(const T&);
template <class T>
T task_in(const Kept<T>&);

} // namespace detail

template <class T>
concept TaskType = requires(const T& task) {
  detail::base_of(task);
};

/// Task<Self, Data> of a task type.
template <TaskType T>
using TaskBase = decltype(detail::base_of(std::declval<const T&>()));

template <TaskType T>
inline constexpr bool has_data = !std::is_void_v<typename TaskBase<T>::data_type>;

/// The task type of an argument of request(): `T`, or `Kept<T>`.
template <class Given>
using TaskOf = decltype(detail::task_in(std::declval<const Given&>()));

/// In a request: if the task is requested already at the same level, that stays as it is, and is no new task.
template <TaskType T>
Kept<T> keep(T task) {
  return {std::move(task)};
}

/// A type and its row.
template <class T, Index at>
struct Row {};

/// Types and their rows: `Table<Row<Walk, 3>, Row<Kick, 4>>`.
template <class... Rows>
struct Table : Rows... {
private:
  template <class T, Index at>
  static std::integral_constant<Index, at> find(const Row<T, at>&);

public:
  template <class T>
  static constexpr bool has = requires(const Table& table) {
    find<T>(table);
  };
  template <class T>
  static constexpr Index row = decltype(find<T>(std::declval<const Table&>()))::value;
};

} // namespace director
