// SPDX-License-Identifier: MIT
// A behaviour that is saved and loaded into a new engine continues as if it had not been interrupted: random behaviours
// and scenarios, interrupted at random micro-steps, at the same time and at others. And bytes that were not saved do no
// harm.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_LONG   set: 100,000 cuts, and ten times as many bytes
#include "runtime/core/saved/saved_rows.hpp"
#include "tests/property/compare.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <iterator>
#include <string>

namespace {

using namespace director;
using namespace director::property;
using director::tests::cases_of;
using director::tests::from_environment;

constexpr std::size_t numbers_apart = director::tests::is_slow ? 10 : 1; ///< sanitizers find their errors in few
constexpr std::size_t most_micro_steps = 10'000;                         ///< of one step of a scenario

std::unique_ptr<Compiled> compiled(std::uint64_t seed) {
  const Documents documents = generate(seed);
  CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
  REQUIRE(result.compiled != nullptr);
  return std::move(result.compiled);
}

/// Calls between(run) after each micro-step, also at rest.
template <class Between>
void play(const Compiled& compiled, EngineRun& run, Between between) {
  for (const compiler::ScenarioStep& step : compiled.scenario.steps) {
    run.begin_step(step);
    for (std::size_t i = 0; i < most_micro_steps; ++i) {
      const bool more = run.micro_step();
      between(run);
      if (!more) break;
    }
  }
}

std::vector<std::byte> decision_bytes(const Engine& engine) {
  const std::byte* const begin = reinterpret_cast<const std::byte*>(engine.memory().counters); // the first array
  return {begin, begin + State::decision_bytes(Shape::of(engine.tables()))};
}

struct Cuts {
  std::uint64_t made = 0, with_inputs = 0, in_the_middle = 0;
};

/// The part of the decision state that a decision depends on is the same. What is computed again may differ: edges of
/// root are linked in the order of declaration until the next pass sorts them.
bool same_but_for_links(const Engine& engine, std::vector<std::byte> before) {
  const State& s = engine.memory();
  const Shape n = Shape::of(engine.tables());
  std::vector<std::byte> after = decision_bytes(engine);
  const auto leave_out = [&](const auto* begin, std::size_t count) {
    const auto at = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(begin) -
                                             reinterpret_cast<const std::byte*>(s.counters));
    for (auto* each : {&before, &after}) std::memset(each->data() + at, 0, count * sizeof *begin);
  };
  leave_out(&s.counters->quiet_until, 1); // the next step finds out whether there is anything to do
  leave_out(s.first_root, n.components);
  leave_out(s.next_root, n.edges);
  leave_out(s.component, n.components); // work::reordered
  leave_out(s.staged, n.states);        // in order of declaration
  leave_out(s.work, n.components);      // rows not in use
  leave_out(s.order, n.groups);         // likewise
  leave_out(s.place, n.groups);         // of groups that are not held
  return before == after;
}

std::string difference(const EngineRun& whole, const EngineRun& other) {
  const auto numbers = [](const auto& events, auto at) {
    std::string out;
    if (at != events.end())
      for (const std::int64_t number : *at) out += " " + std::to_string(number);
    return out;
  };
  const auto &wanted = whole.events(), &got = other.events();
  const auto [a, b] = std::mismatch(wanted.begin(), wanted.end(), got.begin(), got.end());
  const auto [c, d] =
      std::mismatch(whole.trace().begin(), whole.trace().end(), other.trace().begin(), other.trace().end());
  if (a == wanted.end() && b == got.end() && c == whole.trace().end() && d == other.trace().end()) return {};
  return "the traces part at event " + std::to_string(a - wanted.begin()) + " of " + std::to_string(wanted.size()) +
         "," + numbers(wanted, a) + " and" + numbers(got, b) + ", line `" + (c == whole.trace().end() ? "" : *c) +
         "` and `" + (d == other.trace().end() ? "" : *d) + "`";
}

