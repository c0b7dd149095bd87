#pragma once
// SPDX-License-Identifier: MIT
// The notation of facts/*.yaml, explained at their beginning, in terms of our language.

#include "dsl/yaml/yaml_tree.hpp"
#include "tests/behaviours/robocup/graph.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::tests {

/// The value of a key, which must be there.
const dsl::YamlNode& at(const dsl::YamlNode& mapping, std::string_view key);
/// Its text; empty without the key.
std::string word(const dsl::YamlNode& mapping, std::string_view key);
/// The texts of a list; of the list at a key, none without it.
std::vector<std::string> words(const dsl::YamlNode& list);
std::vector<std::string> words(const dsl::YamlNode& mapping, std::string_view key);

std::string file_name(std::string_view module);  ///< skill::K1VisualKick -> skill_k1_visual_kick
std::string layer_of(const std::string& module); ///< skill::K1VisualKick -> skill
/// The emissions of a provider or a handler, in all branches, as conditions, sorted: `Pose == UP`, `WalkState` for any
/// value.
std::vector<std::string> emitted(const dsl::YamlNode& entry);
Provider provider_of(const dsl::YamlNode& entry);

} // namespace director::tests
