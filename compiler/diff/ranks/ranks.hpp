#pragma once
// SPDX-License-Identifier: MIT
// How two edges of one requester are ordered by their levels: what is optional goes last, then by priority.

#include "compiler/model/model.hpp"

#include <string>
#include <utility>
#include <vector>

namespace director::compiler::diff {

/// "priority 3 and 1 (optional)"
std::string rank_text(const Edge& edge);

/// For each level of the one and each of the other: 1 if that of the one goes first, -1 if it goes last, else 0. A need
/// counts as mandatory, with the priority of the first level.
std::vector<int> orders(const Edge& one, const Edge& other);

/// The first is before something now that it was not before, and the other way round.
std::pair<bool, bool> gains_and_loses(const std::vector<int>& before, const std::vector<int>& now);

/// Whether each level of the one has the same order to each of the other as before.
bool is_order_alike(const Edge& one, const Edge& old_one, const Edge& other, const Edge& old_other);

} // namespace director::compiler::diff
