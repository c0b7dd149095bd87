// Header: runtime/core/saved/saved_state.hpp. Test: tests/runtime/core/saved/saved_state_test.cpp,
// tests/property/saved_test.cpp. SPDX-License-Identifier: MIT

#include "runtime/core/saved/saved_state.hpp"

#include "runtime/core/engine/notes.hpp"

namespace director {

namespace saved {

namespace {

[[gnu::used]] const char* const uses = &part::timers; // bodies of the program that saved may have waited

/// The time that is as long after `to` as this one was after `from`, in the range of Time; the timer stays armed.
Time moved(Time time, Time from, Time to) {
  if (time == never) return never;
  const Time after = from == first_time ? detail::saturated_sum(detail::saturated_sum(time, never), 1)
                                        : detail::saturated_sum(time, -from);
  const Time out = detail::saturated_sum(to, after);
  return out > last_time ? last_time : out;
}

/// The memory of the engine, for rows that say where their numbers are. Without promises there is no array of them.
State memory_of(const Engine& engine) {
  State out = engine.memory();
  if (engine.tables().promises.empty()) out.promised = nullptr;
  return out;
}

/// Reads a number of a row from its place in memory, or the time of a timer.
struct FromMemory {
  const Timers& timers;
  template <class Number, class T>
  void operator()(Number& number, const T* place) const {
    if (place != nullptr) number = static_cast<Number>(*place);
  }
  void operator()(Time& due, Timers::Timer timer) const { due = timers.due(timer); }
  void operator()(auto&) const {} // it has no place in memory
};

} // namespace

std::uint32_t check_sum(std::span<const std::byte> bytes) {
  std::uint32_t sum = ~std::uint32_t{0};
  for (const std::byte each : bytes) {
    sum ^= std::to_integer<std::uint32_t>(each);
    for (int i = 0; i < 8; ++i) sum = sum >> 1 ^ (0xEDB88320U & (0U - (sum & 1U)));
  }
  return ~sum;
}

SaveResult write_decisions(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour, std::size_t size) {
  if (engine.inside()) return SaveResult::refused;
  if (engine.inputs_wait()) return SaveResult::inputs_wait;
  if (to.size() < size) return SaveResult::too_small;
  const State s = memory_of(engine);
  const Counters& c = *s.counters;
  const Timers timers(engine.tables(), s);
  const Shape n = Shape::of(engine.tables());
  HeadRow head{.size = static_cast<std::uint32_t>(size), .behaviour = behaviour};
  head.each(FromMemory{timers}, s);
  write(to.data(), 0, head);
  const Layout at(n);
  Layout::each_kind(n, [&]<class Row>(std::size_t Layout::*kind, std::size_t count) {
    if constexpr (std::is_same_v<Row, GroupRow> || std::is_same_v<Row, ComponentRow>)
      for (std::size_t g = 0; g < n.groups; ++g) s.reach[g] = nil;
    Index place = 0;
    if constexpr (std::is_same_v<Row, GroupRow>)
      for (Index g = c.queue_first; g != nil; g = s.run_queue[g].runs_before) s.reach[g] = place++;
    if constexpr (std::is_same_v<Row, ComponentRow>)
      for (; place < c.work_count; ++place) s.reach[s.work[place]] = place;
    for (std::size_t i = 0; i < count; ++i) {
      Row row;
      row.each(FromMemory{timers}, s, static_cast<Index>(i));
      if constexpr (std::is_same_v<Row, ComponentRow>) row.bits &= component_bits;
      write(to.data() + at.*kind, i, row);
    }
  });
  return SaveResult::saved;
}

void seal(std::span<std::byte> to) {
  auto row = read<HeadRow>(to.data(), 0);
  row.check_sum = check_sum(to.subspan(summed_from));
  write(to.data(), 0, row);
}

LoadResult can_load(const Engine& engine, std::span<const std::byte> from, std::uint64_t behaviour, std::size_t size) {
  if (engine.inside()) return LoadResult::refused;
  if (from.size() < bytes_of<HeadRow>()) return LoadResult::truncated;
  const auto row = read<HeadRow>(from.data(), 0);
  if (row.version != version_word) return LoadResult::other_version;
  if (row.size > from.size())
    return row.behaviour == behaviour && from.size() >= size ? LoadResult::damaged : LoadResult::truncated;
  if (row.size < bytes_of<HeadRow>() || row.check_sum != check_sum(from.subspan(summed_from, row.size - summed_from)))
    return LoadResult::damaged;
  if (row.behaviour != behaviour) return LoadResult::other_behaviour;
  return row.size == size && is_possible(engine, from.data()) ? LoadResult::loaded : LoadResult::impossible;
}

} // namespace saved

/// Loads a state that was checked into an engine.
class LoadedState {
public:
  LoadedState(Engine& engine, const std::byte* from, Time now)
      : engine_(engine),
        t_(engine.tables()),
        s_(saved::memory_of(engine)),
        head_(saved::read<saved::HeadRow>(from, 0)),
        now_(now > last_time ? last_time : now) {
    const std::uint64_t passes = engine_.passes_; // not reset, like all counters of what the engine did
    engine_.reset();
    engine_.passes_ = passes + 1; // so that a reader of both numbers sees that the state is another (View::passes)
    const Shape n = Shape::of(t_);
    const saved::Layout at(n);
    saved::Layout::each_kind(n, [&]<class Row>(std::size_t saved::Layout::*kind, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        saved::read<Row>(from + at.*kind, i).each([&](auto& number, auto place) { put(number, place); }, s_, Index(i));
      if constexpr (std::is_same_v<Row, saved::GroupRow>) queue();
    });
    states();
    components();
    head_.each([&](auto& number, auto... place) { (put(number, place), ...); }, s_);
    s_.counters->until = now_;
    s_.counters->now = saved::moved(head_.now, head_.until, now_);
    engine_.forget_trail();
  }

private:
  static void put(auto number, auto* place) {
    if (place != nullptr) *place = number;
  }
  void put(Time due, Timers::Timer timer) {
    if (due != never) engine_.timers_.arm(timer, saved::moved(due, head_.until, now_));
  }

