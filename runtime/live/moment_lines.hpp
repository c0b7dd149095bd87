#pragma once
// SPDX-License-Identifier: MIT
// A moment as text: as lines of a trace, for readers that begin in the middle, and why groups wait.

#include "runtime/core/inspect/view.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>

namespace director::live {

/// Appends the state as events that lead to it, one complete line each: holders (`lose`: none; `grant`), values
/// (`given`), disabled providers, pushes, and queued requests. Behind a line that says that events are missing, a
/// reader of traces then knows the same as from the beginning.
void append_moment(const View& view, const Names& names, std::string& out);

/// Appends the groups that do not simply run, as a JSON array: `{"event":"held","group":…}` for each that is held only
/// as a need, `{"event":"stays","group":…,"asks":[…]}` for each that runs on though its request is queued, with the
/// edges that request it, `{"event":"without_effect","group":…}` for each that runs in the provider of its push, but
/// not because of it, and `{"event":"waits","edge":…,"why":…}` for each queued request. The list is complete: all other
/// held groups run, those in the provider of their push because of it, and no other request is queued. Events report
/// most of that, but not all (compiler/trace/waits.hpp).
void append_standing(const View& view, const Names& names, std::string& out);

/// Why a group runs or does not, as JSON: `group`, `kind`, `text`; if a group that it needs is held, `held`, with that
/// `group` and its holder, the edge `by`; and `notes`, the texts of why_notes().
void append_why(const View& view, Index group, const Names& names, std::string& out);

} // namespace director::live
