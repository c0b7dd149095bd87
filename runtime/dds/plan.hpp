#pragma once
// SPDX-License-Identifier: MIT
// The settings of a bridge, resolved against the behaviour: names become rows. Errors: a Failure with all mistakes.

#include "runtime/dds/plug.hpp"
#include "runtime/dds/settings.hpp"

#include <map>
#include <optional>

namespace director::dds {

/// The state here that takes in one of another robot.
struct Taken {
  Index state = nil;
  std::map<std::string, std::int32_t, std::less<>> values; ///< by name; empty: the values are numbers
  Domain domain;
  std::int32_t silent = unset; ///< its value when its robot ends: that of `expires`
};

struct Offered {
  Index edge = nil;
  std::function<bool(const Asked&)> take;
};

/// robot, behaviour, state
using StateKey = std::array<std::string, 3>;

struct Plan {
  std::vector<Index> published;
  std::map<StateKey, std::vector<Taken>> taken;
  std::map<std::string, Offered, std::less<>> offered; ///< by the task's name
};

Plan resolve(const SettingsView& settings, const Plug& plug);

/// The number of a value that another robot published; nothing: the state does not have it.
std::optional<std::int32_t> number_of(const Taken& taken, std::string_view name);
std::optional<std::int32_t> number_of(const Taken& taken, std::int32_t number);

/// Equal for behaviours that decide alike and have the same names: a hash of the tables and of all names.
std::string specification_of(const Plug& plug);

} // namespace director::dds
