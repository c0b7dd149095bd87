#pragma once
// SPDX-License-Identifier: MIT
// A behaviour in which a group may brake because of a push, or for want of the key.

#include <string>

namespace director::tests {

inline const std::string rover_with_key = R"(behaviour: rover
language: 1
states:
  Motion: {values: [still, rolling], initial: rolling}
  Key: {values: [off, on], initial: on, external: true}
roots: {Low: {priority: 10}, Photo: {priority: 20}, High: {priority: 30}}
groups:
  Low: {tasks: [Drive]}
  High: {tasks: [Drive]}
  Drive:
    providers:
      - {name: rolling, when: [Key == on], sets: [Motion == rolling]}
      - {name: braking, causing: [Motion == still]}
  Photo: {when: [Motion == still]}
)";

} // namespace director::tests
