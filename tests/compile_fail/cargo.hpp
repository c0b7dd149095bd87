#pragma once

namespace porter_test {

/// The data of a task. With THROWING_MOVE it is what no task can carry.
struct Cargo {
  Cargo() = default;
#ifdef THROWING_MOVE
  Cargo(Cargo&&) {}
#else
  Cargo(Cargo&&) noexcept = default;
#endif
};

} // namespace porter_test
