#pragma once
// SPDX-License-Identifier: MIT
// The commands of viewers to a behaviour, if the program allows them: the functions of its Post, by number.

#include "runtime/core/base/tables.hpp"

#include <functional>

namespace director::live {

/// Each may be called from any thread, as Post may; empty: not allowed.
struct Commands {
  std::function<bool(Index edge, Index level)> request = {};
  std::function<bool(Index edge)> cancel = {};
  std::function<bool()> cancel_all = {};
  std::function<bool(Index state, std::int32_t value)> set = {};

  explicit operator bool() const { return request != nullptr; }
};

} // namespace director::live
