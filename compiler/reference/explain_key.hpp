#pragma once
// SPDX-License-Identifier: MIT
// Explains a key of the language with the text of its reference, docs/language.md, which is compiled in.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

/// The text of docs/language.md. Written at build time.
std::string_view language_page();

/// Without the targets of its links, which lead to other files; blocks of code stay as they are.
std::string page_without_links(std::string_view page);

/// The keys that the tables of a page document, sorted, each once.
std::vector<std::string> keys_of(std::string_view page);

/// The page's text about the key: its rows of tables, the sections that these link to, or other text that mentions it.
/// Empty if the page does not have it. Markdown, without links.
std::optional<std::string> explain_key(std::string_view page, std::string_view key);

} // namespace director::compiler
