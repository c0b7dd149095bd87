#pragma once
// SPDX-License-Identifier: MIT
// Whether what a page names exists: files, headings, commands and their options.

#include "tests/docs/markdown.hpp"

#include <string>
#include <vector>

namespace director::tests {

/// Links that lead nowhere, each as `PAGE:LINE: what is wrong`. Links to other sites are left alone.
std::vector<std::string> link_faults(const std::string& path, const Markdown& page);

/// Files and commands between backticks that do not exist. A file is what begins with a folder or script of the source
/// tree; what a build makes is left alone. A command begins with `directorc`.
std::vector<std::string> name_faults(const std::string& path, const Markdown& page);

/// Folders beside the page to which none of its links leads.
std::vector<std::string> folder_faults(const std::string& path, const Markdown& page);

} // namespace director::tests
