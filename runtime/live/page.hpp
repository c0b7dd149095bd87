#pragma once
// SPDX-License-Identifier: MIT
// A page of `directorc docs` as it is sent: a page in a file may ask for nothing, and says so itself; one that is sent
// may ask its own server, and is told where.

#include <optional>
#include <string>
#include <string_view>

namespace director::live {

struct Page {
  std::string html;
  std::string policy; ///< for the header Content-Security-Policy
};

/// Nothing: it is no page that `directorc docs` wrote.
std::optional<Page> to_send(std::string_view html);

} // namespace director::live
