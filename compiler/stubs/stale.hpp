#pragma once
// SPDX-License-Identifier: MIT
// Comments that were written with a stub and are not true any more: what the behaviour says of the provider has
// changed. They are reported and stay as they are.

#include "compiler/stubs/merge.hpp"

#include <vector>

namespace director::compiler::stubs {

/// Known by the place in brackets, `(soccer.yaml:12)`; of what follows it, each line that begins with `- ` counts. What
/// the user has left out or written before it does not. Lines of the behaviour that have only moved are told once for
/// each file.
std::vector<Remark> stale_comments(const Wanted& wanted, const Found& found, const Texts& texts);

} // namespace director::compiler::stubs
