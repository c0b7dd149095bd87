#pragma once
// SPDX-License-Identifier: MIT
// Parts of a document, written as they would stand in a file, in flow style.

#include "tests/property/document.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::defects {

using property::Node;

/// `{needs: [$0], tasks: [$0]}` with the words in place of $0 to $9. Words have no quotes, and none of `,[]{}` in them.
Node flow(std::string_view text, const std::vector<std::string>& words = {});

/// Only the words put in.
std::string fill(std::string_view text, const std::vector<std::string>& words);

} // namespace director::defects
