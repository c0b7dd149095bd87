#pragma once
// SPDX-License-Identifier: MIT
// The conditions of providers, and units that wait for one. docs/semantics.md, sections 4.3 and 4.4, Refuse.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

DIRECTOR_PART void refuse(Context& x, Index count);
bool stays(const Context& x, Index provider);
DIRECTOR_PART Index find_false(const Context& x, Index provider, Index edge);

/// The first condition that prevents the provider from running for an edge, or nil.
inline Index first_false(const Context& x, Index provider, Index edge) {
  return x.t.providers[provider].when.empty() ? nil : find_false(x, provider, edge);
}

} // namespace director::arbitration
