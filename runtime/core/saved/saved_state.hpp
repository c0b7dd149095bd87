#pragma once
// SPDX-License-Identifier: MIT
// The decision state of an engine as bytes, to be loaded into another engine, or into the same one later, which
// continues as if it had not been interrupted. Saved are requests, values, timers, the assignment, the run queue, and
// why requests are queued. Not saved are the inbox, which has to be empty, lost inputs, budgets, counters of work, and
// the observer; the engine that loads keeps its own.
//
// Reading is safe for any bytes: after a check sum and the fingerprint of the behaviour, every number is compared with
// the tables before anything is changed (saved_check.cpp). A state made by hand can make the engine decide differently,
// but never access other memory or loop forever.

#include "runtime/core/saved/saved_rows.hpp"

namespace director {

/// The result of save().
enum class SaveResult : std::uint8_t {
  saved,
  too_small,   ///< the span is smaller than a state
  inputs_wait, ///< inputs wait that no step has taken yet, which are not saved
  refused,     ///< called from inside a body, handler or observer, in a program without assertions
};

/// The result of load(). Except for `loaded`, nothing has changed.
enum class LoadResult : std::uint8_t {
  loaded,
  truncated,       ///< bytes are missing at the end
  other_version,   ///< no saved state, or one of another version of Director or another kind of machine
  damaged,         ///< the bytes have changed since they were saved
  other_behaviour, ///< saved by another behaviour, another version of this one, or with other types of data
  impossible,      ///< no possible state of this behaviour: not made by save()
  refused,         ///< called from inside a body, handler or observer, in a program without assertions
};

/// A sentence for the user, with what to do.
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

/// A sentence for the user, with what to do.
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

/// Writes all but the data and the check sum, into the first `size` of these bytes.
SaveResult write_decisions(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour, std::size_t size);
/// Writes the check sum, of all of these bytes, when they are complete.
void seal(std::span<std::byte> to);

/// Whether these bytes, of which `size` are needed, can be loaded, without a check of the data.
LoadResult can_load(const Engine& engine, std::span<const std::byte> from, std::uint64_t behaviour, std::size_t size);
/// Loads all but the data, from bytes that can be loaded.
void read_decisions(Engine& engine, const std::byte* from, Time now);

/// CRC-32, as zlib and Ethernet have it.
std::uint32_t check_sum(std::span<const std::byte> bytes);

/// Adds a number to the hash.
constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t number) {
  for (int i = 0; i < 64; i += 8) hash = (hash ^ (number >> i & 0xFF)) * 0x100000001b3;
  return hash;
}

} // namespace saved

// For engines without generated code, which handle the data of tasks, if any, themselves. `behaviour`: a number that
// differs between behaviours, such as director::fingerprint of runtime/hosted.

/// The size of a state without data.
constexpr std::size_t saved_bytes(const Shape& shape) { return saved::Layout(shape).data; }

/// Writes the first saved_bytes(shape) of these bytes. From the thread that calls step(), between steps.
[[nodiscard]] SaveResult save(const Engine& engine, std::span<std::byte> to, std::uint64_t behaviour);

/// Loads a state. What was due in 3 s is due 3 s after `now`. No body and no handler is called.
[[nodiscard]] LoadResult load(Engine& engine, std::span<const std::byte> from, Time now, std::uint64_t behaviour);

} // namespace director
