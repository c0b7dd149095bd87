#pragma once
// SPDX-License-Identifier: MIT
// The bytes of a saved decision state: what is written, in which order. A head, then a row for each row of the tables,
// each number with its lowest byte first, without gaps; then the data of tasks (api/saved_data.hpp). What follows from
// the tables or from the rest (places in the order, conditions, the tree of timers) is not written but made again.

#include "runtime/core/base/state.hpp"
#include "runtime/core/base/tables.hpp"

#include <bit>
#include <type_traits>

namespace director::saved {

/// Grows when what is written changes.
inline constexpr std::uint32_t format = 1;

/// A `D`, the format, whether the data of tasks have their lowest byte first, and the bytes of an Index.
inline constexpr std::uint32_t version_word = 0x44000000U | format << 16 |
                                              (std::endian::native == std::endian::little ? 0U : 0x100U) |
                                              static_cast<std::uint32_t>(sizeof(Index));

/// Bits of HeadRow::flags.
namespace head {
inline constexpr std::uint8_t begun = 1, unsettled = 2, handlers_set = 4, serving = 8;
inline constexpr std::uint8_t rests = 16; ///< nothing is to be done without an input before the first timer
inline constexpr std::uint8_t all = 31;
} // namespace head

struct HeadRow {
  std::uint32_t version = version_word;
  std::uint32_t check_sum = 0; ///< of all that follows it
  std::uint32_t size = 0;      ///< in bytes, of all
  std::uint64_t behaviour = 0; ///< its fingerprint
  Time now = 0, until = 0;     ///< as in Counters
  std::uint64_t micro_step = 0;
  std::uint8_t flags = 0;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(version), visit(check_sum), visit(size), visit(behaviour), visit(now), visit(until), visit(micro_step),
        visit(flags);
  }
};

struct EdgeRow {
  std::uint64_t stamp = 0;
  Index level = nil;
  std::uint8_t why = 0; ///< why it is queued
  Index condition = nil;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(stamp), visit(level), visit(why), visit(condition);
  }
};

struct GroupRow {
  Index holder = nil, active = nil, planned = nil;
  std::uint8_t flags = 0; ///< bits of `flag`
  Push push{};
  Time wait = never, every = never; ///< when these timers are due
  Index queue_place = nil;          ///< in the queue of runs
  std::uint8_t pending = 0, done = 0, counts = 0;
  Index data_from = nil;
  Promised promised{};
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(holder), visit(active), visit(planned), visit(flags);
    visit(push.edge), visit(push.provider), visit(push.condition);
    visit(wait), visit(every), visit(queue_place), visit(pending), visit(done), visit(counts);
    visit(data_from), visit(promised.edge), visit(promised.provider);
  }
};

struct PlanRow {
  Index provider = nil;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(provider);
  }
};

struct StateRow {
  std::int32_t value = unset;
  std::int32_t by_handler = unset;
  Time expiry = never;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(value), visit(by_handler), visit(expiry);
  }
};

struct PromiseRow {
  Time due = never;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(due);
  }
};

/// Of a provider: whether it is enabled. Of a listening slot: whether the trigger fired.
struct FlagRow {
  std::uint8_t set = 0;
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(set);
  }
};

struct ComponentRow {
  std::uint8_t bits = 0;  ///< of `work`, without those that last no longer than a micro-step
  Index work_place = nil; ///< among those that are to be decided next
  template <class Visit>
  constexpr void each(Visit visit) {
    visit(bits), visit(work_place);
  }
};

template <class Row>
constexpr std::size_t bytes_of() {
  std::size_t bytes = 0;
  Row{}.each([&](const auto& member) { bytes += sizeof member; });
  return bytes;
}

/// Where the rows of each kind begin.
struct Layout {
  constexpr explicit Layout(const Shape& n)
      : edges(bytes_of<HeadRow>()),
        groups(edges + n.edges * bytes_of<EdgeRow>()),
        plan(groups + n.groups * bytes_of<GroupRow>()),
        states(plan + n.plan_slots * bytes_of<PlanRow>()),
        promises(states + n.states * bytes_of<StateRow>()),
        providers(promises + n.promises * bytes_of<PromiseRow>()),
        listens(providers + n.providers * bytes_of<FlagRow>()),
        components(listens + n.listen_slots * bytes_of<FlagRow>()),
        data(components + n.components * bytes_of<ComponentRow>()) {}
  std::size_t edges, groups, plan, states, promises, providers, listens, components, data;
};

template <class Number>
void put(std::byte*& at, Number number) {
  auto bits = static_cast<std::make_unsigned_t<Number>>(number);
  for (std::size_t i = 0; i < sizeof number; ++i) *at++ = static_cast<std::byte>(bits >> 8 * i & 0xFF);
}

template <class Number>
void get(const std::byte*& at, Number& number) {
  std::make_unsigned_t<Number> bits = 0;
  for (std::size_t i = 0; i < sizeof number; ++i)
    bits = static_cast<std::make_unsigned_t<Number>>(
        bits | std::make_unsigned_t<Number>{std::to_integer<std::uint8_t>(*at++)} << 8 * i);
  number = static_cast<Number>(bits);
}

template <class Row>
void write(std::byte* begin, std::size_t row, Row what) {
  std::byte* at = begin + row * bytes_of<Row>();
  what.each([&](auto& member) { put(at, member); });
}

template <class Row>
Row read(const std::byte* begin, std::size_t row) {
  Row out;
  const std::byte* at = begin + row * bytes_of<Row>();
  out.each([&](auto& member) { get(at, member); });
  return out;
}

} // namespace director::saved
