// Header: runtime/core/engine/saved_state.hpp. Test: tests/runtime/core/engine/saved_state_test.cpp,
// tests/property/saved_test.cpp. SPDX-License-Identifier: MIT

#include "runtime/core/engine/saved_state.hpp"

#include "runtime/core/base/duration.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/core/engine/saved_check.hpp"

namespace director {

namespace saved {

namespace {

constexpr std::uint8_t bit(bool set, std::uint8_t value) { return set ? value : std::uint8_t{0}; }

HeadRow head_of(const Engine& engine, std::size_t size, std::uint64_t behaviour) {
  const Counters& c = *engine.memory().counters;
  HeadRow out;
  out.size = static_cast<std::uint32_t>(size);
  out.behaviour = behaviour;
  out.now = c.now;
  out.until = c.until;
  out.micro_step = c.micro_step;
  out.flags = static_cast<std::uint8_t>(bit(c.begun, head::begun) | bit(c.unsettled, head::unsettled) |
                                        bit(c.handlers_set, head::handlers_set) | bit(c.serving, head::serving) |
                                        bit(c.quiet_until != first_time, head::rests));
  return out;
}

GroupRow group_of(const State& s, const Timers& timers, Index g) {
  const GroupAssignment& last = s.last[g];
  const RunQueueEntry& entry = s.run_queue[g];
  GroupRow out;
  out.holder = last.holder, out.active = last.active, out.planned = last.planned;
  out.flags = static_cast<std::uint8_t>(last.flags);
  out.push = last.push;
  out.wait = timers.due({Timers::Kind::wait, g});
  out.every = timers.due({Timers::Kind::every, g});
  out.pending = entry.pending, out.done = entry.done;
  out.counts = entry.counts;
  out.data_from = s.data_from[g];
  return out;
}

/// As long after `to` as it was after `from`, as far as a Time goes; a timer that is armed stays so.
Time moved(Time time, Time from, Time to) {
  if (time == never) return never;
  const Time after = from == first_time ? detail::saturated_sum(detail::saturated_sum(time, never), 1)
                                        : detail::saturated_sum(time, -from);
  const Time out = detail::saturated_sum(to, after);
  return out > last_time ? last_time : out;
}

} // namespace

std::uint32_t check_sum(std::span<const std::byte> bytes) {
  std::uint32_t sum = ~std::uint32_t{0};
  for (const std::byte each : bytes) {
    sum ^= std::to_integer<std::uint32_t>(each);
    for (int i = 0; i < 8; ++i) sum = sum >> 1 ^ (0xEDB88320U & (0U - (sum & 1U)));
  }
  return ~sum;
}

SaveResult can_save(const Engine& engine, std::size_t room, std::size_t needed) {
  if (engine.inside()) return SaveResult::refused;
  if (engine.inputs_wait()) return SaveResult::inputs_wait;
  return room < needed ? SaveResult::too_small : SaveResult::saved;
}

void write_decisions(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour) {
  const Tables& t = engine.tables();
  const State& s = engine.memory();
  const Timers timers(t, s);
  std::byte* const begin = to.data();
  const Layout at(Shape::of(t));
  write(begin, 0, head_of(engine, to.size(), behaviour));
  for (Index e = 0; e < t.edges.size(); ++e) {
    write(begin + at.edges, e,
          EdgeRow{s.request[e].stamp, s.request[e].level, static_cast<std::uint8_t>(s.queued[e].why),
                  s.queued[e].condition});
  }
  for (Index g = 0; g < t.groups.size(); ++g) {
    GroupRow row = group_of(s, timers, g);
    if (!t.promises.empty()) row.promised = s.promised[g];
    write(begin + at.groups, g, row);
  }
  Index place = 0;
  for (Index g = s.counters->queue_first; g != nil; g = s.run_queue[g].runs_before) {
    auto row = read<GroupRow>(begin + at.groups, g);
    row.queue_place = place++;
    write(begin + at.groups, g, row);
  }
  for (Index slot = 0; slot < t.plan_groups.size(); ++slot) write(begin + at.plan, slot, PlanRow{s.last.plan[slot]});
  for (Index i = 0; i < t.states.size(); ++i) {
    write(begin + at.states, i,
          StateRow{s.values[i].value, s.handler_values[i], timers.due({Timers::Kind::expiry, i})});
  }
  for (Index i = 0; i < t.promises.size(); ++i)
    write(begin + at.promises, i, PromiseRow{timers.due({Timers::Kind::promise, i})});
  for (Index p = 0; p < t.providers.size(); ++p) write(begin + at.providers, p, FlagRow{s.enabled[p]});
  for (Index slot = 0; slot < t.listened.size(); ++slot) write(begin + at.listens, slot, FlagRow{s.fired[slot]});
  for (Index c = 0; c < t.components.size(); ++c) {
    const auto bits = static_cast<std::uint8_t>(s.component[c] & component_bits);
    write(begin + at.components, c, ComponentRow{bits, nil});
  }
  for (Index i = 0; i < s.counters->work_count; ++i) {
    auto row = read<ComponentRow>(begin + at.components, s.work[i]);
    row.work_place = i;
    write(begin + at.components, s.work[i], row);
  }
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
  if (row.size > from.size()) return LoadResult::truncated;
  if (row.size < bytes_of<HeadRow>() || row.check_sum != check_sum(from.subspan(summed_from, row.size - summed_from)))
    return LoadResult::damaged;
  if (row.behaviour != behaviour) return LoadResult::other_behaviour;
  return row.size == size && is_possible(engine, from.data()) ? LoadResult::loaded : LoadResult::impossible;
}

} // namespace saved

/// Puts a state that was checked into an engine.
class LoadedState {
public:
  LoadedState(Engine& engine, const std::byte* from, Time now)
      : engine_(engine),
        t_(engine.tables()),
        s_(engine.memory()),
        from_(from),
        at_(Shape::of(t_)),
        head_(saved::read<saved::HeadRow>(from, 0)),
        now_(now > last_time ? last_time : now) {}

