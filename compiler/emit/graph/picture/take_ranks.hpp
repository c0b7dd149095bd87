#pragma once
// SPDX-License-Identifier: MIT
// Describes by which ranks one task may take something from another.

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/model/model.hpp"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

/// Each of the first goes before each of the second.
struct RanksOver {
  std::vector<analysis::SideRank> first, second;
};
/// Those that go before the same are together.
std::vector<RanksOver> ranks_over(const std::set<analysis::Winning>& ranks);

/// `10 or 80 over 0`, `5 over 50 optional`, `-3 over 5 (something below it optional)`; a text for each.
std::vector<std::string> ranks_words(const Edge& taker, const Edge& loser, const std::set<analysis::Winning>& ranks,
                                     std::string_view over);

} // namespace director::compiler
