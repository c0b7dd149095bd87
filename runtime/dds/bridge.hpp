#pragma once
// SPDX-License-Identifier: MIT
// Shares the states and tasks of a behaviour with other processes over DDS: what they say of themselves is posted to
// the behaviour, what this one becomes and decides is told. Two threads of its own; whoever steps never waits for the
// network. README.md has an example, and says what happens when the network drops. Errors: a Failure from the
// constructor; later on, notices.
//
//   Outbox outbox;
//   team::Behaviour behaviour{player, outbox.observer()};
//   Bridge bridge{plug("team", behaviour, {...}), outbox, settings};
//   loop: behaviour.step(now); bridge.stepped();

#include "runtime/dds/outbox.hpp"
#include "runtime/dds/plug.hpp"
#include "runtime/dds/settings.hpp"

#include <memory>

namespace director::dds {

class Bridge {
public:
  /// Behaviour and outbox must outlive it.
  Bridge(Plug plug, Outbox& outbox, Settings settings);
  /// Says goodbye.
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  /// After each step, from the thread that steps. No lock, no allocation. Who does not call it any more falls silent.
  void stepped();

  Counts counts() const; ///< from any thread
  std::uint64_t session() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace director::dds
