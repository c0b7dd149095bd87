#pragma once
// SPDX-License-Identifier: MIT
// How much searching one run of the checks may do. The cost of some questions, which are NP-complete, cannot be
// predicted. Each search has a limit of its own, and all of them together have one too, so that a file of many hard
// questions ends as well. Work is counted in steps, not in time: equal input has equal findings on every machine.

#include "dsl/source/span.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace director::analysis {

/// A question without an answer.
struct OpenQuestion {
  dsl::Span span{};
  std::string words; ///< as in "whether `A` ever comes first"
  bool operator==(const OpenQuestion&) const = default;
};

class Budget {
public:
  /// Some seconds. A real behaviour of 10,000 groups takes a hundredth.
  static constexpr std::int64_t of_a_run = 200'000'000;
  static constexpr std::int64_t of_any_search = 20'000;

  explicit Budget(std::int64_t steps = of_a_run) : left_(steps) {}

  /// The limit for a search that wants so many steps. It always has a few: easy questions are answered even after hard
  /// ones.
  std::int64_t grant(std::int64_t wanted) const { return std::min(wanted, std::max(left_, of_any_search)); }
  void spend(std::int64_t steps) { left_ -= std::min(steps, left_); }
  bool exhausted() const { return left_ == 0; }

  /// Records a search that ended without an answer. Each question counts once.
  void leave_open(dsl::Span span, std::string words) {
    const OpenQuestion question{span, std::move(words)};
    if (std::find(open_.begin(), open_.end(), question) == open_.end()) open_.push_back(question);
  }
  const std::vector<OpenQuestion>& open() const { return open_; }

private:
  std::int64_t left_;
  std::vector<OpenQuestion> open_;
};

} // namespace director::analysis
