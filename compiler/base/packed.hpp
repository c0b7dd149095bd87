#pragma once
// SPDX-License-Identifier: MIT
// Bytes made smaller, and bytes as letters. The library behind it, zlib, stays in packed.cpp.

#include <string>
#include <string_view>

namespace director::compiler {

/// The zlib format (RFC 1950), which browsers read as `deflate`. Equal bytes give equal bytes.
std::string packed(std::string_view bytes);

/// Four letters for three bytes, filled up with `=`. Source: RFC 4648, section 4.
std::string base64(std::string_view bytes);

} // namespace director::compiler
