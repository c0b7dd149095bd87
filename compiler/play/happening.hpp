#pragma once
// SPDX-License-Identifier: MIT
// Events of a scenario, as values that can be printed without the Model. Source: docs/scenarios.md.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct Happening {
  enum class Kind {
    input, ///< `words`: the text of the step
    run,
    start,
    stop,
    done,
    failed,
    broken,
    budget_exhausted,
    // Decisions: only if requested.
    queue, ///< from, group, `words`: why
    push,  ///< group, provider, from, `words`: the group for which it is pushed
    release,
    set, ///< state, value
  };
  Kind kind = Kind::input;
  std::uint32_t step = 1; ///< counts from 1
  std::int64_t time = 0;  ///< in microseconds, since the scenario began
  std::string group;
  std::string provider;             ///< also if it is `default`
  std::vector<std::string> reasons; ///< of a run, in the order of the page
  std::string from;                 ///< the requester, or `root`
  std::string words;
  std::string state;
  std::optional<std::string> value; ///< empty: the state is unset
  bool is_number = false;           ///< the value is one

  bool operator==(const Happening&) const = default;
};

/// Whether times are printed too. Scenarios do not expect any.
enum class ShowTimes : bool { no, yes };

/// One line, as in `expect`; an input behind `> `. With times, these come before it. The colours are those of the
/// pictures: what runs is blue, what waits red, what is pushed green, what no longer runs grey.
std::string to_text(const Happening& happening, ShowTimes times = ShowTimes::no, bool has_colours = false);

/// One JSON object on one line.
std::string to_json(const Happening& happening, ShowTimes times = ShowTimes::no);

} // namespace director::compiler
