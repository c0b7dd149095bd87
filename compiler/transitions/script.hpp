#pragma once
// SPDX-License-Identifier: MIT
// The scenario of a cell as pieces of text: the answers of bodies on the chain of the row and then on that of the
// column. Cells share equal pieces.

#include "compiler/transitions/way.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler::transitions {

/// How often each provider ran before the column's request.
using Runs = std::map<ProviderId, std::uint32_t>;

/// By provider: its cases, each a mapping on one line. In the order of declaration.
using Script = std::map<ProviderId, std::vector<std::string>>;

/// Where two ways part.
struct Parting {
  std::optional<std::size_t> link; ///< of both; empty: at the program
  bool replaced = false;           ///< the requester cannot request both at once
};
Parting part(const Model& model, const Way& row, const Way& column);

/// The column's request.
struct Until {
  Runs runs;      ///< before it
  Values outside; ///< pushed bodies do not change these states from then on
  Values given;   ///< values that bodies on the column's chain set from then on, other than those of its own providers
  bool only_certain = false; ///< for all of the play: bodies set nothing of which their `sets` has several values
};

/// Whether `only_certain` makes a difference.
bool leaves_choice(const Model& model);

/// Until it is at rest: the answers that lead there; pushed bodies keep their promises. The target is done a
/// millisecond later.
Script script_of(const Model& model, const Way& row, const Until& until = {});
/// ... and then those that lead to the column.
Script script_of(const Model& model, const Way& row, const Way& column, const Until& until);

/// Of these values those that the body may set.
Values settable(const Model& model, ProviderId id, const Values& values);

/// The other providers of the groups on the way, which run before those of the way, or instead of them.
std::vector<ProviderId> beside(const Model& model, const Way& way);

/// The steps: values from outside and the program's request; values from outside alone; the row's task is done.
std::string request_step(const Model& model, const Way& way, const Values& values);
std::string settings_step(const Model& model, const Values& values);
std::string done_step();

/// `given: {Load: box}`; empty if it begins as declared.
std::string given_text(const Model& model, const Values& values);

/// The text of one entry of the script.
std::string entry_text(const Model& model, ProviderId id, const std::vector<std::string>& cases);

} // namespace director::compiler::transitions
