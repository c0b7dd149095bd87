#pragma once
// SPDX-License-Identifier: MIT
// The settings of a bridge, and its reports. All names are resolved when the bridge is made, and never compared in a
// step.

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

/// The program uses a name that the behaviour does not have, or the middleware fails: what() says which. Thrown only by
/// the constructors of Bridge and Asker.
struct Failure final : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The most bytes that a robot accepts, of a name and of the data of a request.
inline constexpr std::size_t longest_name = 255, longest_data = 64 * 1024;

/// A state of another robot that is copied to an external state of this one. Values are compared by name, not by
/// number.
struct TakeIn {
  std::string robot{};
  std::string state{};     ///< its name there
  std::string into{};      ///< and its name here
  std::string behaviour{}; ///< of that robot; empty: the name of this one
};

/// A request of another process.
struct Asked {
  std::string_view asker{}; ///< the name of the asker
  bool cancel = false;      ///< false: it requests the task
  std::string_view level{}; ///< empty: the first
  std::span<const std::byte> data{};
};

/// A root task that others may request and cancel.
struct Offer {
  std::string task{};
  /// Posts the request, from the bridge's thread; false, or an exception: refused. Empty: the bridge posts it, at the
  /// task's first level, which is possible for a task without data.
  std::function<bool(const Asked&)> take{};
};

/// A report for the user. Each Kind says what happened to `robot`.
struct Notice {
  enum class Kind : std::uint8_t {
    joined,              ///< it is new
    restarted,           ///< it has another process now
    gone,                ///< its bridge ended
    lost,                ///< its process is not connected any more
    twin,                ///< another process uses the name of this one
    other_specification, ///< it runs a different behaviour with this name
    incompatible,        ///< another process offers a topic with an insufficient quality
    unknown_value,       ///< it published a value that the state here does not have
    bad_sample,          ///< it published an invalid sample
    refused,             ///< its request was not taken
    inbox_full,          ///< the inbox was full: an earlier value of it, or an input of another thread, was lost
    decisions_lost,      ///< of this robot: the outbox was full
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
  std::uint32_t domain = 0;           ///< of DDS: robots in other domains are not connected
  std::vector<std::string> publish{}; ///< states that other robots may take in
  std::vector<TakeIn> take_in{};
  std::vector<Offer> offer{};
  bool decisions = true; ///< publish decisions and promises
  std::chrono::milliseconds say_again{
      100}; ///< up to longest_say_again: the period in which states are repeated, as long as stepped() is called
  std::function<void(const Notice&)>
      notice{}; ///< called by one thread at a time, of the bridge's; must not throw; may be empty
};

/// The same without vectors, whose layout depends on how a program is compiled (_GLIBCXX_DEBUG).
struct SettingsView {
  SettingsView(const Settings& all)
      : robot(all.robot),
        domain(all.domain),
        publish(all.publish),
        take_in(all.take_in),
        offer(all.offer),
        decisions(all.decisions),
        say_again(all.say_again),
        notice(all.notice) {}

  std::string robot;
  std::uint32_t domain;
  std::span<const std::string> publish; ///< of the settings
  std::span<const TakeIn> take_in;      ///< likewise
  std::span<const Offer> offer;         ///< likewise
  bool decisions;
  std::chrono::milliseconds say_again;
  std::function<void(const Notice&)> notice;
};

} // namespace director::dds
