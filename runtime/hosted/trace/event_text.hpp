#pragma once
// SPDX-License-Identifier: MIT
// The text of an event, never cut off, for programs that have a heap. Test: tests/compiler/trace/event_words_test.cpp.

#include "runtime/hosted/decision_printer.hpp"

#include <string>
#include <string_view>

namespace director {

/// As to_text() of decision_printer.hpp, in a buffer that is large enough.
inline std::string to_text(const Event& event, const Names& names) {
  std::string out(256, '\0');
  for (;;) {
    const std::size_t size = std::string_view(to_text(event, names, out)).size();
    if (size + 1 < out.size()) {
      out.resize(size);
      return out;
    }
    out.resize(4 * out.size());
  }
}

} // namespace director
