#pragma once
// SPDX-License-Identifier: MIT
// How much a test does: of random cases the environment may say how many, from which on, and whether all of them; and
// what a sanitizer makes slow.

#include <cstdint>
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

/// What is not optimised, as with a sanitizer, takes ten times as long or more.
#ifdef NDEBUG
inline constexpr bool is_slow = false;
#else
inline constexpr bool is_slow = true;
#endif

/// How many random cases a test plays.
struct Series {
  std::uint64_t usual;
  std::uint64_t slow;          ///< in a slow build
  std::uint64_t whole = usual; ///< with `./test --long`; a slow build plays ten times as many as otherwise
};
inline std::uint64_t cases_of(const Series& series) {
  const std::uint64_t whole = is_slow ? 10 * series.slow : series.whole;
  return from_environment("DIRECTOR_CASES", is_long() ? whole : is_slow ? series.slow : series.usual);
}

} // namespace director::tests
