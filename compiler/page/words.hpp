#pragma once
// SPDX-License-Identifier: MIT
// What the pages of all formats share: sentences, places, and names for cells of the matrix.

#include "compiler/page/pages.hpp"

namespace director::compiler::page {

/// A kind of cell: its sign in the matrix, and what it means.
struct CellKind {
  std::string_view kind, sign, meaning;
  std::string_view style = kind; ///< the kind whose colour it has
};
const std::vector<CellKind>& cell_kinds();
/// Those that these rows have, for a legend.
std::vector<CellKind> cell_kinds_in(const Json& rows);
const CellKind& cell_kind(const Json& cell);

/// `S`, or `S ✖` if an assertion that it is soft is refuted.
std::string cell_sign(const Json& cell);
bool is_refuted(const Json& cell);
/// Whether some cell is.
bool has_refuted(const Json& rows);
inline constexpr const char* refuted_meaning =
    "an assertion says that granting the second is always soft for the first, and is refuted: it can happen otherwise";
inline constexpr const char* one_course =
    "Each cell is one course of events, and others are possible. What must always hold is an assertion.";

/// Whether the cell has its own explanation; otherwise a line for all of its kind in a row is enough.
bool needs_explanation(const Json& cell);

/// `behaviours/soccer/soccer.yaml:12`
std::string place_text(const Json& place);
/// Empty: it is no link.
std::string place_link(const Json& place, const std::string& pattern);

/// `values lost, far, near; lost at the beginning; from outside; lost after 1 s`
std::string state_words(const Json& state);

/// Where a group is from, and what else it has: `layer skill`, `module legs`, `realtime`, `a start handler`. Without
/// the type of its data.
std::vector<std::string> group_words(const Json& group);

/// A paragraph, or a list.
struct DocBlock {
  enum class Kind { paragraph, bullets, numbers };
  Kind kind = Kind::paragraph;
  std::vector<std::string> items; ///< of a paragraph one, with its line breaks
};
/// Of a `doc`: an empty line ends a block, and a line that begins with `- ` or `1. ` begins an item.
std::vector<DocBlock> doc_blocks(const Json& thing);

/// How the order is decided: `Striker, priority 20 before 10`
std::string take_words(const Json& take);

/// Two that request one group, and their order: `the program: Kick (priority 20) before Walk (priority 10)`
struct Rivals {
  std::string group, first, second;
  std::vector<std::string> decisions;
};
/// With a limit for each pair; the last one has the number of the rest.
std::vector<Rivals> rivals_in(const Json& ranks);

/// The introduction of their table.
inline constexpr std::string_view rivals_intro =
    "Two that request the same, and what decides between them: the closest requester of both, with the two tasks by "
    "which it leads there. Those that it never requests at once meet only while it changes from one to the other.";

/// The introduction of both tables.
inline constexpr std::string_view unreached_intro = "No request of the program leads to these groups:";
inline constexpr std::string_view takes_intro =
    "Two tasks that want the same are compared at the closest requester of both.";

/// Of a matrix of some groups.
inline constexpr std::string_view limited_intro = "Rows and columns are only the groups that were named.";

/// The lines of a text without what is blank at its end.
std::string without_trailing_blanks(std::string text);

} // namespace director::compiler::page
