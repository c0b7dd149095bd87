// Header: compiler/explore/search/frontier.hpp. Test: tests/compiler/explore/search/frontier_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/search/frontier.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace director::compiler {

namespace {
constexpr std::size_t smallest_chunk = std::size_t{1} << 14, largest_chunk = std::size_t{1} << 22;
}

/// Each chunk is as large as all before it, so that few states take little memory and many are in few chunks.
void Frontier::add_chunk(std::size_t least) {
  if (!spare_.empty() && spare_.back().capacity() >= least) {
    chunks_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    return;
  }
  chunks_.emplace_back().reserve(std::max(std::clamp(bytes_, smallest_chunk, largest_chunk), least));
  bytes_ += chunks_.back().capacity();
}

void Frontier::push(const Waiting& waiting) {
  const Header header{waiting.watch, waiting.roots, static_cast<std::uint32_t>(waiting.state.size())};
  const std::size_t size = sizeof(Header) + waiting.state.size();
  if (chunks_.empty() || chunks_.back().capacity() - chunks_.back().size() < size) add_chunk(size);
  Bytes& chunk = chunks_.back();
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&header);
  chunk.insert(chunk.end(), bytes, bytes + sizeof(Header));
  chunk.insert(chunk.end(), waiting.state.begin(), waiting.state.end());
  ++size_;
}

void Frontier::first(std::size_t count, std::vector<Waiting>& out) const {
  out.clear();
  std::size_t at = begin_;
  auto chunk = chunks_.begin();
  for (count = std::min(count, size_); count != 0; --count) {
    if (at == chunk->size()) {
      ++chunk;
      at = 0;
    }
    Header header;
    std::memcpy(&header, chunk->data() + at, sizeof(Header));
    at += sizeof(Header);
    out.push_back({{chunk->data() + at, header.size}, header.watch, header.roots});
    at += header.size;
  }
}

void Frontier::drop(std::size_t count) {
  size_ -= count;
  while (count != 0) {
    Bytes& chunk = chunks_.front();
    for (; count != 0 && begin_ != chunk.size(); --count) {
      Header header;
      std::memcpy(&header, chunk.data() + begin_, sizeof(Header));
      begin_ += sizeof(Header) + header.size;
    }
    if (begin_ != chunk.size()) return;
    chunk.clear();
    begin_ = 0;
    spare_.push_back(std::move(chunk));
    chunks_.pop_front();
  }
}

} // namespace director::compiler
