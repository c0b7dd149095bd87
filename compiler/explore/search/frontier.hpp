#pragma once
// SPDX-License-Identifier: MIT
// A queue of the states that are not explored yet, in the order of discovery, as contiguous bytes.

#include "compiler/explore/machine/packing.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace director::compiler {

/// A state in the queue.
struct Waiting {
  std::span<const std::uint8_t> state; ///< Packed
  std::uint64_t watch = 0;             ///< what is remembered beside it
  std::uint32_t roots = 0;             ///< row of Searched::root_sets
};

class Frontier {
public:
  void push(const Waiting& waiting);
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// The first ones, `count` or all. They stay valid until they are dropped.
  void first(std::size_t count, std::vector<Waiting>& out) const;
  void drop(std::size_t count);
  /// Memory, including dropped chunks that will be reused.
  std::size_t bytes() const { return bytes_; }

private:
  using Bytes = std::vector<std::uint8_t>;
  struct Header {
    std::uint64_t watch;
    std::uint32_t roots, size;
  };
  void add_chunk(std::size_t least);

  std::deque<Bytes> chunks_; ///< none ever grows
  std::vector<Bytes> spare_;
  std::size_t begin_ = 0; ///< of the first state, in the first chunk
  std::size_t size_ = 0, bytes_ = 0;
};

} // namespace director::compiler
