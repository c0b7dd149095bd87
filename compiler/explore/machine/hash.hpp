#pragma once
// SPDX-License-Identifier: MIT
// Hashes of rows of words: two that differ get the same one with a chance of 2^-64.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace director::compiler {

__extension__ using Wide = unsigned __int128;

/// The product of two words, its halves folded into one.
inline std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
  const Wide product = Wide{a} * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

inline constexpr std::uint64_t salt[] = {0x2545f4914f6cdd1d, 0x9e3779b97f4a7c15, 0xbf58476d1ce4e5b9,
                                         0x94d049bb133111eb, 0x632be59bd9b4e019, 0xd6e8feb86659fd93,
                                         0xa0761d6478bd642f, 0xe7037ed1a0b428db};

/// A buffer for words that are appended, and their hash.
class Projection {
public:
  static constexpr std::size_t lanes = 4, stride = 2 * lanes;
  static constexpr std::size_t words_of(std::size_t bytes) { return (bytes + 7) / 8; }

  /// `words`: with space for all of them, and `stride` more.
  explicit Projection(std::uint64_t* words) : begin_(words), at_(words) {}
  /// Returns where they begin.
  template <class T>
  std::uint64_t* add(const T* rows, std::size_t count) {
    std::uint64_t* const begin = at_;
    const std::size_t bytes = count * sizeof(T);
    if (bytes == 0) return begin;
    at_ += words_of(bytes);
    at_[-1] = 0;
    std::memcpy(begin, rows, bytes);
    return begin;
  }
  void add(std::uint64_t word) { *at_++ = word; }
  /// The same for only a part of each row: part_of(row).
  template <class Row, class Part>
  std::uint64_t* add(const Row* rows, std::size_t count, Part&& part_of) {
    using T = std::decay_t<decltype(part_of(*rows))>;
    std::uint64_t* const begin = at_;
    if (count == 0) return begin;
    at_ += words_of(count * sizeof(T));
    at_[-1] = 0;
    auto* to = reinterpret_cast<unsigned char*>(begin);
    for (const Row* row = rows; row != rows + count; ++row, to += sizeof(T)) {
      const T part = part_of(*row);
      std::memcpy(to, &part, sizeof(T));
    }
    return begin;
  }
  std::uint64_t* end() const { return at_; }

  /// Four independent lanes, for parallel execution.
  std::uint64_t sum() {
    while (static_cast<std::size_t>(at_ - begin_) % stride != 0) add(0);
    std::uint64_t lane[lanes] = {salt[4], salt[5], salt[6], salt[7]};
    for (const std::uint64_t* word = begin_; word != at_; word += stride) {
      for (std::size_t l = 0; l < lanes; ++l) lane[l] = fold(word[2 * l] ^ salt[l], word[2 * l + 1] ^ lane[l]);
    }
    const auto count = static_cast<std::uint64_t>(at_ - begin_);
    return fold(fold(lane[0] ^ salt[0], lane[1] ^ salt[5]) ^ salt[2],
                fold(lane[2] ^ salt[1], lane[3] ^ salt[6]) ^ count);
  }

private:
  std::uint64_t *begin_, *at_;
};

} // namespace director::compiler
