#pragma once
// SPDX-License-Identifier: MIT
// Behaviours of any size, as the text of their files.

#include <cstddef>
#include <string>

namespace bench {

/// Trees of ten groups that are live together: a robot with a walk, legs, six other parts, and a kick. A request of
/// Kick_<n> stops the walk of tree n softly (a push), takes the legs (a take-over) and gives them back.
std::string trees(std::size_t groups);

/// As behaviours/steal.yaml, with `waiting` more tasks behind the two that need the shared group.
std::string waiting(std::size_t tasks);

/// Independent root tasks.
std::string apart(std::size_t groups);

/// One root task that requests all others.
std::string together(std::size_t groups);

/// Root tasks `Unit_1` and so on, each of which requests four groups of ten providers together; every provider of the
/// last of the four needs the group that the root task `Holder` has.
std::string wide_units(std::size_t units);

} // namespace bench
