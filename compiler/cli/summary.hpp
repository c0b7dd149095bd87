#pragma once
// A check in a sentence.

#include <string>
#include <string_view>

namespace director::compiler::cli {

/// The first sentence of a page's first paragraph behind its heading and its level.
std::string summary(std::string_view page);

} // namespace director::compiler::cli
