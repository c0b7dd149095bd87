#pragma once
// SPDX-License-Identifier: MIT
// Compression, and bytes as letters. Only packed.cpp includes the library, zlib.

#include <string>
#include <string_view>

namespace director::compiler {

/// The zlib format (RFC 1950), which browsers read as `deflate`. Equal bytes give equal bytes.
std::string packed(std::string_view bytes);

/// Four letters for three bytes, padded with `=`. Source: RFC 4648, section 4.
std::string base64(std::string_view bytes);

} // namespace director::compiler
