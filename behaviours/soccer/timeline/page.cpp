// Header: behaviours/soccer/timeline/page.hpp. Test: tests/behaviours/soccer/timeline/timeline_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/timeline/page.hpp"

namespace {

constexpr std::size_t what_width = 9, who_width = 12;

std::string_view colour_of(std::string_view what) {
  if (what == "sensed" || what == "expired" || what == "requested" || what == "cancelled") return "\033[36m";
  if (what == "waits" || what == "pushed") return "\033[33m";
  if (what == "takes" || what == "fault" || what == "broken" || what == "refused") return "\033[31m";
  if (what == "done" || what == "failed" || what == "set") return "\033[32m";
  return "";
}

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

} // namespace

void Page::line(std::int64_t time, std::string_view what, std::string_view who, std::string_view words) {
  std::string text = padded(what, what_width);
  if (const std::string_view colour = colour_of(what); colours_ && !colour.empty())
    text = std::string(colour) + text + "\033[0m";
  text += "  ";
  text += words.empty() ? std::string(who) : padded(who, who_width) + "  " + std::string(words);
  const auto hundredths = static_cast<long long>(time / 10'000);
  std::fprintf(out_, "%4lld.%02lld s  %s\n", hundredths / 100, hundredths % 100, text.c_str());
}

void Page::aside(std::string_view words) {
  const char *on = colours_ ? "\033[2m" : "", *off = colours_ ? "\033[0m" : "";
  std::fprintf(out_, "%s      ...  %.*s%s\n", on, static_cast<int>(words.size()), words.data(), off);
}
