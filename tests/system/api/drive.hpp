#pragma once
// SPDX-License-Identifier: MIT
// A random program around two behaviours, the courier and the night watch. It does what the interface allows and much
// that it does not: bodies, handlers and observers throw, call the behaviour that runs them and post to both; time goes
// backwards, far and to its ends; inboxes are full; budgets are small. What must hold nevertheless is checked on the
// way, and `wrong` has what did not. Equal seeds do the same, unless other threads post.

#include "night_watch.hpp"
#include "tests/property/random.hpp"
#include "tests/system/api/office.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace director::tests {

/// Of one behaviour: what was accepted and what was taken.
struct Tally {
  std::atomic<std::uint32_t> fired{0}; ///< accepted, from any thread
  std::uint32_t heard = 0, lost = 0;   ///< events of the observer
  std::uint64_t runs = 0;
};

class Drive {
public:
  /// `alone`: no other thread does anything until the end.
  explicit Drive(std::uint64_t seed, bool alone = true);
  ~Drive();
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// So many actions, one after another. It stops once something is wrong.
  void go_on(int turns);
  /// No faults any more, all is cancelled and comes to rest; then the counts must agree. No other thread may post any
  /// more.
  void end();
  std::string wrong() const;

  /// The actions of another thread on both; true if it saw an impossible snapshot.
  bool disturb(property::Random& random);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace director::tests
