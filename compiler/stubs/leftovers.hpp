#pragma once
// SPDX-License-Identifier: MIT
// What a program implements although its behaviour does not ask for it: of providers that are gone or called otherwise,
// or that belong to another module now. It is reported and stays where it is.

#include "compiler/stubs/merge.hpp"

#include <vector>

namespace director::compiler::stubs {

std::vector<Remark> leftovers(const Wanted& wanted, const Found& found);

} // namespace director::compiler::stubs
