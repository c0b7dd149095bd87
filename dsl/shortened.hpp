#pragma once
// SPDX-License-Identifier: MIT
// What messages repeat of a user's text, which may be of any length: as much as somebody reads.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// Bytes of what stands between two backquotes. Paths of people are shorter, and the source is shown below.
inline constexpr std::size_t longest_quotation = 500;
/// Bytes of a message, or of a line for people, with all that it quotes.
inline constexpr std::size_t longest_message = 5000;
inline constexpr std::size_t most_names_listed = 100;

/// The message, its quotations and then itself at most that long: of what is longer the beginning and the end, and a
/// `…` between them.
std::string shortened(std::string_view message);

/// "a, b, c"; of very many "a, b, c and 97 more".
std::string list_of(const std::vector<std::string>& names);

} // namespace director::dsl
