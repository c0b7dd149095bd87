#pragma once
// SPDX-License-Identifier: MIT
// The text of an event, of the answer of `why`, or of reasons to run, never cut off, for programs that have a heap.
// Test: tests/compiler/trace/event_words_test.cpp, tests/runtime/live/moment_lines_test.cpp.

#include "runtime/core/api/event_names.hpp"
#include "runtime/hosted/decision_printer.hpp"

#include <string>
#include <string_view>

namespace director {

/// As to_text() of decision_printer.hpp (an Event) and why.hpp (a Because), in a buffer that is large enough.
template <class What>
std::string to_text(const What& what, const Names& names) {
  std::string out(256, '\0');
  for (;;) {
    const std::size_t size = std::string_view(to_text(what, names, out)).size();
    if (size + 1 < out.size()) {
      out.resize(size);
      return out;
    }
    out.resize(4 * out.size());
  }
}

/// "new_task+pushed"; empty for none.
inline std::string to_text(Reasons reasons) {
  std::string out;
  for (const Reason reason : all_reasons) {
    if (reasons.has(reason)) out += (out.empty() ? "" : "+") + std::string(name_of(reason));
  }
  return out;
}

} // namespace director
