#pragma once
// SPDX-License-Identifier: MIT
// Which micro-steps end alike, told before they are taken: those that come to the same before anybody arbitrates.

#include "compiler/explore/happens.hpp"
#include "compiler/explore/print.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director::compiler {

class Foresight {
public:
  Foresight(const Ground& ground, const Engine& engine, const Printer& printer);

  /// Of the state that the engine is in. `answers`: what the body may do that runs next, all of one provider; none if
  /// none runs next. `inputs`: the outside may do something.
  void look(std::span<const Deed> answers, bool inputs);

  // About that state, wherever the engine is now: the same for micro-steps that end alike, in as many ways (and with a
  // chance of 2^-64 for two that do not), wherever they begin. `watch`: what somebody remembers beside the state.

  /// The body gives an answer and sets some of its `puts`. `each`: it counts which of them these are, not only what
  /// they make of the values.
  std::uint64_t of_body(std::size_t answer, std::size_t puts, std::uint64_t watch, bool each) const;
  /// The outside sets these.
  std::uint64_t of_input(const Puts& puts, std::uint64_t watch) const;

private:
  std::uint64_t effect_of(const Deed& deed);
  std::uint64_t values_with(const Puts& puts) const;

  const Ground& ground_;
  const Engine& engine_;
  const Printer& printer_;
  std::uint64_t input_rest_ = 0, values_ = 0;
  std::vector<std::uint64_t> body_rest_;   ///< answer
  std::vector<std::uint64_t> body_values_; ///< row of FreeBody::puts
  std::vector<std::int32_t> before_;       ///< state: its value
  std::vector<Requested> request_;         ///< edge of the body's group: as it will be
  std::vector<std::uint64_t> projection_;
};

} // namespace director::compiler
