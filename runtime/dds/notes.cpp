// Header: runtime/dds/notes.hpp. Test: tests/runtime/dds/notes_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/notes.hpp"

#include <utility>

namespace director::dds {

namespace {

constexpr std::size_t most_reported = 1000;
constexpr std::size_t longest = 60;

} // namespace

void Notes::count(std::uint64_t Counts::*what, std::uint64_t by) {
  const std::lock_guard lock(mutex_);
  counts_.*what += by;
}

void Notes::set(std::uint64_t Counts::*what, std::uint64_t to) {
  const std::lock_guard lock(mutex_);
  counts_.*what = to;
}

Counts Notes::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void Notes::report(Notice::Kind kind, std::string_view robot, std::string text) {
  if (!report_) return;
  const std::lock_guard lock(reporting_);
  report_({.kind = kind, .robot = shown(robot), .text = std::move(text)});
}

void Notes::report_once(Notice::Kind kind, std::string_view robot, const std::string& text) {
  {
    const std::lock_guard lock(mutex_);
    if (reported_.size() >= most_reported || !reported_.insert(shown(robot) + ' ' + text).second) return;
  }
  report(kind, robot, text);
}

std::string shown(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, longest)) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  if (text.size() > longest) out += "...";
  return out;
}

} // namespace director::dds
