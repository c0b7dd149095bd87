// Header: runtime/dds/outbox.hpp. Test: tests/runtime/dds/outbox_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/outbox.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace director::dds {

namespace {

/// The highest power of two. No machine has that much memory, so that making the outbox fails.
constexpr std::size_t most_room = std::size_t{1} << (std::numeric_limits<std::size_t>::digits - 1);

} // namespace

Outbox::Outbox(std::size_t room, Observer next)
    : room_(std::bit_ceil(std::clamp(room, std::size_t{2}, most_room))),
      ring_(std::make_unique<Entry[]>(room_)),
      next_(next) {}

void Outbox::tell(const Event& event) {
  if (next_.tell != nullptr) next_.tell(next_.self, event);
  switch (event.kind) {
  case Event::Kind::input: // inputs and requests of bodies are not published: what follows from them is
  case Event::Kind::ask:
  case Event::Kind::keep:
  case Event::Kind::withdraw:
  case Event::Kind::wait:
  case Event::Kind::answer:
  case Event::Kind::assign:
  case Event::Kind::begin:
  case Event::Kind::given: return;
  case Event::Kind::set: // for the promises, which are no decisions
  case Event::Kind::broken: return put(event, 0);
  case Event::Kind::run:
  case Event::Kind::start:
  case Event::Kind::stop:
  case Event::Kind::done:
  case Event::Kind::failed:
  case Event::Kind::grant:
  case Event::Kind::lose:
  case Event::Kind::queue:
  case Event::Kind::push:
  case Event::Kind::release:
  case Event::Kind::refused:
  case Event::Kind::fault:
  case Event::Kind::exhausted:
  case Event::Kind::lost: return put(event, ++number_);
  }
}

void Outbox::put(const Event& event, std::uint64_t number) {
  const std::uint64_t end = end_.load(std::memory_order_relaxed);
  if (end - begin_.load(std::memory_order_acquire) == room_) {
    lost_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  ring_[end & (room_ - 1)] = {event, number};
  end_.store(end + 1, std::memory_order_release);
}

bool Outbox::take(Entry& out) {
  const std::uint64_t begin = begin_.load(std::memory_order_relaxed);
  if (begin == end_.load(std::memory_order_acquire)) return false;
  out = ring_[begin & (room_ - 1)];
  begin_.store(begin + 1, std::memory_order_release);
  return true;
}

} // namespace director::dds
