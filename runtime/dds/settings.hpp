#pragma once
// SPDX-License-Identifier: MIT
// What a program wants of a bridge, and what it is told. All names are checked when the bridge is made, and never
// compared again where a step could notice.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace director::dds {

/// The program asks for what the behaviour does not have, or the middleware cannot do what it is asked: what(), for
/// people, says which. Thrown only while a Bridge or an Asker is made.
struct Failure final : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// In bytes. No robot hears more: of a name, and of the data of a request.
inline constexpr std::size_t longest_name = 255, longest_data = 64 * 1024;

/// A state of another robot that becomes an external state of this one. Names of values count, not their numbers.
struct TakeIn {
  std::string robot{};
  std::string state{};     ///< what it is called there
  std::string into{};      ///< and here
  std::string behaviour{}; ///< of that robot; empty: of the same name as here
};

/// Something that another process asked for.
struct Asked {
  std::string_view asker{}; ///< the name that it gave itself
  bool cancel = false;      ///< false: it requests the task
  std::string_view level{}; ///< empty: the first
  std::span<const std::byte> data{};
};

/// A root task that others may request and cancel.
struct Offer {
  std::string task{};
  /// Posts what is asked, from the bridge's thread; false, or an exception: refused. Empty: the bridge posts it, at the
  /// task's first level, which is possible for a task without data.
  std::function<bool(const Asked&)> take{};
};

/// Something that a person should know. Each Kind says what happened to `robot`.
struct Notice {
  enum class Kind : std::uint8_t {
    joined,              ///< it was not there before
    restarted,           ///< it is another process now
    gone,                ///< it said goodbye
    lost,                ///< nothing is heard of its process any more
    twin,                ///< another process uses the name of this one
    other_specification, ///< it runs a behaviour of this name that decides otherwise
    incompatible,        ///< somebody offers a topic with a quality that is not enough
    unknown_value,       ///< it says a value that the state here does not have
    bad_sample,          ///< it says what cannot be meant
    refused,             ///< what it asked for was not taken
    inbox_full,          ///< what it says found no room, and something that was said before is lost
    decisions_lost,      ///< of this robot: more than the outbox had room for
    not_written,         ///< of this robot: the middleware did not take it
  };
  Kind kind = Kind::joined;
  std::string robot;
  std::string text; ///< one line
};

/// Numbers since the bridge was made.
struct Counts {
  std::uint64_t states_said = 0, states_heard = 0; ///< heard: posted to the behaviour
  std::uint64_t decisions_said = 0, decisions_lost = 0, promises_said = 0;
  std::uint64_t requests_taken = 0, requests_repeated = 0, requests_refused = 0;
  std::uint64_t unknown_values = 0, bad_samples = 0, inbox_full = 0, not_written = 0;
  bool operator==(const Counts&) const = default;
};

inline constexpr std::chrono::hours longest_say_again{24};

struct Settings {
  std::string robot{};                ///< unique in the team
  std::uint32_t domain = 0;           ///< of DDS: who has another one is not heard
  std::vector<std::string> publish{}; ///< states that the others may take in
  std::vector<TakeIn> take_in{};
  std::vector<Offer> offer{};
  bool decisions = true;                    ///< tell of decisions and promises
  std::chrono::milliseconds say_again{100}; ///< up to longest_say_again; states are said again as often as that, as
                                            ///< long as stepped() is called
  std::function<void(const Notice&)>
      notice{}; ///< called by one thread at a time, of the bridge's; must not throw; may be empty
};

} // namespace director::dds
