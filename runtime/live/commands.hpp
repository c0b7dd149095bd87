#pragma once
// SPDX-License-Identifier: MIT
// What viewers may do to a behaviour, where the program lets them: the words of its Post, by number.

#include "runtime/core/base/tables.hpp"

#include <functional>

namespace director::live {

/// Each may be called from any thread, as Post may; empty: nobody lets them.
struct Commands {
  std::function<bool(Index edge, Index level)> request = {};
  std::function<bool(Index edge)> cancel = {};
  std::function<bool()> cancel_all = {};
  std::function<bool(Index state, std::int32_t value)> set = {};

  explicit operator bool() const { return request != nullptr; }
};

} // namespace director::live
