// Header: compiler/cli/system/progress.hpp. Test: tests/compiler/cli/system/progress_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::cli {

namespace {

constexpr std::chrono::milliseconds between_lines{200};

} // namespace

std::string progress_text(const SearchProgress& so_far, std::size_t bound, std::chrono::milliseconds elapsed) {
  const auto percent = [](double part, std::size_t whole) {
    return 100 * part / static_cast<double>(std::max<std::size_t>(whole, 1));
  };
  const auto states = static_cast<double>(so_far.states);
  const double explored = states - static_cast<double>(so_far.waiting);
  const double seconds = std::max(static_cast<double>(elapsed.count()) / 1e3, 1e-3);
  return fmt::format("{} states ({:.1f} % of the bound), {:.0f} % of them explored, {:.0f} a second, {:.1f} MB",
                     so_far.states, percent(states, bound), percent(explored, so_far.states), explored / seconds,
                     static_cast<double>(so_far.bytes) / 1e6);
}

Progress::~Progress() {
  if (is_shown_) console_.err << "\r\x1b[K" << std::flush;
}

std::function<void(const SearchProgress&)> Progress::shown() {
  if (!console_.err_colours) return {};
  return [this](const SearchProgress& so_far) { show(so_far); };
}

void Progress::show(const SearchProgress& so_far) {
  const Clock::time_point now = Clock::now();
  if (now - last_ < between_lines) return;
  last_ = now;
  const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(now - began_);
  console_.err << "\r\x1b[K" << progress_text(so_far, bound_, elapsed) << std::flush;
  is_shown_ = true;
}

} // namespace director::compiler::cli
