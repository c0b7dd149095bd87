#pragma once
// SPDX-License-Identifier: MIT
// Finds comments that were written with a stub and are outdated: the provider's declarations have changed. They are
// reported and not changed.

#include "compiler/stubs/merge.hpp"

#include <vector>

namespace director::compiler::stubs {

/// Recognised by the place in brackets, `(soccer.yaml:12)`; after it, each line that begins with `- ` counts. What the
/// user has removed or written before it does not. Lines of the behaviour that have only moved are reported once for
/// each file.
std::vector<Remark> stale_comments(const Wanted& wanted, const Found& found, const Texts& texts);

} // namespace director::compiler::stubs
