#pragma once
// SPDX-License-Identifier: MIT
// A text that is marked as leaving out some lines of another.

#include "tests/docs/markdown.hpp"

namespace director::tests {

/// The corrected text for `shown`, in which a line `…` stands for any lines of `whole`, also for none: `shown` itself,
/// if all its other lines are in `whole` in order. Otherwise as little is changed as possible, and what is left out
/// remains left out. Cost: the product of both lengths.
Lines shortened(const Lines& whole, const Lines& shown);

} // namespace director::tests
