#pragma once
// SPDX-License-Identifier: MIT
// Behaviours of any size, as the text of their files.

#include <cstddef>
#include <string>

namespace bench {

/// Trees of ten groups that live at once: a robot with a walk, legs, six other parts, and a kick. A request of
/// Kick_<n> stops the walk of tree n softly (a push), takes the legs (a steal) and gives them back.
std::string trees(std::size_t groups);

/// As behaviours/steal.yaml, and behind the two `waiting` tasks that want what they share.
std::string waiting(std::size_t tasks);

/// Root tasks that have nothing to do with each other.
std::string apart(std::size_t groups);

/// One root task that requests all others.
std::string together(std::size_t groups);

/// Root tasks `Unit_1` and so on, each of which requests four groups of ten providers together; whatever runs in the
/// last of the four needs what the root task `Holder` has.
std::string wide_units(std::size_t units);

} // namespace bench
