// Header: runtime/hosted/trace/fingerprint.hpp. Test: tests/runtime/hosted/trace/json_lines_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/hosted/trace/fingerprint.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <string_view>

namespace director {

namespace {

/// Hashes field by field: rows have padding, and an Index has 16 or 32 bits.
class Hash {
public:
  std::uint64_t value() const { return hash_; }

  void operator()(std::uint64_t number) {
    for (int i = 0; i < 64; i += 8) byte(static_cast<unsigned char>(number >> i));
  }
  void operator()(std::int64_t number) { (*this)(static_cast<std::uint64_t>(number)); }
  void operator()(std::int32_t number) { (*this)(static_cast<std::int64_t>(number)); }
  void operator()(bool flag) { byte(flag ? 1 : 0); }
  void operator()(Index index) { (*this)(index == nil ? ~std::uint64_t{0} : std::uint64_t{index}); }
  /// The place of an empty range does not count: generated code leaves it out.
  void operator()(Range range) { range.empty() ? all(Index{0}, Index{0}) : all(range.begin, range.end); }
  void operator()(std::string_view text) {
    for (const char each : text) byte(static_cast<unsigned char>(each));
    byte(0);
  }

  void operator()(const Group& g) {
    all(g.providers, g.edges, g.requesters, g.slots, g.listens, g.owned, g.users, g.start, g.stop, g.component);
  }
  void operator()(const Provider& p) {
    all(p.group, p.when, p.stay, p.needs, p.triggers, p.effects, p.causing, p.aims, p.promises, p.every);
  }
  void operator()(const Edge& e) { all(e.requester, e.target, e.levels, e.need_urgency, e.cluster_offset); }
  void operator()(const Level& l) { all(l.priority, l.urgency, l.optional, l.apart); }
  void operator()(const Condition& c) { all(c.state, c.accepts, c.causers, c.components, c.groups); }
  void operator()(const Interval& i) { all(i.low, i.high); }
  void operator()(const StateVariable& s) {
    all(s.initial, s.expires, s.expires_to, s.owner, s.external, s.conditions);
  }
  void operator()(const Trigger& t) { all(t.listeners); }
  void operator()(const Promise& p) { all(p.provider, p.condition, p.within, p.trigger); }
  void operator()(const Component& c) { all(c.groups, c.edges, c.order); }

  template <class Row>
  void operator()(std::span<const Row> rows) {
    (*this)(std::uint64_t{rows.size()});
    for (const Row& row : rows) (*this)(row);
  }

  template <class... Fields>
  void all(const Fields&... fields) {
    ((*this)(fields), ...);
  }

private:
  void byte(unsigned char each) { hash_ = (hash_ ^ each) * 0x100000001b3; }
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

} // namespace

std::uint64_t fingerprint(const Names& names) {
  const Tables& t = *names.tables;
  Hash hash;
  hash.all(t.groups, t.providers, t.edges, t.levels, t.conditions, t.intervals, t.states, t.triggers, t.promises,
           t.lists, t.components, t.plan_groups, t.listened, t.root_edges, t.most_edges);
  const auto words = [&](const char* (*name)(const void*, Index), std::size_t count) {
    for (Index row = 0; row < count; ++row) hash(std::string_view(name(names.self, row)));
  };
  words(names.group, t.groups.size());
  words(names.provider, t.providers.size());
  words(names.state, t.states.size());
  for (Index state = 0; state < t.states.size(); ++state) {
    std::string_view value = "-";
    for (std::int32_t number = 0; !value.empty(); ++number) hash(value = names.value(names.self, state, number));
  }
  words(names.trigger, t.triggers.size());
  words(names.condition, t.conditions.size());
  words(names.level, t.levels.size());
  return hash.value();
}

std::string fingerprint_text(const Names& names) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, fingerprint(names));
  return text.data();
}

} // namespace director
