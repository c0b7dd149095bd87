#pragma once
// SPDX-License-Identifier: MIT
// A Model from a behaviour's text, for tests.

#include "tests/oracle/parts.hpp"

namespace director::oracle {

/// Throws the messages of the reader for a text with errors.
Model model_of(const std::string& text);

} // namespace director::oracle