  void put() {
    const std::uint64_t passes = engine_.passes_; // counts on, as all that says what the engine did
    engine_.reset();
    engine_.passes_ = passes;
    states(); // before anything has begun, so that no component is to be decided for what they are
    requests();
    for (Index g = 0; g < t_.groups.size(); ++g) group(g);
    queue();
    for (Index slot = 0; slot < t_.plan_groups.size(); ++slot)
      s_.last.plan[slot] = saved::read<saved::PlanRow>(from_ + at_.plan, slot).provider;
    for (Index i = 0; i < t_.promises.size(); ++i)
      arm({Timers::Kind::promise, i}, saved::read<saved::PromiseRow>(from_ + at_.promises, i).due);
    for (Index p = 0; p < t_.providers.size(); ++p)
      s_.enabled[p] = saved::read<saved::FlagRow>(from_ + at_.providers, p).set;
    for (Index slot = 0; slot < t_.listened.size(); ++slot)
      s_.fired[slot] = saved::read<saved::FlagRow>(from_ + at_.listens, slot).set;
    components();
    counters();
    engine_.forget_trail();
  }

private:
  void arm(Timers::Timer timer, Time due) {
    if (due != never) engine_.timers_.arm(timer, saved::moved(due, head_.until, now_));
  }

  void states() {
    Counters& c = *s_.counters;
    for (Index i = 0; i < t_.states.size(); ++i) {
      const auto row = saved::read<saved::StateRow>(from_ + at_.states, i);
      engine_.preset(i, row.value);
      s_.handler_values[i] = row.by_handler;
      if (row.by_handler != unset) s_.handled[c.handled_count++] = i;
      arm({Timers::Kind::expiry, i}, row.expiry);
    }
  }

