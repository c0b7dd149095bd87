#pragma once
// SPDX-License-Identifier: MIT
// The engine on tables that the compiler library makes of a text or a file, with bodies that are rows of a table too:
// for behaviours that are too large for code by hand.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "tests/bench/random_behaviour.hpp"

#include <string>
#include <vector>

namespace bench {

struct Compiled {
  director::compiler::Model model;
  director::compiler::Lowered lowered;
};

/// Reads a text; an error in it is thrown.
Compiled compile_text(const std::string& text);
/// Reads a file, by its path from the root of the project.
Compiled compile_file(const std::string& path);

/// The results of one run of a provider.
struct Act {
  director::Index state = director::nil;
  std::int32_t value = 0;
  director::Index begin = 0; ///< first of the robot's edges to be requested, at their first level
  std::uint16_t count = 0;   ///< number of these edges
  director::Outcome::Kind answer = director::Outcome::Kind::pack;
};

/// What the providers do by default.
enum class Play {
  same,     ///< each requests its whole first pack, in every run
  changing, ///< its packs in turn; and sets what it promises or may set, the first value of each, in turn
  at_random ///< its first pack, and one run in four sets what it promises; one in ten runs does something else: another
            ///< pack, done, or keep
};

class TableRobot {
public:
  /// `cells`: the size of the inbox, a power of two.
  TableRobot(Compiled compiled, std::size_t cells, Play play = Play::same, director::Observer observer = {});
  TableRobot(const TableRobot&) = delete;
  TableRobot& operator=(const TableRobot&) = delete;

  /// The first act of a provider.
  Act& act(const std::string& provider);
  std::uint64_t act_length = 1; ///< the runs that an act lasts

  director::Index root(const std::string& group) const; ///< the edge
  director::Index state(const std::string& name) const;
  std::int32_t value(director::Index state, const std::string& word) const;
  director::Index trigger(const std::string& name) const;

  director::Input request(director::Index edge,
                          director::Index level = 0) const; ///< `level`: its place among those of the edge
  void post(std::span<const director::Input> records);
  void post(const director::Input& record) { post({&record, 1}); }
  void step(director::Time now = 0);
  bool micro_step(director::Time now); ///< from then on, one in each step; false: it is at rest

  std::uint64_t calls() const { return calls_; }
  const director::Engine& engine() const { return engine_; }
  const director::compiler::Model& model() const { return compiled_.model; }

private:
  void add_acts(const director::compiler::Provider& provider);
  director::Bodies functions();
  director::Outcome run(director::Run& run);
  const Act& act_of(director::Index provider, bool other);

  Compiled compiled_;
  const director::Tables tables_;
  const Play play_;
  std::vector<Act> acts_; ///< provider after provider, so that a large robot fetches no more than it uses
  struct Asked {
    director::Index edge, level;
  };
  std::vector<Asked> edges_;
  std::vector<director::Index>
      first_act_;                   ///< for each provider, and the end of all; if equal to the next, it has one act
  std::vector<std::uint64_t> runs_; ///< for each provider, if its acts change
  Random random_{1};
  std::vector<director::Inbox::Cell> cells_;
  director::Inbox inbox_;
  director::EngineMemory memory_;
  std::uint64_t calls_ = 0;
  director::Engine engine_;
};

} // namespace bench
