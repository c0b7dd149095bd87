#pragma once
// SPDX-License-Identifier: MIT
// What a request is in C++: a task type that generated code derives from Task, with its data and its level. Generated
// types may be called what the specification calls them, so everything here is found through Task itself, never by name
// in the derived type.

#include "runtime/core/base/tables.hpp"

#include <cstdint>
#include <type_traits>
#include <utility>

namespace director {

/// One of the named levels at which a task is requested. Made without a number it is the first that the requester has.
template <class Task>
struct LevelOf {
  static constexpr std::uint8_t first = 255; ///< the first level that the requester has
  std::uint8_t number = first;               ///< of the names that levels of this task have, or `first`
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
  // First, as what throws in its destructor counts as throwing when it moves.
  static_assert(std::is_nothrow_destructible_v<Data>,
                "the data of a task are kept without heap: their destructor must be public and noexcept");
  static_assert(std::is_nothrow_move_constructible_v<Data>,
                "the data of a task are kept without heap: their move constructor must be noexcept");
  using data_type = Data; ///< what `data` of the group names
  /// The data of the request, and its level.
  explicit Task(Data given, LevelOf<Self> at = {}) : data(std::move(given)), level(at) {}
  Data data;           ///< moved when it is requested
  LevelOf<Self> level; ///< one that the requester declares
};

/// Base of a task type without data: `soccer::Look{}`, `soccer::Look{soccer::Look::urgent}`.
template <class Self>
struct Task<Self, void> {
  using data_type = void; ///< it has none
  constexpr Task() = default;
  /// At this level.
  constexpr explicit Task(LevelOf<Self> at) : level(at) {}
  LevelOf<Self> level{}; ///< one that the requester declares
};

/// A request that leaves one of the same level as it is; made by keep().
template <class T>
struct Kept {
  T task; ///< what is requested where there is nothing to keep
};

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

/// The task type of what a body hands to a request: `T`, or `Kept<T>`.
template <class Given>
using TaskOf = decltype(detail::task_in(std::declval<const Given&>()));

/// In a request: if the task is requested already, at the same level, it stays as it is and is no new task.
template <TaskType T>
Kept<T> keep(T task) {
  return {std::move(task)};
}

/// A type and the row that it stands for.
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
