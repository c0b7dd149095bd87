#pragma once
// SPDX-License-Identifier: MIT
// A page of `directorc docs` as it is sent: a page in a file may load nothing, by its own policy; one that is sent may
// load from its own server, whose address it gets.

#include <optional>
#include <string>
#include <string_view>

namespace director::live {

struct Page {
  std::string html;
  std::string policy; ///< for the header Content-Security-Policy
};

/// Nothing: the page was not written by `directorc docs`.
std::optional<Page> to_send(std::string_view html);

} // namespace director::live
