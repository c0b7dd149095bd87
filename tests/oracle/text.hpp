#pragma once
// SPDX-License-Identifier: MIT
// A Model from a behaviour's text, for tests.

#include "tests/oracle/parts.hpp"

namespace director::oracle {

/// Throws what the reader says of a text with a mistake in it.
Model model_of(const std::string& text);

} // namespace director::oracle