  /// Fills the run queue from the places in State::reach.
  void queue() {
    Index count = 0;
    for (Index g = 0; g < t_.groups.size(); ++g) {
      if (s_.reach[g] == nil) continue;
      s_.touched[s_.reach[g]] = g;
      ++count;
    }
    for (Index i = 0; i < count; ++i) engine_.enter_queue(s_.touched[i]);
  }

  /// Called before `begun` is set, so that no component is marked for a new decision.
  void states() {
    for (Index i = 0; i < t_.states.size(); ++i) {
      engine_.update_conditions(i);
      if (s_.values[i].staged != unset) s_.staged[s_.counters->staged_count++] = i;
    }
  }

  /// Lists the components to be decided, whose places are in State::reach, and restores the order of each from holders
  /// and requests, which are those of the last pass.
  void components() {
    for (Index c = 0; c < t_.components.size(); ++c) {
      s_.component[c] |= work::reordered;
      if (s_.reach[c] != nil) {
        s_.work[s_.reach[c]] = c;
        ++s_.counters->work_count;
      }
      Index* const groups = s_.order + t_.components[c].order;
      Index& count = s_.order_count[c];
      for (const Index g : t_.list(t_.components[c].groups)) {
        if (s_.last[g].holder != nil) groups[count++] = g;
      }
      if (count > 1) arbitration::sort_by_holders(engine_.x_, {groups, count}, arbitration::Chains::previous); // a part
      for (Index i = 0; i < count; ++i) s_.place[groups[i]] = i;
    }
  }

  Engine& engine_;
  const Tables& t_;
  const State s_;
  saved::HeadRow head_;
  const Time now_;
};

void saved::read_decisions(Engine& engine, const std::byte* from, Time now) { LoadedState(engine, from, now); }

SaveResult save(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour) {
  const std::size_t size = saved_bytes(Shape::of(engine.tables()));
  const SaveResult result = saved::write_decisions(engine, to, behaviour, size);
  if (result == SaveResult::saved) saved::seal(to.first(size));
  return result;
}

LoadResult load(Engine& engine, std::span<const std::byte> from, Time now, std::uint64_t behaviour) {
  const LoadResult result = saved::can_load(engine, from, behaviour, saved_bytes(Shape::of(engine.tables())));
  if (result == LoadResult::loaded) saved::read_decisions(engine, from.data(), now);
  return result;
}

} // namespace director
