// Header: compiler/explore/machine/packing.hpp. Test: tests/compiler/explore/machine/packing_test.cpp.
// SPDX-License-Identifier: MIT
//
// Words are in blocks of eight, and blocks in rows of eight. First comes a byte for each row: which of its blocks
// differ. Then for each of these a byte: which of its words do; and for each of them a byte, which of its bytes do, and
// these. Most words are two small numbers or nil, all bits set: 1 is added to both before, which makes nil small, too.
#include "compiler/explore/machine/packing.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace director::compiler {

namespace {

constexpr std::size_t block = 8, row_size = block * 8;

/// Adds 1 to each half, or subtracts it.
std::uint64_t shifted(std::uint64_t word, std::uint32_t by) {
  return ((word + (std::uint64_t{by} << 32)) & 0xffffffff00000000) | static_cast<std::uint32_t>(word + by);
}
std::uint64_t up(std::uint64_t word) { return shifted(word, 1); }
std::uint64_t down(std::uint64_t word) { return shifted(word, static_cast<std::uint32_t>(-1)); }

/// A bit for each byte that is not 0.
std::uint8_t bytes_of(std::uint64_t word) {
  constexpr std::uint64_t low = 0x7f7f7f7f7f7f7f7f;
  const std::uint64_t tops = (((word & low) + low) | word) & ~low;
  return static_cast<std::uint8_t>(((tops >> 7) * 0x0102040810204080) >> 56);
}

/// A bit for each word that differs.
unsigned differing(const std::uint64_t* now, const std::uint64_t* then, std::size_t count) {
  unsigned out = 0;
  for (std::size_t i = 0; i < count; ++i) out |= static_cast<unsigned>(now[i] != then[i]) << i;
  return out;
}
unsigned differing(const std::uint64_t* now, const std::uint64_t* then) {
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < block; ++i) any |= now[i] ^ then[i];
  return any == 0 ? 0 : differing(now, then, block); // in most blocks nothing does
}

/// Which bytes are not 0, and these. Returns the end. Without unpredictable branches: mostly it is the first byte of a
/// half, or of both.
std::uint8_t* write(std::uint64_t word, std::uint8_t* at) {
  const std::uint8_t bytes = bytes_of(word);
  *at++ = bytes;
  if ((bytes & 0xee) == 0) {
    *at = static_cast<std::uint8_t>(word);
    at += bytes & 1;
    *at = static_cast<std::uint8_t>(word >> 32);
    return at + (bytes >> 4);
  }
  for (unsigned byte = 0; byte < 8; ++byte) {
    *at = static_cast<std::uint8_t>(word >> 8 * byte);
    at += bytes >> byte & 1;
  }
  return at;
}

/// Visits the index of each set bit, in ascending order.
template <class Visit>
void each_bit(unsigned bits, Visit&& visit) {
  for (unsigned left = bits; left != 0; left &= left - 1) visit(static_cast<std::size_t>(std::countr_zero(left)));
}

} // namespace

Packing::Packing(std::vector<std::uint64_t> first)
    : first_(std::move(first)),
      written_((first_.size() + row_size - 1) / row_size + (first_.size() + block - 1) / block + 9 * first_.size() +
               1) {}

void Packing::pack(const std::uint64_t* words, Packed& out) const {
  const std::size_t count = first_.size();
  std::uint8_t* const rows = written_.data();
  std::uint8_t* at = rows + (count + row_size - 1) / row_size;
  std::fill(rows, at, std::uint8_t{0});
  for (std::size_t begin = 0; begin < count; begin += block) {
    const std::uint64_t *const now = words + begin, *const then = first_.data() + begin;
    const unsigned differ = count - begin < block ? differing(now, then, count - begin) : differing(now, then);
    if (differ == 0) continue;
    rows[begin / row_size] |= static_cast<std::uint8_t>(1U << begin / block % 8);
    *at++ = static_cast<std::uint8_t>(differ);
    each_bit(differ, [&](std::size_t i) { at = write(up(now[i]) ^ up(then[i]), at); });
  }
  out.insert(out.end(), rows, at);
}

void Packing::unpack(std::span<const std::uint8_t> packed, std::uint64_t* words) const {
  const std::size_t count = first_.size(), rows = (count + row_size - 1) / row_size;
  std::copy(first_.begin(), first_.end(), words);
  const std::uint8_t* at = packed.data() + rows;
  for (std::size_t r = 0; r < rows; ++r) {
    each_bit(packed[r], [&](std::size_t b) {
      each_bit(*at++, [&](std::size_t i) {
        std::uint64_t& word = words[r * row_size + b * block + i];
        std::uint64_t bits = 0;
        each_bit(*at++, [&](std::size_t byte) { bits |= std::uint64_t{*at++} << 8 * byte; });
        word = down(up(word) ^ bits);
      });
    });
  }
}

} // namespace director::compiler
