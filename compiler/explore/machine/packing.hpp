#pragma once
// SPDX-License-Identifier: MIT
// Compresses rows of words that are similar to a first one: only the bytes that differ, and their places.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director::compiler {

/// Bytes of a state, packed.
using Packed = std::vector<std::uint8_t>;

class Packing {
public:
  explicit Packing(std::vector<std::uint64_t> first = {});
  const std::vector<std::uint64_t>& first() const { return first_; }

  /// Appends to `out`. `words`: as many as the first row has.
  void pack(const std::uint64_t* words, Packed& out) const;
  void unpack(std::span<const std::uint8_t> packed, std::uint64_t* words) const;

private:
  std::vector<std::uint64_t> first_;
  mutable Packed written_;
};

} // namespace director::compiler
