#pragma once
// SPDX-License-Identifier: MIT
// Every event in words: those of `simulate`, and of what it says nothing about, those that the timeline of a page has
// (compiler/page/web/shape.ts).

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>
#include <utility>

namespace director::compiler {

/// Without its time. `names` must have tables.
std::string words_of(const Event& event, const director::Names& names);

/// Two events that are not the same, so that they read otherwise: where the words are the same, with what differs
/// beside them. `names`: of each.
std::pair<std::string, std::string> words_of_both(const Event& one, const director::Names& names_of_one,
                                                  const Event& other, const director::Names& names_of_other);

} // namespace director::compiler
