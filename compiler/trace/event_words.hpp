#pragma once
// SPDX-License-Identifier: MIT
// Every event as text: like `simulate`, and for events that it does not print like the timeline of a page
// (compiler/page/web/shape.ts).

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>
#include <utility>

namespace director::compiler {

/// Without its time. `names` must have tables.
std::string words_of(const Event& event, const director::Names& names);

/// The texts of two different events, which must differ: if they are equal, with the differing values added. `names`:
/// of each.
std::pair<std::string, std::string> words_of_both(const Event& one, const director::Names& names_of_one,
                                                  const Event& other, const director::Names& names_of_other);

} // namespace director::compiler