void cut_at_random(std::uint64_t seed, Cuts& cuts) {
  const auto documents = compiled(seed);
  const bool leap = manner_of(seed) == Manner::in_leaps;
  EngineRun whole(*documents, leap), cut(*documents, leap);
  play(*documents, whole, [](EngineRun&) {});
  Random random(seed);
  const bool moves = random.chance(0.5);
  std::vector<std::byte> bytes, again;
  play(*documents, cut, [&](EngineRun& run) {
    if (!random.chance(0.3)) return;
    const std::vector<std::byte> before = decision_bytes(run.engine());
    const bool rests = run.engine().memory().counters->quiet_until != first_time;
    const Time later = moves ? static_cast<Time>(random.below(2'000'000'000)) - 1'000'000'000 : 0;
    const SaveResult result = run.cut(later, bytes);
    if (result == SaveResult::inputs_wait) {
      ++cuts.with_inputs;
      return;
    }
    REQUIRE(result == SaveResult::saved);
    ++cuts.made;
    cuts.in_the_middle += rests ? 0 : 1;
    if (later != 0) return;
    if (!same_but_for_links(run.engine(), before)) FAIL("DIRECTOR_SEED=" << seed << ": what decides is another");
    REQUIRE(run.cut(0, again) == SaveResult::saved);
    if (bytes != again) FAIL("DIRECTOR_SEED=" << seed << ": saved again it is another");
  });
  if (const std::string found = difference(whole, cut); !found.empty()) FAIL("DIRECTOR_SEED=" << seed << ": " << found);
}

TEST_CASE(
    "a behaviour that is saved at random and loaded into a new engine has the trace of one that was not interrupted") {
  const std::uint64_t wanted = cases_of({.usual = 3'000, .slow = 1'000, .whole = 100'000});
  Cuts cuts;
  std::uint64_t seed = from_environment<std::uint64_t>("DIRECTOR_SEED", 1), cases = 0;
  for (; cuts.made < wanted; ++seed, ++cases) {
    watch(seed);
    cut_at_random(seed, cuts);
    stop_watching();
  }
  std::cout << cuts.made << " cuts in " << cases << " scenarios, " << cuts.in_the_middle
            << " of them with something left to do; not cut as inputs waited: " << cuts.with_inputs << "\n";
  CHECK(cuts.in_the_middle > wanted / 4);
  CHECK(cuts.with_inputs > 0);
}

/// The reason why each edge is queued.
std::vector<Queued> reasons(const Engine& engine) {
  std::vector<Queued> out(engine.tables().edges.size());
  for (Index e = 0; e < out.size(); ++e) out[e] = engine.queued(e);
  return out;
}

TEST_CASE("an engine that decides everything again in each micro-step decides the same, for the same reasons") {
  const std::uint64_t first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1),
                      cases = cases_of({.usual = 1'000, .slow = 300, .whole = 30'000});
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    watch(seed);
    const auto documents = compiled(seed);
    const bool leap = manner_of(seed) == Manner::in_leaps;
    EngineRun whole(*documents, leap), again(*documents, leap);
    std::vector<std::vector<Queued>> after_each;
    play(*documents, whole, [&](EngineRun& run) { after_each.push_back(reasons(run.engine())); });
    std::size_t at = 0;
    play(*documents, again, [&](EngineRun& run) {
      if (at < after_each.size() && reasons(run.engine()) != after_each[at])
        FAIL("DIRECTOR_SEED=" << seed << ": queued for another reason after micro-step "
                              << run.engine().memory().counters->micro_step);
      ++at;
      run.forget_trail();
    });
    if (const std::string found = difference(whole, again); !found.empty())
      FAIL("DIRECTOR_SEED=" << seed << ": " << found);
    stop_watching();
  }
}

/// A number in a kind of row.
struct Member {
  const char* kind;
  std::size_t place; ///< its place among the members, in the order of `each`
  void (*forget)(std::vector<std::byte>& bytes, const Shape& shape, std::size_t place);
};

/// Gives it its default value in all rows.
template <class Row, std::size_t saved::Layout::*begin, std::size_t Shape::*count>
void forget(std::vector<std::byte>& bytes, const Shape& shape, std::size_t place) {
  std::byte* const rows = bytes.data() + saved::Layout(shape).*begin;
  for (std::size_t i = 0; i < shape.*count; ++i) {
    auto row = saved::read<Row>(rows, i);
    std::int64_t plain = 0;
    std::size_t at = 0;
    Row{}.each([&](const auto& member, auto...) {
      if (at++ == place) plain = static_cast<std::int64_t>(member);
    });
    at = 0;
    row.each([&](auto& member, auto...) {
      if (at++ == place) member = static_cast<std::remove_reference_t<decltype(member)>>(plain);
    });
    saved::write(rows, i, row);
  }
}

void forget_in_head(std::vector<std::byte>& bytes, const Shape&, std::size_t place) {
  auto row = saved::read<saved::HeadRow>(bytes.data(), 0);
  std::size_t at = 0;
  row.each([&](auto& member, auto...) {
    if (at++ == place) member = 0;
  });
  saved::write(bytes.data(), 0, row);
}

template <class Row>
void add_members(std::vector<Member>& out, const char* kind, decltype(Member::forget) forget, std::size_t first = 0) {
  std::size_t count = 0;
  Row{}.each([&](const auto&, auto...) { ++count; });
  for (std::size_t place = first; place < count; ++place) out.push_back({kind, place, forget});
}

std::vector<Member> members() {
  using namespace saved;
  std::vector<Member> out;
  add_members<HeadRow>(out, "head", forget_in_head, 4); // behind version, sum, size and fingerprint
  add_members<EdgeRow>(out, "edge", forget<EdgeRow, &Layout::edges, &Shape::edges>);
  add_members<GroupRow>(out, "group", forget<GroupRow, &Layout::groups, &Shape::groups>);
  add_members<PlanRow>(out, "plan", forget<PlanRow, &Layout::plan, &Shape::plan_slots>);
  add_members<StateRow>(out, "state", forget<StateRow, &Layout::states, &Shape::states>);
  add_members<PromiseRow>(out, "promise", forget<PromiseRow, &Layout::promises, &Shape::promises>);
  add_members<EnabledRow>(out, "provider", forget<EnabledRow, &Layout::providers, &Shape::providers>);
  add_members<FiredRow>(out, "listening slot", forget<FiredRow, &Layout::listens, &Shape::listen_slots>);
  add_members<ComponentRow>(out, "component", forget<ComponentRow, &Layout::components, &Shape::components>);
  return out;
}

/// Whether the state is refused, or the trace differs, if this number is not saved.
bool counts(const Member& member, std::uint64_t seed) {
  const auto documents = compiled(seed);
  const bool leap = manner_of(seed) == Manner::in_leaps;
  EngineRun whole(*documents, leap), cut(*documents, leap);
  play(*documents, whole, [](EngineRun&) {});
  Random random(seed);
  bool refused = false;
  std::vector<std::byte> bytes;
  try {
    play(*documents, cut, [&](EngineRun& run) {
      if (!random.chance(0.3) || run.cut(0, bytes) != SaveResult::saved) return;
      member.forget(bytes, Shape::of(run.engine().tables()), member.place);
      saved::seal(bytes);
      refused = refused || run.load(bytes) != LoadResult::loaded;
    });
  } catch (const std::exception&) { return true; } // a script in a state that it cannot reach
  return refused || whole.events() != cut.events();
}

TEST_CASE("each saved number is necessary") {
  constexpr std::uint64_t most = 4'000;
  const std::vector<Member> all = members();
  for (std::size_t i = 0; i < all.size(); i += numbers_apart) {
    const Member& member = all[i];
    std::uint64_t seed = 1;
    while (seed <= most && !counts(member, seed)) ++seed;
    INFO(member.kind << ", number " << member.place);
    CHECK(seed <= most);
  }
}

/// A possible number: a small one, nil, another byte of the state, or a flipped bit.
void damage(std::vector<std::byte>& bytes, Random& random) {
  const std::size_t head = saved::bytes_of<saved::HeadRow>();
  const std::size_t from = random.chance(0.1) ? 20 : head; // behind version, sum, size and fingerprint
  const std::size_t at = from + random.below(bytes.size() - from);
  switch (random.below(4)) {
  case 0: bytes[at] = static_cast<std::byte>(random.below(16)); break;
  case 1:
    for (std::size_t i = at; i < bytes.size() && i < at + sizeof(Index); ++i) bytes[i] = std::byte{0xFF};
    break;
  case 2: bytes[at] = bytes[head + random.below(bytes.size() - head)]; break;
  default: bytes[at] ^= static_cast<std::byte>(1U << random.below(8)); break;
  }
}

TEST_CASE("bytes that were not saved are refused, or loaded without harm") {
  const std::uint64_t wanted = cases_of({.usual = 20'000, .slow = 5'000, .whole = 200'000});
  std::uint64_t seed = from_environment<std::uint64_t>("DIRECTOR_SEED", 1), tried = 0, accepted = 0;
  for (; tried < wanted; ++seed) {
    watch(seed);
    const auto documents = compiled(seed);
    EngineRun run(*documents, false);
    Random random(seed);
    std::vector<std::vector<std::byte>> states;
    std::vector<std::byte> bytes;
    play(*documents, run, [&](EngineRun& each) {
      if (each.cut(0, bytes) == SaveResult::saved && random.chance(0.2)) states.push_back(bytes);
    });
    for (const std::vector<std::byte>& state : states) {
      for (int i = 0; i < 20; ++i, ++tried) {
        bytes = state;
        for (std::size_t changes = 1 + random.below(3); changes > 0; --changes) damage(bytes, random);
        saved::seal(bytes); // otherwise the check sum would detect it
        EngineRun other(*documents, false);
        const std::vector<std::byte> before = decision_bytes(other.engine());
        if (other.load(bytes) != LoadResult::loaded) {
          REQUIRE(decision_bytes(other.engine()) == before);
          continue;
        }
        ++accepted;
        try {
          std::size_t left = 300;
          for (const compiler::ScenarioStep& step : documents->scenario.steps) {
            other.begin_step(step);
            while (left != 0 && other.micro_step()) --left;
            for (Index g = 0; g < other.engine().tables().groups.size(); ++g) why(view_of(other.engine()), g);
            if (left == 0) break;
          }
        } catch (const std::exception&) { // a script in a state that it cannot reach
        }
      }
    }
    stop_watching();
  }
  std::cout << tried << " states changed, " << accepted << " of them accepted and played on\n";
  CHECK(accepted > tried / 20);
  CHECK(accepted < tried);
}

TEST_CASE("truncated bytes, and flipped bits without a new check sum, are refused") {
  const auto documents = compiled(7);
  EngineRun run(*documents, false);
  std::vector<std::byte> bytes;
  play(*documents, run, [&](EngineRun& each) { (void)each.cut(0, bytes); });
  REQUIRE(run.load(bytes) == LoadResult::loaded);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    REQUIRE(run.load(std::span(bytes).first(size)) == LoadResult::truncated);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
    const LoadResult result = run.load(bytes);
    REQUIRE((result == LoadResult::other_version || result == LoadResult::truncated || result == LoadResult::damaged));
    REQUIRE((result == LoadResult::other_version) == (bit / 8 < 4));
    bytes[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
  }
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    for (std::byte& each : bytes) each = static_cast<std::byte>(random.below(256));
    REQUIRE(run.load(bytes) != LoadResult::loaded);
  }
}

} // namespace
