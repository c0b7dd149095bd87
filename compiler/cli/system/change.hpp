#pragma once
// SPDX-License-Identifier: MIT
// The only place that writes files: all of a set or none, each file atomically, without losing what was there. A user's
// file changes only if it has not changed meanwhile; a generated file replaces nothing but an earlier one of its kind.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

/// A change to a file of the user.
struct Change {
  std::string path;
  std::optional<std::string> before; ///< empty: there is no such file
  std::string after;
};

struct Output {
  std::string path, text;
  bool (*is_own)(std::string_view) = nullptr; ///< whether the existing file may be replaced; null: any file
  bool newest = false;                        ///< newer than everything afterwards, even with equal text
};

/// Whether a text is a depfile, which has no comment that marks it as generated.
bool is_depfile(std::string_view text);

/// The message for an output that would replace a file of the user, or an output of another kind, with this text.
const char* why_not_replaced(std::string_view text);

/// Called after each file that is written beside its place, and after each move: tests end there.
using Watch = std::function<void()>;

/// SIGKILL and a loss of power cannot be deferred: between two files one may be new and the other old, each complete.
/// No file system replaces several files at once, and no compiler would read a journal. The next generate, build or
/// verify detects it, and `stubs` only adds: the next run adds the rest.
///
/// Returns what went wrong, as "`path`: why"; then no file has changed. Each is written beside its place first, so that
/// a full disk is detected before the first one is replaced. Signals that end the program are deferred until all is
/// done.
std::optional<std::string> apply_on_disk(const std::vector<Change>& changes, const Watch& watch = {});
/// The same. A file that has its text already is not touched.
std::optional<std::string> write_on_disk(const std::vector<Output>& outputs, const Watch& watch = {});

} // namespace director::compiler::cli
