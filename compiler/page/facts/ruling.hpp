#pragma once
// SPDX-License-Identifier: MIT
// What decides between two edges that may want one group, in words.

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/page/facts/leaders.hpp"

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler {

/// A decision between two edges to one group. If one of them is the sibling itself, and the other one is below the
/// other sibling, priorities do not always decide: a unit is granted whole before anything below it, and a requester
/// runs only with what it needs. Nor do they if one of them is a sibling, or needed for one: that is granted with its
/// unit.
struct Ruling {
  enum class Held : std::uint8_t { by_rank, in_unit, as_need, by_leader };
  struct Side {
    Held held = Held::by_rank;
    bool needs = false;          ///< it concerns a need of the task, not the task
    bool asks = false;           ///< it concerns a request of the task, not the task
    std::vector<Leader> leaders; ///< by rank: with one of these it goes first
    auto operator<=>(const Side&) const = default;
  };
  analysis::Decision decision;
  Side first, second; ///< at most one of them is held by something else than rank
  auto operator<=>(const Ruling&) const = default;

  int order() const {
    return first.held != Held::by_rank ? -1 : second.held != Held::by_rank ? 1 : analysis::order_of(decision);
  }
};

/// `granted together with Lift (priority 50) or Hold (priority 20, if older)`
std::string together_words(const Model& model, const std::vector<Leader>& leaders);

/// Of the two tasks, the one that goes first comes first.
std::string words_of(const Model& model, const Ruling& ruling);

} // namespace director::compiler
