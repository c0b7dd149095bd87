// Header: compiler/explore/machine/machine.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
//
// Saves and restores the engine's state. It includes redundant parts: copying them is shorter than deriving them.
#include "compiler/explore/machine/machine.hpp"

#include <algorithm>
#include <cstring>

namespace director::compiler {

/// The decision state, followed by why requests are queued: no decision depends on that, but assertions do, and the
/// engine writes it only when it decides again.
void Machine::read(std::vector<std::uint64_t>& out) const {
  const std::size_t queued = ground_.tables.edges.size() * sizeof(Queued);
  out.resize(Projection::words_of(block_) + Projection::words_of(queued));
  out.back() = 0;
  std::memcpy(out.data(), memory_.state().data(), block_);
  if (queued != 0) std::memcpy(out.data() + Projection::words_of(block_), engine_.memory().queued, queued);
}

void Machine::write(const std::vector<std::uint64_t>& from) {
  const std::size_t queued = ground_.tables.edges.size() * sizeof(Queued);
  std::memcpy(memory_.state().data(), from.data(), block_);
  const director::State& s = engine_.memory();
  if (queued != 0) std::memcpy(static_cast<void*>(s.queued), from.data() + Projection::words_of(block_), queued);
  engine_.forget_trail();
}

void Machine::start() {
  write(packing_.first());
  phase_ = Phase::rest;
}

void Machine::pack(Packed& out) const {
  read(now_);
  out.push_back(static_cast<std::uint8_t>(phase_));
  packing_.pack(now_.data(), out);
}

void Machine::unpack(std::span<const std::uint8_t> from) {
  loaded_phase_ = static_cast<Phase>(from.front());
  loaded_.resize(packing_.first().size());
  packing_.unpack(from.subspan(1), loaded_.data());
  again();
  find_answers();
}

void Machine::again() {
  write(loaded_);
  phase_ = loaded_phase_;
}

/// Replaces the stamps of one requester's requests by their ranks.
void Machine::forget() {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const auto rank = [&](Index begin, Index end) {
    scratch_.clear();
    for (Index e = begin; e != end; ++e) {
      if (s.request[e].level != nil) scratch_.push_back(e);
    }
    const auto first = [&](Index a, Index b) {
      const std::uint64_t one = s.request[a].stamp, other = s.request[b].stamp;
      return one != other ? one < other : a < b;
    };
    if (scratch_.size() > 1) std::sort(scratch_.begin(), scratch_.end(), first);
    for (Index e = begin; e != end; ++e) s.request[e].stamp = 0;
    for (std::size_t i = 0; i < scratch_.size(); ++i) s.request[scratch_[i]].stamp = i + 1;
  };
  rank(0, t.root_edges);
  for (const director::Group& group : t.groups) {
    if (!group.edges.empty()) rank(group.edges.begin, group.edges.end);
  }
  s.counters->micro_step = t.edges.size();
}

} // namespace director::compiler
