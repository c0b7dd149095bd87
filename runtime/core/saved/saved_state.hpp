#pragma once
// SPDX-License-Identifier: MIT
// The decision state of an engine as bytes, to be put into another engine, or into the same one later: a program, a
// simulator or a debugger goes on from there as if nothing had been between. Written are requests, values, timers, who
// holds what and why not, who is to run: all that decides, and why requests are queued. Not written are the inbox,
// which has to be empty, what was lost so far, budgets, counters of work, and the observer; those of the engine that
// loads stay as they are.
//
// Whatever the bytes are, reading them is safe: behind a check sum and the behaviour's fingerprint every number is
// compared with the tables before anything is changed (saved_check.cpp). A state made by hand can make the engine
// decide what it would not have decided, but never read or write elsewhere, and never go round without end.

#include "runtime/core/saved/saved_rows.hpp"

namespace director {

/// What came of save().
enum class SaveResult : std::uint8_t {
  saved,
  too_small,   ///< the span has fewer bytes than a state takes
  inputs_wait, ///< inputs were posted that no step has taken yet: they are no part of what is saved
  refused,     ///< called from inside a body, handler or observer, in a program without assertions
};

/// What came of load(). But for `loaded` nothing has changed.
enum class LoadResult : std::uint8_t {
  loaded,
  truncated,       ///< these are not all of the bytes that were saved
  other_version,   ///< this is no saved state, or one of another version of Director or another kind of machine
  damaged,         ///< the check sum says that the bytes are not those that were saved
  other_behaviour, ///< saved by another behaviour, another version of this one, or with other types of data
  impossible,      ///< no state that this behaviour could be in: it was not made by save()
  refused,         ///< called from inside a body, handler or observer, in a program without assertions
};

/// A line for people, with what to do.
constexpr const char* to_text(SaveResult result) {
  switch (result) {
  case SaveResult::saved: return "saved";
  case SaveResult::too_small: return "not saved: the span is smaller than Behaviour::saved_bytes()";
  case SaveResult::inputs_wait:
    return "not saved: inputs wait in the inbox; call step() first, and post nothing until the state is saved";
  case SaveResult::refused:
    return "not saved: called from inside a body, handler or observer; save between two calls of step()";
  }
  return "";
}

/// A line for people, with what to do.
constexpr const char* to_text(LoadResult result) {
  switch (result) {
  case LoadResult::loaded: return "loaded";
  case LoadResult::truncated: return "not loaded: bytes are missing at the end; give all that save() wrote";
  case LoadResult::other_version:
    return "not loaded: no saved state, or one of another version of Director, another byte order or another "
           "DIRECTOR_SMALL_INDEX; save it again with this program";
  case LoadResult::damaged:
    return "not loaded: the check sum does not fit, the bytes have changed since they were saved";
  case LoadResult::other_behaviour:
    return "not loaded: saved by another behaviour, by another version of it, or with data of other types; save it "
           "again with this program";
  case LoadResult::impossible:
    return "not loaded: the behaviour cannot be in such a state, the bytes were not made by save()";
  case LoadResult::refused:
    return "not loaded: called from inside a body, handler or observer; load between two calls of step()";
  }
  return "";
}

namespace saved {

// For api/saved_data.hpp, which adds the data of tasks.

/// All but the data and the check sum, into the first `size` of these bytes.
SaveResult write_decisions(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour, std::size_t size);
/// The check sum, when all else is written; into all of these bytes.
void seal(std::span<std::byte> to);

/// Whether these bytes, of which `size` are needed, can be loaded, but for the data.
LoadResult can_load(const Engine& engine, std::span<const std::byte> from, std::uint64_t behaviour, std::size_t size);
/// All but the data, from bytes that can be loaded.
void read_decisions(Engine& engine, const std::byte* from, Time now);

/// CRC-32, as zlib and Ethernet have it.
std::uint32_t check_sum(std::span<const std::byte> bytes);

/// One more number.
constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t number) {
  for (int i = 0; i < 64; i += 8) hash = (hash ^ (number >> i & 0xFF)) * 0x100000001b3;
  return hash;
}

} // namespace saved

// For engines without generated code, which keep the data of tasks, if there are any, themselves. `behaviour`: a number
// that tells it from others, such as director::fingerprint of runtime/hosted.

/// Bytes that a state without data takes.
constexpr std::size_t saved_bytes(const Shape& shape) { return saved::Layout(shape).data; }

/// Into the first saved_bytes(shape) of these bytes. From the thread that steps, between steps.
[[nodiscard]] SaveResult save(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour);

/// All timers are moved, so that what was due in 3 s is due 3 s after `now`. No body and no handler is called.
[[nodiscard]] LoadResult load(Engine& engine, std::span<const std::byte> from, Time now, std::uint64_t behaviour);

} // namespace director
