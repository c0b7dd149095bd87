#pragma once
// SPDX-License-Identifier: MIT
// The floor of a workload: the calls and writes of the engine for each input are recorded once. Then they are made by
// hand, in the same order, by function pointers, without any decision.

#include "runtime/core/base/observer.hpp"

#include <cstdint>
#include <vector>

namespace bench {

class Tape {
public:
  // For the recording.
  director::Observer observer() { return {observe, this}; }
  void begin();     ///< drops the events so far
  void end_input(); ///< the events since the last input belong to this one

  void play(); ///< plays all inputs
  std::size_t inputs() const { return inputs_.size(); }
  std::size_t calls() const { return calls_.size(); } ///< provider calls

private:
  struct Write {
    std::size_t row;
    std::int32_t value;
  };
  struct Call {
    void (*provide)(Tape& tape, const Call& self);
    std::uint32_t first_request, first_set, requests = 0, sets = 0;
  };
  static void observe(void* self, const director::Event& event);
  static void provide(Tape& tape, const Call& self);

  std::vector<Call> calls_;
  std::vector<std::size_t> inputs_; ///< for each input, the end of its calls
  std::vector<Write> requests_, sets_;
  std::vector<std::int32_t> requested_, values_; ///< by edge, by state
};

} // namespace bench
