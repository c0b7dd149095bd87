#pragma once
// SPDX-License-Identifier: MIT

namespace porter_test {

#if defined(ARRAY)
using Cargo = int[3];
#elif defined(REFERENCE)
using Cargo = int&;
#elif defined(CONSTANT)
using Cargo = const int;
#elif defined(INCOMPLETE)
struct Cargo;
#elif defined(NOTHING)
using Cargo = void;
#else
/// The data of a task. With a macro it is a type that no task can carry.
struct Cargo {
  Cargo() = default;
#ifdef THROWING_MOVE
  Cargo(Cargo&&) {}
#else
  Cargo(Cargo&&) noexcept = default;
#endif
#ifdef THROWING_DESTRUCTOR
  ~Cargo() noexcept(false) {}
#elif defined(OWNING)
  ~Cargo() {}
#else
  ~Cargo() = default;
#endif
#ifdef ABSTRACT
  virtual void carry() = 0;
#endif
};
#endif

} // namespace porter_test
