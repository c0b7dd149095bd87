#pragma once
// SPDX-License-Identifier: MIT
// The level of a recorded request, in another version of the behaviour, where it may have another place and name.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

namespace director::compiler {

/// The level at which `edge` of the version `to` is requested: the one that the same pack names so, or the pack's first
/// one if it had no name; else one with the same priority, `optional` and `apart`, of that pack if it is still there.
/// nil: none, so it is unknown. `request`, and `answer` of the run that makes it, have the rows of the version
/// `from`, which must have level_uses; of a request of root, `answer` does not count.
Index same_level(const director::Names& from, const Event& request, const Event& answer, const director::Names& to,
                 Index edge);

} // namespace director::compiler
