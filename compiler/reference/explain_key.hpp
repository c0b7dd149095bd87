#pragma once
// SPDX-License-Identifier: MIT
// Explains a key of the language with the text of its reference, docs/language.md and docs/scenarios.md, which are
// compiled in.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

/// The texts of the two pages. Written at build time.
std::string_view language_page();
std::string_view scenarios_page();
/// Both.
std::string reference();

/// Without the targets of its links, which lead to other files; blocks of code stay as they are.
std::string page_without_links(std::string_view page);

/// The keys that the tables of the reference document, sorted, each once.
std::vector<std::string> keys_of(std::string_view page);

/// The reference's text about the key: its rows of tables, the sections that these link to, or other text that mentions
/// it. Empty if it is not there. Markdown, without links.
std::optional<std::string> explain_key(std::string_view page, std::string_view key);

} // namespace director::compiler
