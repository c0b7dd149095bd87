#pragma once
// SPDX-License-Identifier: MIT
// What a key of the language says, in the words of its reference, docs/language.md: that page is the one source, and is
// compiled in.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

/// The text of docs/language.md. Written at build time.
std::string_view language_page();

/// The keys that the tables of a page tell of, sorted, each once.
std::vector<std::string> keys_of(std::string_view page);

/// What the page says of the key: its rows of tables, the sections to which these lead, or what else speaks of it.
/// Nothing if the page does not know it. Markdown, without links.
std::optional<std::string> explain_key(std::string_view page, std::string_view key);

} // namespace director::compiler
