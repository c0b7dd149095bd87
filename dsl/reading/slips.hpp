#pragma once
// SPDX-License-Identifier: MIT
// Keys that the language does not have, but other tools do: for each the right one.

#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

struct Slip {
  std::vector<std::string> keys;
  std::string help;
};
using Slips = std::vector<Slip>;

/// The help for this key; null if it is not in the list.
const std::string* help_for(const Slips& slips, std::string_view key);

const Slips& slips_of_file();
const Slips& slips_of_scenario_file();
const Slips& slips_of_cpp();
const Slips& slips_of_state();
const Slips& slips_of_group(); ///< and of a provider
const Slips& slips_of_task();
const Slips& slips_of_step();
const Slips& slips_of_input(); ///< an entry of `inputs`
const Slips& slips_of_case();
const Slips& slips_of_assertion();

/// Help for a type of C++ or another language in place of an enum; null if the type is in no such language.
const std::string* help_for_type(std::string_view type);

} // namespace director::dsl
