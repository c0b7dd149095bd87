#pragma once
// SPDX-License-Identifier: MIT
// Random behaviours that are small enough to be explored completely, with many things that never happen: needs that
// lead to groups held by others, plans with alternatives, packs with optional and apart members, states that only a
// promise can bring about, handlers that set them, equal priorities. Everything follows from the seed. Not all of them
// can be run.

#include "tests/property/draft.hpp"
#include "tests/property/random.hpp"

namespace director::property {

BehaviourDraft small_behaviour(std::uint64_t seed);

} // namespace director::property
