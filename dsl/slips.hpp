#pragma once
// SPDX-License-Identifier: MIT
// Keys that the language does not have and that people write all the same, because other tools have them: for each what
// to write instead.

#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

struct Slip {
  std::vector<std::string> keys;
  std::string help;
};
using Slips = std::vector<Slip>;

/// The help for this key; null: it is none of them.
const std::string* help_for(const Slips& slips, std::string_view key);

const Slips& slips_of_file();
const Slips& slips_of_scenario_file();
const Slips& slips_of_cpp();
const Slips& slips_of_state();
const Slips& slips_of_group(); ///< and of a provider
const Slips& slips_of_task();
const Slips& slips_of_step();

/// What is wrong with a type that C++ or another language has itself where an enum is wanted, as help; null: none has
/// such a type.
const std::string* help_for_type(std::string_view type);

} // namespace director::dsl
