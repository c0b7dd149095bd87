// Header: runtime/live/page.hpp. Test: tests/runtime/live/page_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/page.hpp"

namespace director::live {

namespace {

constexpr std::string_view before = "<meta http-equiv=\"Content-Security-Policy\" content=\"", after = "\">";

} // namespace

std::optional<Page> to_send(std::string_view html) {
  const std::size_t begin = html.find(before);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t policy = begin + before.size(), end = html.find(after, policy);
  if (end == std::string_view::npos || html.find('\n', policy) < end) return std::nullopt;
  Page out;
  out.policy = std::string(html.substr(policy, end - policy)) + "; connect-src 'self'; frame-ancestors 'none'";
  // The script searches this tag, and loads what it names from beside the page.
  out.html = std::string(html.substr(0, begin)) + "<meta name=\"director-live\" content=\"events\">" +
             std::string(html.substr(end + after.size()));
  return out;
}

} // namespace director::live
