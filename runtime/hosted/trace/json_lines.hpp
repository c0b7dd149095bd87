#pragma once
// SPDX-License-Identifier: MIT
// Events as lines of a trace, with names instead of numbers. The recorder writes these lines, and a replay compares its
// own with them.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace director {

inline constexpr int trace_version = 1;

/// Appends a line without its end: {"t":1500000,"n":12,"event":"run","group":"Walk", ...}. `names` must have tables.
void append_event(const Event& event, const Names& names, std::string& out);

/// Appends the first line of a trace, without its end: version, behaviour, fingerprint, the names of all rows, and who
/// requests which level.
void append_header(const Names& names, std::string_view file, std::string& out);

/// Appends the line that says that events are missing here.
void append_dropped(std::uint64_t count, std::string& out);

} // namespace director
