#pragma once
// Changes to files that belong to the user: all of them or none, each file at once, and none that somebody else has
// changed meanwhile.

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

struct Change {
  std::string path;
  std::optional<std::string> before; ///< nothing: there is no such file
  std::string after;
};

/// What went wrong, as "`path`: why", and then no file has changed. Each is written beside its place first, so that a
/// full disk shows before the first one takes it.
std::optional<std::string> apply_on_disk(const std::vector<Change>& changes);

} // namespace director::compiler::cli
