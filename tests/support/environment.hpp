#pragma once
// SPDX-License-Identifier: MIT
// How much a test does: of random cases the environment may say how many, from which on, and whether all of them; and
// what a sanitizer makes slow.

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

/// Whether the address sanitizer is in this build: what works until a bound is reached takes five times as long there.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

} // namespace director::tests
