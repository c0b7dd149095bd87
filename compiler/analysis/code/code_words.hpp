#pragma once
// SPDX-License-Identifier: MIT
// What a body asks for, in the terms of the model.

#include "compiler/analysis/code/code.hpp"

namespace director::analysis {

/// It is this pack that the word asks for.
bool is_pack(const CodeWord& word, const Pack& pack);
bool requests_pack(const Body& body, const Pack& pack);
/// The task is among what is handed over.
bool gives(const CodeInput& input, const CodeWord& word, GroupId task);
/// It says keep() and no other answer.
bool only_keeps_going(const Body& body);

} // namespace director::analysis
