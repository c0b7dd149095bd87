#pragma once
// SPDX-License-Identifier: MIT
// Makes a failing case small: takes away whatever can go while it still fails.

#include "tests/property/generate.hpp"

#include <functional>

namespace director::property {

/// True where the documents can be run and still fail.
using Fails = std::function<bool(const Documents&)>;

/// A case from which nothing more can be taken, or what was reached after `most_tries`.
Documents shrink(Documents documents, const Fails& fails, int most_tries = 5'000);

} // namespace director::property
