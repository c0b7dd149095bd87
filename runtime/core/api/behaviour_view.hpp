#pragma once
// SPDX-License-Identifier: MIT
// Typed reading of a behaviour, between steps and from other threads. `Facts`: see program.hpp.

#include "runtime/core/inspect/double_buffer.hpp"
#include "runtime/core/inspect/why.hpp"

namespace director {

/// What a program may read between steps.
template <class Facts>
class BehaviourView {
public:
  /// Made by Program and Snapshot.
  explicit BehaviourView(const View& view) : view_(view) {}

  /// The state of the program's own request for this root task: running, queued or none.
  template <class Task>
  RunState state() const {
    static_assert(Facts::Roots::template has<Task>, "only tasks that stand in `roots` are requested from outside");
    return view_.state(Facts::Roots::template For<Task>::edge);
  }

  /// The requester that holds this task's group, if any.
  template <class Task>
  Holding holding() const {
    return view_.holding(row<Task>);
  }

  /// Why this task does not run. The generated `names::why` makes a sentence of it.
  template <class Task>
  Because why() const {
    return director::why(view_, row<Task>);
  }

  /// The number of inputs lost so far: refused by a full inbox, or replaced before they were taken. Modulo 2^32.
  std::uint32_t lost() const { return view_.lost; }

  /// The same by number.
  const View& view() const { return view_; }

private:
  template <class Task>
  static constexpr Index row = [] {
    static_assert(Facts::Groups::template has<Task>, "this is not a task of the behaviour");
    return Facts::Groups::template row<Task>;
  }();

  View view_;
};

/// What other threads can read of a behaviour: a copy of its state at the last `behaviour.show(snapshot)`. Any number
/// of threads may read it at any time, with up to 255 looks at once; no thread waits. It holds two copies.
template <class Facts>
class Snapshot {
public:
  Snapshot() = default;
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  /// Read access to the newest copy. Keep it short: show() cannot overwrite the copy while this object exists.
  class Look {
  public:
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
    ~Look() {
      if (buffer_ != nil) of_.buffers_.leave(buffer_);
    }
    explicit operator bool() const { return buffer_ != nil; } ///< false: nothing was shown yet, or 255 others look
    /// The state at that moment; only if the look is true.
    BehaviourView<Facts> operator*() const { return BehaviourView<Facts>(of_.views_[buffer_]); }

  private:
    friend Snapshot;
    explicit Look(const Snapshot& of) : of_(of), buffer_(of.buffers_.enter()) {}
    const Snapshot& of_;
    Index buffer_;
  };
  /// May be called from any thread, and never waits.
  Look look() const { return Look(*this); }

  /// To be called from the thread that calls step(). False: a thread still reads the older copy, and nothing changes.
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
