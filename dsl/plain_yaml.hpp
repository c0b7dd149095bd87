#pragma once
// Reads YAML as people write it nearly always, twenty times as fast as yaml-cpp does: blocks of keys and of dashes,
// brackets, words and quotes in one line, comments. It understands less than yaml-cpp, and says so; what it does read,
// yaml-cpp reads as the same tree without complaint. So nobody sees which of the two has read a file.

#include "dsl/span.hpp"
#include "dsl/yaml_node.hpp"

#include <optional>
#include <string_view>

namespace director::dsl {

/// Nothing where the text has a mistake, or anything out of the ordinary. `text` is UTF-8 without control characters.
std::optional<YamlNode> read_plain_yaml(FileId file, std::string_view text);

} // namespace director::dsl
