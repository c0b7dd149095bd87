#pragma once
// SPDX-License-Identifier: MIT
// The settings of a bridge, resolved against the behaviour: names have become rows. Errors: a Failure that tells of
// every mistake.

#include "runtime/dds/plug.hpp"
#include "runtime/dds/settings.hpp"

#include <map>
#include <optional>

namespace director::dds {

/// Where a state of another robot goes.
struct Taken {
  Index state = nil;
  std::map<std::string, std::int32_t, std::less<>> values; ///< by name; empty: it has numbers
  Domain domain;
  std::int32_t silent = unset; ///< what it becomes when its robot says goodbye: what its `expires` names
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

Plan resolve(const Settings& settings, const Plug& plug);

/// The number of a value that another robot says; nothing: the state does not have it.
std::optional<std::int32_t> number_of(const Taken& taken, std::string_view name);
std::optional<std::int32_t> number_of(const Taken& taken, std::int32_t number);

/// Equal for behaviours that decide alike and mean the same by their names: a hash of the tables and of all names.
std::string specification_of(const Plug& plug);

} // namespace director::dds
