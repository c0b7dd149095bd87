#pragma once
// SPDX-License-Identifier: MIT
// Access control: a token that cannot be guessed, and the names of this computer.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace director::live {

/// 128 random bits of the operating system, in hexadecimal digits; nothing: it has none.
std::optional<std::string> new_token();

/// Compares in a time that does not depend on the first difference.
bool is_token(std::string_view given, std::string_view token);

/// Whether the header Host has an address, localhost, or one of the computer's own names. Any other name is controlled
/// by its owner, who may point it to this computer, so that pages of others could read from it (DNS rebinding).
bool is_own_host(std::string_view host, std::span<const std::string> names);

/// The names of this computer, alone and in its network: `robot7` and `robot7.local`.
std::vector<std::string> own_names();

/// Whether the header Origin, if there is one, is that of a page from that host.
bool is_own_origin(std::string_view origin, std::string_view host);

} // namespace director::live
