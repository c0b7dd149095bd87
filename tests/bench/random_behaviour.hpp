#pragma once
// SPDX-License-Identifier: MIT
// Random behaviours of one component, and random numbers that are the same on every machine.

#include <cstddef>
#include <cstdint>
#include <string>

namespace bench {

class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// A number from 0 on, less than `end`.
  std::uint32_t below(std::size_t end) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t mixed = (state_ >> 32 ^ state_) * 0x9e3779b97f4a7c15U;
    return static_cast<std::uint32_t>((mixed >> 32) * end >> 32);
  }
  bool percent(std::uint32_t chance) { return below(100) < chance; }

private:
  std::uint64_t state_;
};

/// The text of a behaviour of one component: leaves, which need nothing; skills, whose one to three providers need and
/// request leaves, with conditions and promises; planners, whose packs request skills and other planners. A third of
/// the planners are root tasks, at a low or a high level. `Tick` and `Tock` are its triggers, and each of its states is
/// external and has four values.
std::string random_behaviour(std::size_t groups, std::uint64_t seed);

} // namespace bench
