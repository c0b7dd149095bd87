#pragma once
// SPDX-License-Identifier: MIT
// Any YAML value as a scenario uses it for a task's data: comparable, and printed in flow style, `{x: 1, y: [a, b]}`.

#include <string>
#include <vector>

namespace director::dsl {

struct Data {
  enum class Kind { boolean, integer, real, text, list, mapping };
  Kind kind = Kind::text;
  std::string text;                         ///< of a scalar; integers in decimal, booleans `true` or `false`
  std::vector<std::string> keys;            ///< of a mapping, in the order written
  std::vector<Data> items;                  ///< of a list; of a mapping what belongs to `keys`
  bool operator==(const Data& other) const; ///< the order of a mapping does not count
};

std::string to_text(const Data& data);

} // namespace director::dsl
