#pragma once
// SPDX-License-Identifier: MIT
// What a body requests, in the terms of the model.

#include "compiler/analysis/code/code.hpp"

namespace director::analysis {

/// Whether the word requests this pack.
bool is_pack(const CodeWord& word, const Pack& pack);
bool requests_pack(const Body& body, const Pack& pack);
/// Whether the input contains the task.
bool gives(const CodeInput& input, const CodeWord& word, GroupId task);
/// Whether its only answer is keep().
bool only_keeps_going(const Body& body);

} // namespace director::analysis
