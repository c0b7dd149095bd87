#pragma once
// SPDX-License-Identifier: MIT
// The floor of a workload: what the engine calls and writes for each input is recorded once. Then the same calls and
// writes are made by hand, in the same order, by function pointers, and nothing is decided.

#include "runtime/core/base/observer.hpp"

#include <cstdint>
#include <vector>

namespace bench {

class Tape {
public:
  // While it is recorded.
  director::Observer observer() { return {tell, this}; }
  void begin();     ///< what was told so far is no part of it
  void end_input(); ///< what was told since the input before belongs to this one

  void play(); ///< all inputs
  std::size_t inputs() const { return inputs_.size(); }
  std::size_t calls() const { return calls_.size(); } ///< of providers

private:
  struct Write {
    std::size_t row;
    std::int32_t value;
  };
  struct Call {
    void (*provide)(Tape& tape, const Call& self);
    std::uint32_t first_request, first_set, requests = 0, sets = 0;
  };
  static void tell(void* self, const director::Event& event);
  static void provide(Tape& tape, const Call& self);

  std::vector<Call> calls_;
  std::vector<std::size_t> inputs_; ///< one past the last call of each
  std::vector<Write> requests_, sets_;
  std::vector<std::int32_t> requested_, values_; ///< by edge, by state
};

} // namespace bench
