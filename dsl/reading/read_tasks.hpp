#pragma once
// SPDX-License-Identifier: MIT
// Reads what may be requested: the entries of `tasks`, of packs and of `roots`; and `allow`, which may stand on them.

#include "dsl/reading/reader.hpp"
#include "dsl/spec.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace director::dsl {

/// A list of names or a mapping. Nothing if the node is absent or neither.
std::optional<std::vector<TaskSpec>> read_tasks(Reader& reader, const YamlNode* node, std::string_view subject);

std::optional<std::vector<PackSpec>> read_packs(Reader& reader, const YamlNode* node);

/// `allow` and `because` of a thing's mapping.
std::vector<AllowSpec> read_allow(Reader& reader, const YamlNode& mapping);

} // namespace director::dsl
