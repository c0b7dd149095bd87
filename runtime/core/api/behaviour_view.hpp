#pragma once
// SPDX-License-Identifier: MIT
// What a program sees of a behaviour, typed: between steps, and from other threads. `Facts`: see program.hpp.

#include "runtime/core/inspect/snapshot.hpp"
#include "runtime/core/inspect/view.hpp"
#include "runtime/core/inspect/why.hpp"

#include <array>

namespace director {

/// What one may ask between steps.
template <class Facts>
class BehaviourView {
public:
  /// By Program and Snapshot.
  explicit BehaviourView(const View& view) : view_(view) {}

  /// Of the program's own request for this root task: running, queued or none.
  template <class Task>
  RunState state() const {
    static_assert(Facts::Roots::template has<Task>, "only tasks that stand in `roots` are requested from outside");
    return view_.state(Facts::Roots::template For<Task>::edge);
  }

  /// Who holds this task's group.
  template <class Task>
  Holding holding() const {
    return view_.holding(row<Task>);
  }

  /// Why this task does not run. The generated `names::why` puts the answer into words.
  template <class Task>
  Because why() const {
    return director::why(view_, row<Task>);
  }

  /// How many inputs were lost so far: refused, as the inbox was full, or replaced by a later one before the engine
  /// took them. Counts on from 0 behind 2^32 - 1.
  std::uint32_t lost() const { return view_.lost; }

  /// By number.
  const View& view() const { return view_; }

private:
  template <class Task>
  static constexpr Index row = [] {
    static_assert(Facts::Groups::template has<Task>, "this is not a task of the behaviour");
    return Facts::Groups::template row<Task>;
  }();

  View view_;
};

/// What other threads see of a behaviour: what held when it was last told to show itself, `behaviour.show(snapshot)`.
/// Any number of threads may look, at any time; nobody waits. Holds two copies of what can be seen.
template <class Facts>
class Snapshot {
public:
  Snapshot() = default;
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  /// A look at the newest moment that was shown, which lasts as long as this object. Short ones are best: from the next
  /// moment that is shown on it is one at the older copy, which cannot take the moment after that while it lasts.
  class Look {
  public:
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
    ~Look() {
      if (buffer_ != nil) of_.buffers_.leave(buffer_);
    }
    explicit operator bool() const { return buffer_ != nil; } ///< false: nothing was shown yet
    /// What held at that moment; only where the look is true.
    BehaviourView<Facts> operator*() const { return BehaviourView<Facts>(of_.views_[buffer_]); }

  private:
    friend Snapshot;
    explicit Look(const Snapshot& of) : of_(of), buffer_(of.buffers_.enter()) {}
    const Snapshot& of_;
    Index buffer_;
  };
  /// From any thread; never waits.
  Look look() const { return Look(*this); }

  /// From the thread that calls step(). False: there is still a look at the older copy; nothing changes.
  bool show(const View& view) {
    const Index buffer = buffers_.begin();
    if (buffer == nil) return false;
    views_[buffer] = view.copy(memory_[buffer].data());
    buffers_.finish(buffer);
    return true;
  }

private:
  struct alignas(8) Buffer : std::array<std::byte, View::bytes(Facts::shape)> {};
  mutable DoubleBuffer buffers_;
  std::array<View, 2> views_;
  std::array<Buffer, 2> memory_;
};

} // namespace director
