#pragma once
// SPDX-License-Identifier: MIT
// The bytes of a saved decision state: the numbers, their order, and their places in memory. A head, then a row for
// each row of the tables, each number with its lowest byte first, without gaps; then the data of tasks
// (api/saved_data.hpp). What follows from the tables or from the rest (places in the order, conditions, the tree of
// timers) is not saved but computed. Each row lists its numbers once: `each` calls visit(number, place) for all of
// them, to write, read or count bytes.

#include "runtime/core/engine/timers.hpp"

#include <type_traits>

namespace director {

class Engine;

namespace saved {

/// Increased when the format changes.
inline constexpr std::uint32_t format = 3;

/// A `D`, the format, the byte order of the data of tasks, and the bytes of an Index.
inline constexpr std::uint32_t version_word = 0x44000000U | format << 16 |
                                              (std::endian::native == std::endian::little ? 0U : 0x100U) |
                                              static_cast<std::uint32_t>(sizeof(Index));

/// The first byte in the check sum: behind HeadRow::version and the check sum itself.
inline constexpr std::size_t summed_from = 8;

/// The bits of State::component that last longer than a micro-step.
inline constexpr std::uint8_t component_bits = work::changed | work::unsettled | work::stale_matters;

/// The place of a number: a member of a row of an array, if that is there.
template <class T>
constexpr T* at(T* array, Index row) {
  return array == nullptr ? nullptr : array + row;
}
template <class T, class Member>
constexpr Member* at(T* array, Index row, Member T::*member) {
  return array == nullptr ? nullptr : &(array[row].*member);
}

struct HeadRow {
  std::uint32_t version = version_word;
  std::uint32_t check_sum = 0; ///< of all bytes that follow it
  std::uint32_t size = 0;      ///< of the whole state, in bytes
  std::uint64_t behaviour = 0; ///< the fingerprint of the behaviour
  Time now = 0, until = 0;     ///< these and the following as in Counters
  std::uint64_t micro_step = 0;
  std::uint8_t begun = 0, unsettled = 0, serving = 0;
  constexpr void each(auto visit, const State& s = {}) {
    visit(version), visit(check_sum), visit(size), visit(behaviour);
    visit(now, at(s.counters, 0, &Counters::now)), visit(until, at(s.counters, 0, &Counters::until));
    visit(micro_step, at(s.counters, 0, &Counters::micro_step)), visit(begun, at(s.counters, 0, &Counters::begun));
    visit(unsettled, at(s.counters, 0, &Counters::unsettled)), visit(serving, at(s.counters, 0, &Counters::serving));
  }
};

struct EdgeRow {
  std::uint64_t stamp = 0;
  Index level = nil;
  Why why = Why::none; ///< why it is queued
  Index condition = nil;
  constexpr void each(auto visit, const State& s = {}, Index e = 0) {
    visit(stamp, at(s.request, e, &Requested::stamp)), visit(level, at(s.request, e, &Requested::level));
    visit(why, at(s.queued, e, &Queued::why)), visit(condition, at(s.queued, e, &Queued::condition));
  }
};

struct GroupRow {
  Index holder = nil, active = nil, planned = nil;
  std::uint8_t flags = 0; ///< bits of `flag`
  Push push{};
  Time wait = never, every = never; ///< when these timers are due
  Index queue_place = nil;          ///< place in the run queue; in memory in State::reach
  std::uint8_t pending = 0, done = 0, stale_matters = 0;
  Index data_from = nil;
  Promised promised{};
  constexpr void each(auto visit, const State& s = {}, Index g = 0) {
    using Row = GroupAssignment;
    GroupAssignment* const last = s.last.group;
    Push* const pushes = last == nullptr ? nullptr : &last[g].push;
    visit(holder, at(last, g, &Row::holder)), visit(active, at(last, g, &Row::active));
    visit(planned, at(last, g, &Row::planned)), visit(flags, at(last, g, &Row::flags));
    visit(push.edge, at(pushes, 0, &Push::edge)), visit(push.provider, at(pushes, 0, &Push::provider));
    visit(push.condition, at(pushes, 0, &Push::condition));
    visit(wait, Timers::Timer{Timers::Kind::wait, g}), visit(every, Timers::Timer{Timers::Kind::every, g});
    visit(queue_place, at(s.reach, g)), visit(pending, at(s.run_queue, g, &RunQueueEntry::pending));
    visit(done, at(s.run_queue, g, &RunQueueEntry::done)),
        visit(stale_matters, at(s.run_queue, g, &RunQueueEntry::stale_matters));
    visit(data_from, at(s.data_from, g)), visit(promised.edge, at(s.promised, g, &Promised::edge));
    visit(promised.provider, at(s.promised, g, &Promised::provider));
  }
};

struct PlanRow {
  Index provider = nil;
  constexpr void each(auto visit, const State& s = {}, Index slot = 0) { visit(provider, at(s.last.plan, slot)); }
};

struct StateRow {
  std::int32_t value = unset;
  std::int32_t by_handler = unset;
  Time expiry = never;
  constexpr void each(auto visit, const State& s = {}, Index i = 0) {
    visit(value, at(s.values, i, &StateValue::value)), visit(by_handler, at(s.values, i, &StateValue::staged));
    visit(expiry, Timers::Timer{Timers::Kind::expiry, i});
  }
};

struct PromiseRow {
  Time due = never;
  constexpr void each(auto visit, const State& = {}, Index i = 0) {
    visit(due, Timers::Timer{Timers::Kind::promise, i});
  }
};

/// For a provider, whether it is enabled; for a listening slot, whether the trigger fired.
template <Bits* State::*array>
struct FlagRow {
  std::uint8_t set = 0;
  constexpr void each(auto visit, const State& s = {}, Index row = 0) { visit(set, at(s.*array, row)); }
};
using EnabledRow = FlagRow<&State::enabled>;
using FiredRow = FlagRow<&State::fired>;

struct ComponentRow {
  std::uint8_t bits = 0;  ///< of `work`
  Index work_place = nil; ///< place among the components to be decided next; in memory in State::reach
  constexpr void each(auto visit, const State& s = {}, Index c = 0) {
    visit(bits, at(s.component, c)), visit(work_place, at(s.reach, c));
  }
};

template <class Row>
constexpr std::size_t bytes_of() {
  std::size_t bytes = 0;
  Row{}.each([&](const auto& number, auto...) { bytes += sizeof number; });
  return bytes;
}

/// The places where the rows of each kind begin.
struct Layout {
  std::size_t edges = 0, groups = 0, plan = 0, states = 0, promises = 0, providers = 0, listens = 0, components = 0;
  std::size_t data = 0;

