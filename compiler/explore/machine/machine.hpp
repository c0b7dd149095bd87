#pragma once
// SPDX-License-Identifier: MIT
// The real engine, one micro-step at a time, with bodies that pick their answers from a sequence of choices. Its state
// can be saved, restored and compared with others.

#include "compiler/base/choice_sequence.hpp"
#include "compiler/explore/machine/foresight.hpp"
#include "compiler/explore/machine/packing.hpp"
#include "compiler/explore/machine/state_hash.hpp"
#include "runtime/hosted/engine_memory.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director::compiler {

class Machine {
public:
  Machine(const Ground& ground, Breadth breadth);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void start();                                    ///< the first state, at rest
  void pack(Packed& out) const;                    ///< appended
  void unpack(std::span<const std::uint8_t> from); ///< Packed; and `again()` comes back to it
  void again();

  /// What may happen now, in a fixed order.
  void list(std::vector<Happens>& out) const;
  /// Takes one micro-step from the restored state; its bodies pick from `choices`. Their answers are in actions().
  void take(const Happens& happens, ChoiceSequence& choices);
  const std::vector<Action>& actions() const { return actions_; }
  /// The last micro-step of another machine of the same Ground, from the state that it restored, without the requests
  /// of these edges. Bodies answer as they did there; handlers do what is usual.
  void repeat(const Machine& other, std::span<const Index> edges);

  StateHash hash() const { return hasher_.hash(phase_); }
  /// Resets what no decision depends on: the age of requests.
  void forget();

  /// The possible answers of the body that runs next in the restored state; none if none runs next.
  const std::vector<Action>& answers() const { return answers_; }
  /// Reads the restored state, before anything else is taken.
  const Foresight& look_ahead();

  Phase phase() const { return phase_; }
  const Engine& engine() const { return engine_; }
  const Ground& ground() const { return ground_; }

private:
  Outcome run(Run& run);
  void handle(Handling& handling, Action::Kind kind);
  void find_answers();
  bool keeps(const RequestedPack& pack) const;
  bool runs_next() const;
  bool takes_inputs() const;
  bool is_lean() const { return breadth_ != Breadth::all; }
  bool post(const Happens& happens);
  void read(std::vector<std::uint64_t>& out) const;
  void write(const std::vector<std::uint64_t>& from);
  Bodies table();

  const Ground& ground_;
  Breadth breadth_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  EngineMemory memory_;
  Engine engine_;
  std::size_t block_; ///< bytes of the decision state
  StateHasher hasher_;
  Foresight foresight_;
  Packing packing_; ///< relative to the engine's first state
  mutable std::vector<std::uint64_t> now_;
  std::vector<std::uint64_t> loaded_;
  Phase phase_ = Phase::rest, loaded_phase_ = Phase::rest;
  ChoiceSequence* choices_ = nullptr;
  Happens taken_;          ///< the last one
  std::size_t answer_ = 0; ///< of the body that ran in it, in answers_
  std::vector<Action> answers_, actions_;
  std::vector<Input> records_;
  std::vector<bool> unrequested_; ///< edges of which requests are left out
  std::vector<Index> scratch_;
};

} // namespace director::compiler
