// SPDX-License-Identifier: MIT
#include "compiler/explore/machine/packing.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace director::compiler;

namespace {

constexpr std::uint64_t nils = 0xffffffffffffffff;

std::vector<std::uint64_t> back_and_forth(const Packing& packing, const std::vector<std::uint64_t>& words) {
  Packed packed{7, 7, 7}; // existing content remains
  packing.pack(words.data(), packed);
  std::vector<std::uint64_t> out(words.size());
  packing.unpack(std::span(packed).subspan(3), out.data());
  return out;
}

std::size_t size_of(const Packing& packing, const std::vector<std::uint64_t>& words) {
  Packed packed;
  packing.pack(words.data(), packed);
  return packed.size();
}

} // namespace

TEST_CASE("a row that is packed comes back as it was") {
  std::mt19937_64 random(1);
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 65U, 300U}) {
    std::vector<std::uint64_t> first(count);
    for (std::uint64_t& word : first) word = random() % 3 == 0 ? nils : random() % 40;
    const Packing packing(first);
    CHECK(back_and_forth(packing, first) == first);
    for (int round = 0; round < 100; ++round) {
      std::vector<std::uint64_t> words = first;
      for (std::uint64_t& word : words) {
        switch (random() % 5) {
        case 0: word = random(); break;
        case 1: word = nils; break;
        case 2: word = random() % 100 << 32; break;
        default: break;
        }
      }
      REQUIRE(back_and_forth(packing, words) == words);
    }
  }
}

TEST_CASE("a row takes a few bytes for each word that differs, also where that was nil") {
  const Packing packing(std::vector<std::uint64_t>(64, nils));
  CHECK(size_of(packing, packing.first()) == 1);
  std::vector<std::uint64_t> words = packing.first();
  words[20] = nils << 32 | 5; // one half is a number now
  CHECK(size_of(packing, words) == 1 + 1 + 2);
  words[21] = std::uint64_t{7} << 32 | 5;
  CHECK(size_of(packing, words) == 1 + 1 + 2 + 3);
}
