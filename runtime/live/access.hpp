#pragma once
// SPDX-License-Identifier: MIT
// Who may look: a token that cannot be guessed, and names by which this computer may be called.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace director::live {

/// 128 random bits of the operating system, in hexadecimal digits; nothing: it has none.
std::optional<std::string> new_token();

/// Takes as long wherever they differ.
bool is_token(std::string_view given, std::string_view token);

/// The header Host names this computer in a way that no page of others can make a browser use: by an address, as
/// localhost, or by one of its own names. What else a name leads to, whoever owns the name decides, and may change his
/// mind (DNS rebinding).
bool is_own_host(std::string_view host, std::span<const std::string> names);

/// What this computer calls itself, alone and in its network: `robot7` and `robot7.local`.
std::vector<std::string> own_names();

/// The header Origin, where there is one, is that of a page from that host.
bool is_own_origin(std::string_view origin, std::string_view host);

} // namespace director::live
