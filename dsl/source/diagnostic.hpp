#pragma once
// SPDX-License-Identifier: MIT
// A fault in the user's input: a value that every stage returns and only the command line prints.

#include "dsl/source/span.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

enum class Level { error, warning, lint };

std::string_view name_of(Level level); ///< "error", "warning", "lint"

/// A further place of a finding, with its own message.
struct Note {
  /// Notes may form a path through the specification, from one to the next.
  enum class Link {
    aside, ///< it stands for itself
    first, ///< a way begins here, at the finding's own place
    next   ///< it goes on from the note before
  };
  Span span{};
  std::string message;
  Link link = Link::aside;
  bool operator==(const Note&) const = default;
};

struct Diagnostic {
  std::string id; ///< the rule, snake_case: a page of compiler/checks
  Level level = Level::error;
  Span span{};
  std::string message; ///< without the id
  std::vector<Note> notes;
  std::string help; ///< what to do; empty if there is nothing to propose
  /// Spans of what never happens because of this finding: of a provider, a condition of one, a need, an entry, or the
  /// name of a group. Other checks do not report these again.
  std::vector<Span> rules_out{};
  std::vector<Span> rules_out_together{}; ///< entries that may happen each, and never all of them at once
  bool operator==(const Diagnostic&) const = default;
};

/// Sorts by file, begin, end, then id and message; equal findings are merged.
void sort_by_place(std::vector<Diagnostic>& diagnostics);

bool has_errors(const std::vector<Diagnostic>& diagnostics);

} // namespace director::dsl
