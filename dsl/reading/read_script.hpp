#pragma once
// SPDX-License-Identifier: MIT
// Reads the scripted bodies of a scenario, the entries of `script`. The lists of requests and settings in it also occur
// in steps.

#include "dsl/reading/reader.hpp"
#include "dsl/scenario_spec.hpp"

#include <string_view>
#include <vector>

namespace director::dsl {

ScriptEntrySpec read_script_entry(Reader& reader, const YamlPair& pair);

/// `{Pose: standing, Charge: 3}`.
std::vector<SettingSpec> read_settings(Reader& reader, const YamlNode* node, std::string_view subject);

/// `[Legs, Kick: {level: urgent, data: 3, keep: true}]`; each item a name or a mapping. `keys`: the keys that an entry
/// may have.
std::vector<RequestSpec> read_requests(Reader& reader, const YamlNode* node, std::string_view subject,
                                       const Keys& keys);
/// `{Kick: {level: urgent}}`.
std::vector<RequestSpec> read_request_mapping(Reader& reader, const YamlNode& node, const Keys& keys);

/// `Walk.halting` as two words; the second is empty, at the end of the first, where there is no dot.
std::pair<Word, Word> split_at_dot(const Word& name, bool plain);

} // namespace director::dsl
