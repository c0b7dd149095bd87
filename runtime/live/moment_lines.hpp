#pragma once
// SPDX-License-Identifier: MIT
// A moment in words: as lines of a trace, for who begins in the middle, and why something waits.

#include "runtime/core/inspect/view.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>

namespace director::live {

/// Appends what holds as the events that would bring it about, a line each, each with its end: who holds what (`lose`:
/// nobody; `grant`), what states are worth (`given`), which providers are disabled, who was pushed, and what waits.
/// Behind a line that says that events are missing, a reader of traces then knows as much as from the beginning.
void append_moment(const View& view, const Names& names, std::string& out);

/// Appends where groups stand that do not just run, as a JSON array: `{"event":"held","group":…}` for each that is only
/// held for a need, `{"event":"stays","group":…,"asks":[…]}` for each that goes on though its request waits, with the
/// edges by which it asks, and `{"event":"waits","edge":…,"why":…}` for each request that waits. That is all of them:
/// what else is held runs, and no other request waits. The events tell most of that, and not all
/// (compiler/trace/waits.hpp).
void append_standing(const View& view, const Names& names, std::string& out);

/// Why a group does not run, or for whom it does, as JSON: `group`, `kind`, `text`, where something is held that it
/// would have to get `held`, with that `group` and the edge `by` which it is held, and `notes`, each a text more: what
/// the state is worth that is missing, and what becomes of each who could cause it.
void append_why(const View& view, Index group, const Names& names, std::string& out);

} // namespace director::live