  void requests() {
    for (Index e = 0; e < t_.edges.size(); ++e) {
      const auto row = saved::read<saved::EdgeRow>(from_ + at_.edges, e);
      s_.request[e].stamp = row.stamp;
      s_.request[e].level = row.level;
      s_.queued[e] = {static_cast<Why>(row.why), row.condition};
    }
  }

  void group(Index g) {
    const auto row = saved::read<saved::GroupRow>(from_ + at_.groups, g);
    s_.last[g] = {row.holder, row.active, row.planned, row.flags, row.push};
    RunQueueEntry& entry = s_.run_queue[g];
    entry.counts = row.counts;
    entry.pending = row.pending;
    entry.done = row.done;
    if (row.wait != never) entry.flags |= group_flag::waits;
    if (row.queue_place != nil) s_.reach[row.queue_place] = g;
    s_.data_from[g] = row.data_from;
    if (!t_.promises.empty()) s_.promised[g] = row.promised;
    arm({Timers::Kind::wait, g}, row.wait);
    arm({Timers::Kind::every, g}, row.every);
  }

  /// Their places are in State::reach.
  void queue() {
    Index count = 0;
    for (Index g = 0; g < t_.groups.size(); ++g)
      count =
          static_cast<Index>(count + (saved::read<saved::GroupRow>(from_ + at_.groups, g).queue_place != nil ? 1 : 0));
    for (Index i = 0; i < count; ++i) engine_.queue().enter(s_.reach[i]);
  }

  void components() {
    for (Index c = 0; c < t_.components.size(); ++c) {
      const auto row = saved::read<saved::ComponentRow>(from_ + at_.components, c);
      s_.component[c] = static_cast<std::uint8_t>(row.bits | work::reordered);
      if (row.work_place != nil) {
        s_.component[c] |= work::listed;
        s_.work[row.work_place] = c;
        ++s_.counters->work_count;
      }
      order(c);
    }
  }

  /// Follows from who holds what, and from the requests: they are those of the last pass.
  void order(Index component) {
    const Component& row = t_.components[component];
    Index* const groups = s_.order + row.order;
    Index count = 0;
    for (const Index g : t_.list(row.groups)) {
      if (s_.last[g].holder != nil) groups[count++] = g;
    }
    arbitration::sort_by_holders(engine_.x_, {groups, count}, arbitration::Chains::previous);
    for (Index i = 0; i < count; ++i) s_.place[groups[i]] = i;
    s_.order_count[component] = count;
  }

  void counters() {
    Counters& c = *s_.counters;
    const auto is = [&](std::uint8_t bit) { return (head_.flags & bit) != 0; };
    c.until = now_;
    c.now = saved::moved(head_.now, head_.until, now_);
    c.micro_step = head_.micro_step;
    c.begun = is(saved::head::begun);
    c.unsettled = is(saved::head::unsettled);
    c.handlers_set = is(saved::head::handlers_set);
    c.serving = is(saved::head::serving);
    c.quiet_until = is(saved::head::rests) ? c.next_due : first_time;
  }

  Engine& engine_;
  const Tables& t_;
  const State& s_;
  const std::byte* from_;
  const saved::Layout at_;
  const saved::HeadRow head_;
  const Time now_;
};

void saved::read_decisions(Engine& engine, const std::byte* from, Time now) { LoadedState(engine, from, now).put(); }

SaveResult save(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour) {
  const std::size_t size = saved_bytes(Shape::of(engine.tables()));
  const SaveResult result = saved::can_save(engine, to.size(), size);
  if (result != SaveResult::saved) return result;
  saved::write_decisions(engine, to.first(size), behaviour);
  saved::seal(to.first(size));
  return result;
}

LoadResult load(Engine& engine, std::span<const std::byte> from, Time now, std::uint64_t behaviour) {
  const LoadResult result = saved::can_load(engine, from, behaviour, saved_bytes(Shape::of(engine.tables())));
  if (result == LoadResult::loaded) saved::read_decisions(engine, from.data(), now);
  return result;
}

} // namespace director
