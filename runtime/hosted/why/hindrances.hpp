#pragma once
// SPDX-License-Identifier: MIT
// What keeps a provider from running at one moment, or from causing a condition that it promises.

#include "runtime/core/inspect/why.hpp"
#include "runtime/hosted/why/why_words.hpp"

#include <string>
#include <vector>

namespace director {

class Hindrances {
public:
  /// All must outlive this.
  Hindrances(const View& view, const WhyWords& words) : v_(view), t_(*view.tables), words_(words) {}

  /// What keeps the provider from running: it is disabled, or the first thing that it lacks. Empty: nothing that can be
  /// seen at the provider itself.
  std::string hindrance(Index row, Index request) const;
  /// The state of a provider that promises the condition. `pushed`: the first one that is, or nil.
  std::string causer(Index row, const Because& because, Index pushed) const;

  /// Adds, for each need, the first enabled provider for which all groups are free for the request.
  bool find_plan(Index row, Index request, std::vector<Index>& plan) const;
  /// Whether the condition is false.
  bool lacks(Index condition) const;
  /// Whether an enabled provider promises the condition.
  bool is_promised(Index condition) const;
  /// Whether its group is to change to it, if it can run.
  bool is_pushed(Index row) const;

private:
  std::string hindrance_with_needs(Index row, Index request) const;
  bool is_in_the_way(Index holder, Index need, Index request) const;
  Index unpromised(Index row) const;
  bool is_requested(Index group) const;
  bool outranks(Index holder, Index request) const;
  std::string holder_words(Index of) const;

  const View& v_;
  const Tables& t_;
  const WhyWords& words_;
};

} // namespace director
