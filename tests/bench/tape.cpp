// Header: tests/bench/tape.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/tape.hpp"

#include <algorithm>

namespace bench {

using director::Event;

void Tape::begin() {
  calls_.clear();
  requests_.clear();
  sets_.clear();
}

void Tape::end_input() { inputs_.push_back(calls_.size()); }

void Tape::observe(void* self, const Event& event) {
  Tape& tape = *static_cast<Tape*>(self);
  const auto add = [](std::vector<Write>& writes, std::vector<std::int32_t>& rows, std::size_t row, auto value) {
    writes.push_back({row, static_cast<std::int32_t>(value)});
    rows.resize(std::max(rows.size(), row + 1));
  };
  if (event.kind == Event::Kind::run) {
    tape.calls_.push_back(
        {provide, static_cast<std::uint32_t>(tape.requests_.size()), static_cast<std::uint32_t>(tape.sets_.size())});
  } else if (tape.calls_.empty()) {
    return;
  } else if (event.kind == Event::Kind::ask) {
    add(tape.requests_, tape.requested_, event.edge, event.level);
    ++tape.calls_.back().requests;
  } else if (event.kind == Event::Kind::set) {
    add(tape.sets_, tape.values_, event.state, event.value);
    ++tape.calls_.back().sets;
  }
}

void Tape::provide(Tape& tape, const Call& self) {
  const Write* const set = tape.sets_.data() + self.first_set;
  for (std::uint32_t i = 0; i < self.sets; ++i) tape.values_[set[i].row] = set[i].value;
  const Write* const request = tape.requests_.data() + self.first_request;
  for (std::uint32_t i = 0; i < self.requests; ++i) tape.requested_[request[i].row] = request[i].value;
}

void Tape::play() {
  std::size_t at = 0;
  for (const std::size_t end : inputs_) {
    for (; at < end; ++at) calls_[at].provide(*this, calls_[at]);
  }
}

} // namespace bench
