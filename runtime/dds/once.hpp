#pragma once
// SPDX-License-Identifier: MIT
// The requests that were received before: an asker repeats requests, and none may be carried out twice. For each
// session of an asker, the newest 64 numbers are remembered with their answers; older ones are never taken. Source: the
// window against replays of IPsec (RFC 4303, 3.4.3).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::dds {

class Once {
public:
  static constexpr std::uint64_t window = 64;
  static constexpr std::size_t most_askers = 64; ///< beyond that, the asker with the oldest request is forgotten

  enum class Verdict : std::uint8_t { first, repeated, too_old };
  struct Seen {
    Verdict verdict = Verdict::first;
    std::uint8_t answer = 0; ///< the answer to the first request, if this one repeats it
    bool operator==(const Seen&) const = default;
  };

  /// `number` counts from 1.
  Seen look(std::uint64_t session, std::uint64_t number);
  /// Notes the answer to a request that look() found to be the first.
  void note(std::uint64_t session, std::uint64_t number, std::uint8_t answer);

private:
  struct Asker {
    std::uint64_t session = 0;
    std::uint64_t highest = 0;
    std::uint64_t heard = 0;                    ///< the look() in which it was heard last
    std::array<std::uint8_t, window> answers{}; ///< one more than the answer; 0: not seen
  };
  Asker& asker(std::uint64_t session);

  std::vector<Asker> askers_;
  std::uint64_t looks_ = 0;
};

} // namespace director::dds
