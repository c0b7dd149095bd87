#pragma once
// SPDX-License-Identifier: MIT
// Which requests were seen before: an asker repeats what was not answered, and nothing may be done twice. Of each
// asker's session the newest 64 numbers are remembered, and what was answered; older ones are never taken. Source: the
// window against replays of IPsec (RFC 4303, 3.4.3).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::dds {

class Once {
public:
  static constexpr std::uint64_t window = 64;
  static constexpr std::size_t most_askers = 64; ///< beyond that, who was not heard for longest is forgotten

  enum class Verdict : std::uint8_t { first, repeated, too_old };
  struct Seen {
    Verdict verdict = Verdict::first;
    std::uint8_t answer = 0; ///< of a repeated one
    bool operator==(const Seen&) const = default;
  };

  /// `number` counts from 1.
  Seen look(std::uint64_t session, std::uint64_t number);
  /// It was answered. After look() said that it is the first.
  void note(std::uint64_t session, std::uint64_t number, std::uint8_t answer);

private:
  struct Asker {
    std::uint64_t session = 0;
    std::uint64_t highest = 0;
    std::uint64_t heard = 0;                    ///< by the clock of looks
    std::array<std::uint8_t, window> answers{}; ///< one more than the answer; 0: not seen
  };
  Asker& asker(std::uint64_t session);

  std::vector<Asker> askers_;
  std::uint64_t looks_ = 0;
};

} // namespace director::dds
