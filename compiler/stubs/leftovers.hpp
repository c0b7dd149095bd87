#pragma once
// SPDX-License-Identifier: MIT
// Finds functions that implement nothing in the behaviour: of providers that are gone or renamed, or that belong to
// another module now. They are reported and not changed.

#include "compiler/stubs/merge.hpp"

#include <vector>

namespace director::compiler::stubs {

std::vector<Remark> leftovers(const Wanted& wanted, const Found& found);

} // namespace director::compiler::stubs
