#pragma once
// SPDX-License-Identifier: MIT
// A text that leaves some of another's lines out and says so.

#include "tests/docs/markdown.hpp"

namespace director::tests {

/// What `shown` should be, of which a line `…` stands for any lines of `whole`, also for none: `shown` itself, if all
/// its other lines stand in `whole` as they should. Else as little is changed as possible, and what is left out stays
/// left out. Cost: the product of both lengths.
Lines shortened(const Lines& whole, const Lines& shown);

} // namespace director::tests