  /// Calls visit.operator()<Row>(where they begin, how many there are) for each kind, in order.
  static constexpr void each_kind(const Shape& n, auto visit) {
    visit.template operator()<EdgeRow>(&Layout::edges, n.edges);
    visit.template operator()<GroupRow>(&Layout::groups, n.groups);
    visit.template operator()<PlanRow>(&Layout::plan, n.plan_slots);
    visit.template operator()<StateRow>(&Layout::states, n.states);
    visit.template operator()<PromiseRow>(&Layout::promises, n.promises);
    visit.template operator()<EnabledRow>(&Layout::providers, n.providers);
    visit.template operator()<FiredRow>(&Layout::listens, n.listen_slots);
    visit.template operator()<ComponentRow>(&Layout::components, n.components);
  }

  constexpr explicit Layout(const Shape& n) {
    data = bytes_of<HeadRow>();
    each_kind(n, [this]<class Row>(std::size_t Layout::*kind, std::size_t count) {
      this->*kind = data;
      data += count * bytes_of<Row>();
    });
  }
};

template <class Row>
void write(std::byte* begin, std::size_t row, Row what) {
  std::byte* to = begin + row * bytes_of<Row>();
  what.each([&](const auto& number, auto...) {
    for (std::size_t i = 0; i < sizeof number; ++i)
      *to++ = static_cast<std::byte>(
          static_cast<std::make_unsigned_t<std::remove_cvref_t<decltype(number)>>>(number) >> 8 * i & 0xFF);
  });
}

template <class Row>
Row read(const std::byte* begin, std::size_t row) {
  Row out;
  const std::byte* from = begin + row * bytes_of<Row>();
  out.each([&](auto& number, auto...) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof number; ++i) bits |= std::to_integer<std::uint64_t>(*from++) << 8 * i;
    number = static_cast<std::remove_cvref_t<decltype(number)>>(bits);
  });
  return out;
}

/// Whether the bytes are a possible state: every number is one of an existing row and allowed there, and what the
/// engine follows (holders, plans, the queue) ends. Writes only scratch memory of the engine. saved_check.cpp
bool is_possible(const Engine& engine, const std::byte* from);

} // namespace saved
} // namespace director
