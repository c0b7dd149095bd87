#pragma once
// SPDX-License-Identifier: MIT
// A behaviour's state as bytes, with the data of its tasks, for behaviour.save() and load(). The state of the engine
// comes first (saved/saved_state.hpp), then, for each task with data, in the order of Facts::Groups, a slot for each
// edge that leads to it and that of its group: a byte that says whether it is full, then the bytes of the value.
// `Facts`: see program.hpp; and fingerprint(), a number that differs between behaviours.

#include "runtime/core/api/body.hpp"
#include "runtime/core/api/slots.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/core/saved/saved_state.hpp"

namespace director::saved {

/// Calls visit.template operator()<Task, row>() for each task with data.
template <class... Tasks, Index... rows, class Visit>
constexpr void each_task(Table<Row<Tasks, rows>...>, Visit&& visit) {
  const auto look = [&]<class Task, Index row>() {
    if constexpr (has_data<Task>) visit.template operator()<Task, row>();
  };
  (look.template operator()<Tasks, rows>(), ...);
}

/// `data` is a template parameter, so that `of` is looked up only if there is a task with data.
template <class Task>
constexpr auto& slots_of(auto& data) {
  return data.template of<Task>();
}

template <class Facts>
class Data {
  using Groups = typename Facts::Groups;
  template <class Task>
  using DataOf = typename TaskBase<Task>::data_type;

  /// The bytes of the slots of one task.
  template <class Task>
  static constexpr std::size_t bytes_of_slots() {
    static_assert(
        std::is_trivially_copyable_v<DataOf<Task>>,
        "a behaviour is saved as bytes, so the data of each of its tasks must be trivially copyable: no "
        "std::string, no std::vector, no copy constructor or destructor of its own (numbers, enums, arrays and "
        "structs of these are)");
    using Slots = std::remove_cvref_t<decltype(slots_of<Task>(std::declval<typename Facts::Data&>()))>;
    return Slots::lasting * Slot<DataOf<Task>>::saved_bytes;
  }

public:
  /// Calls visit(slot, its bytes) for each slot that lasts between steps, of all tasks.
  static void each_slot(auto& data, auto* place, auto visit) {
    each_task(Groups(), [&]<class Task, Index row>() {
      slots_of<Task>(data).each_lasting([&](auto& slot) {
        visit(slot, place);
        place += slot.saved_bytes;
      });
    });
  }

  static constexpr std::size_t bytes = [] {
    std::size_t all = 0;
    each_task(Groups(), [&]<class Task, Index row>() { all += bytes_of_slots<Task>(); });
    return all;
  }();

  /// The behaviour's fingerprint, with the ranges of its states and the sizes of its data.
  static std::uint64_t fingerprint() {
    std::uint64_t all = Facts::fingerprint();
    for (const Domain& domain : Facts::States::domains)
      all = mix(mix(all, static_cast<std::uint32_t>(domain.low)), static_cast<std::uint32_t>(domain.high));
    each_task(Groups(),
              [&]<class Task, Index row>() { all = mix(mix(all, sizeof(DataOf<Task>)), alignof(DataOf<Task>)); });
    return all;
  }

  /// Whether each live group and each request has data. `from`: a whole state whose other numbers are possible.
  static bool is_possible(const Tables& tables, const std::byte* from) {
    const Layout at(Shape::of(tables));
    const std::byte* slots = from + at.data;
    bool good = true;
    each_task(Groups(), [&]<class Task, Index group>() {
      constexpr std::size_t each = Slot<DataOf<Task>>::saved_bytes;
      constexpr std::size_t count = bytes_of_slots<Task>() / each;
      const auto full = [&](std::size_t slot) { return slots[slot * each] == std::byte{1}; };
      for (std::size_t i = 0; i < count; ++i) good = good && (full(i) || slots[i * each] == std::byte{0});
      const auto row = saved::read<GroupRow>(from + at.groups, group);
      if (row.active != nil) good = good && full(row.data_from == nil ? count - 1 : Facts::places[row.data_from]);
      for (const Index edge : tables.list(tables.groups[group].requesters)) {
        if (saved::read<EdgeRow>(from + at.edges, edge).level != nil) good = good && full(Facts::places[edge]);
      }
      slots += bytes_of_slots<Task>();
    });
    return good;
  }
};

/// Whether every value is declared by its state, or unset if the state may be unset.
template <class Facts>
bool values_are_declared(const Tables& tables, const std::byte* from) {
  const Layout at(Shape::of(tables));
  for (Index i = 0; i < tables.states.size(); ++i) {
    const StateVariable& state = tables.states[i];
    const auto row = saved::read<StateRow>(from + at.states, i);
    const bool may_lack = state.initial == unset || (state.expires != 0 && state.expires_to == unset);
    const Domain domain = Facts::States::domains[i];
    if (!domain.has(row.value) && !(row.value == unset && may_lack)) return false;
    if (!domain.has(row.by_handler) && row.by_handler != unset) return false;
  }
  return true;
}

/// The size of a saved state of the behaviour.
template <class Facts>
inline constexpr std::size_t bytes_of_behaviour = saved_bytes(Facts::shape) + Data<Facts>::bytes;

template <class Facts>
SaveResult save(const Engine& engine, typename Facts::Data& data, std::span<std::byte> to) {
  constexpr std::size_t size = bytes_of_behaviour<Facts>;
  const SaveResult result = write_decisions(engine, to, Data<Facts>::fingerprint(), size);
  if (result != SaveResult::saved) return result;
  Data<Facts>::each_slot(data, to.data() + saved_bytes(Facts::shape), [](auto& slot, std::byte* at) { slot.save(at); });
  seal(to.first(size));
  return result;
}

template <class Facts>
LoadResult load(Engine& engine, typename Facts::Data& data, std::span<const std::byte> from, Time now) {
  const LoadResult result = can_load(engine, from, Data<Facts>::fingerprint(), bytes_of_behaviour<Facts>);
  if (result != LoadResult::loaded) return result;
  const Tables& tables = engine.tables();
  if (!values_are_declared<Facts>(tables, from.data()) || !Data<Facts>::is_possible(tables, from.data()))
    return LoadResult::impossible;
  read_decisions(engine, from.data(), now);
  Data<Facts>::each_slot(data, from.data() + saved_bytes(Facts::shape),
                         [](auto& slot, const std::byte* at) { slot.load(at); });
  return result;
}

} // namespace director::saved
