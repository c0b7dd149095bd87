#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// 64 hexadecimal digits, as sha256sum prints them. Source: FIPS 180-4.
std::string sha256(std::string_view bytes);

} // namespace director::compiler
