#pragma once
// SPDX-License-Identifier: MIT
// Shortens parts of messages that repeat the user's text, which may have any length.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// Limit in bytes for text between two backquotes. Real paths are shorter, and the source is printed below.
inline constexpr std::size_t longest_quotation = 500;
/// Limit in bytes for a message, or a printed line, with its quotations.
inline constexpr std::size_t longest_message = 5000;
inline constexpr std::size_t most_names_listed = 100;

/// Shortens the quotations of the message, then the message itself: what is too long keeps its beginning and its end,
/// with a `…` between them.
std::string shortened(std::string_view message);

/// "a, b, c"; of very many "a, b, c and 97 more".
std::string shortened_list(const std::vector<std::string>& names);

} // namespace director::dsl
