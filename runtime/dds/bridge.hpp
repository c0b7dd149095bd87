#pragma once
// SPDX-License-Identifier: MIT
// Shares the states and tasks of a behaviour with other processes over DDS: what others publish is posted to the
// behaviour, its own states and decisions are published. It has two threads; the thread that steps never waits for the
// network. README.md has an example, and what happens when the network drops. Errors: a Failure from the constructor;
// notices later.
//
//   Outbox outbox;
//   team::Behaviour behaviour{player, outbox.observer()};
//   Bridge bridge{plug("team", behaviour, {...}), outbox, settings};
//   loop: behaviour.step(now); bridge.stepped();

#include "runtime/dds/outbox.hpp"
#include "runtime/dds/plug.hpp"
#include "runtime/dds/settings.hpp"

#include <memory>
#include <utility>

namespace director::dds {

class Bridge {
public:
  /// Behaviour and outbox must outlive it.
  Bridge(Plug plug, Outbox& outbox, const Settings& settings)
      : Bridge(SettingsView(settings), std::move(plug), outbox) {}
  /// Disposes all that this robot published.
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  /// To be called after each step, from the thread that steps. No lock, no allocation. While it is not called, states
  /// are not repeated.
  void stepped();

  Counts counts() const; ///< from any thread
  std::uint64_t session() const;

private:
  Bridge(SettingsView settings, Plug plug, Outbox& outbox);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace director::dds
