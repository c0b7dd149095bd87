#pragma once
// SPDX-License-Identifier: MIT
// Predicts which micro-steps have equal results, before they are taken: those that lead to the same input of the
// arbitration.

#include "compiler/explore/environment/happens.hpp"
#include "compiler/explore/machine/state_hash.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director::compiler {

class Foresight {
public:
  Foresight(const Ground& ground, const Engine& engine, const StateHasher& hasher);

  /// Reads the state of the engine. `answers`: the possible answers of the body that runs next, all of one provider;
  /// none if none runs next. `inputs`: inputs are possible.
  void look(std::span<const Action> answers, bool inputs);

  // A number for the micro-step from that state, wherever the engine is now: the same for micro-steps with equal
  // results, equally many (and with a chance of 2^-64 for two others), wherever they begin. `watch`: what is remembered
  // beside the state.

  /// The body gives an answer and sets some of its `puts`. `each`: the identity of these counts, not only their effect
  /// on the values.
  std::uint64_t of_body(std::size_t answer, std::size_t puts, std::uint64_t watch, bool each) const;
  /// Inputs set these.
  std::uint64_t of_input(const Puts& puts, std::uint64_t watch) const;

private:
  std::uint64_t effect_of(const Action& action);
  std::uint64_t values_with(const Puts& puts) const;

  const Ground& ground_;
  const Engine& engine_;
  const StateHasher& hasher_;
  std::uint64_t input_rest_ = 0, values_ = 0;
  std::vector<std::uint64_t> body_rest_;   ///< answer
  std::vector<std::uint64_t> body_values_; ///< row of FreeBody::puts
  std::vector<std::int32_t> before_;       ///< state: its value
  std::vector<Requested> request_;         ///< edge of the body's group: after the answer
  std::vector<std::uint64_t> projection_;
};

} // namespace director::compiler
