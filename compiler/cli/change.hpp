#pragma once
// SPDX-License-Identifier: MIT
// The one way in which files are written: all of a set or none, each file at once, and nothing is lost of what was
// there. What belongs to the user changes only if nobody else has changed it meanwhile; what is generated takes the
// place of nothing but what was generated before.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

/// To a file of the user.
struct Change {
  std::string path;
  std::optional<std::string> before; ///< nothing: there is no such file
  std::string after;
};

struct Output {
  std::string path, text;
  bool (*is_own)(std::string_view) = nullptr; ///< may what is there go? nullptr: whatever it is
  bool newest = false;                        ///< newer than everything afterwards, also where the text is the same
};

/// Whether a text is a depfile, in which no comment can say whose it is.
bool is_depfile(std::string_view text);

/// What is told why an output cannot take the place of something else.
extern const char* const foreign;

/// Called behind each file that is written beside its place, and behind each that has got there: tests end there.
using Watch = std::function<void()>;

/// SIGKILL and a loss of power cannot wait: between two files they leave the one new and the other old, each whole. No
/// file system replaces several files at once, and no compiler would read a journal of ours. Whoever generates, builds
/// or verifies next sees it, and what `stubs` puts in is only added: the next run adds the rest.
///
/// What went wrong, as "`path`: why", and then no file has changed. Each is written beside its place first, so that a
/// full disk shows before the first one takes it. What ends a program politely waits until all is done.
std::optional<std::string> apply_on_disk(const std::vector<Change>& changes, const Watch& watch = {});
/// The same. A file that has its text already is not touched.
std::optional<std::string> write_on_disk(const std::vector<Output>& outputs, const Watch& watch = {});

} // namespace director::compiler::cli
