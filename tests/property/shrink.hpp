#pragma once
// SPDX-License-Identifier: MIT
// Reduces a failing case: removes whatever can be removed while it still fails.

#include "tests/property/generate.hpp"

#include <functional>

namespace director::property {

/// True if the documents can be run and still fail.
using Fails = std::function<bool(const Documents&)>;

/// A case from which nothing more can be removed, or the result after `most_tries`.
Documents shrink(Documents documents, const Fails& fails, int most_tries = 5'000);

} // namespace director::property
