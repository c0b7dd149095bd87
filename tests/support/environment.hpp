#pragma once
// SPDX-License-Identifier: MIT
// Random cases: how many, and from which on, the environment may say.

#include <cstdlib>
#include <string>

namespace director::tests {

/// A number that the environment names, such as DIRECTOR_CASES.
template <class Number>
Number from_environment(const char* name, Number otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<Number>(std::stoull(text));
}

} // namespace director::tests
