#pragma once
// SPDX-License-Identifier: MIT
// Which headers of libraries are read like the user's own: those that include a generated header, directly or not, as
// helpers for the bodies of a behaviour do. Other headers that `-isystem` finds may be large, and know no context.

namespace clang {
class Preprocessor;
} // namespace clang

namespace director::scanning {

/// Call it before the file is read. What follows such an `#include` no longer counts as a part of a system header.
void own_headers(clang::Preprocessor& preprocessor);

} // namespace director::scanning
