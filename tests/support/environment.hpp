#pragma once
// SPDX-License-Identifier: MIT
// Random cases: how many, from which on, and whether all of them, the environment may say.

#include <cstdlib>
#include <string>

namespace director::tests {

/// A number that the environment names, such as DIRECTOR_CASES.
template <class Number>
Number from_environment(const char* name, Number otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<Number>(std::stoull(text));
}

/// `./test --long`: random series are played whole.
inline bool is_long() { return std::getenv("DIRECTOR_LONG") != nullptr; }

} // namespace director::tests
