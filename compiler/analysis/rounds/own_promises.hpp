#pragma once
// SPDX-License-Identifier: MIT
// Whether what a provider promises makes its own condition false where nothing pushes it, though its task is requested
// further. While it is pushed, its condition does not count.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/requests/earlier.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <map>
#include <optional>
#include <set>

namespace director::analysis {

class OwnPromises {
public:
  explicit OwnPromises(const Input& input);

  /// Whether this promise of the waiter ends its task, and not also the request: the program's ends then.
  bool may_end(GroupId task, const Want& want, const ConditionUse& promise) const;

private:
  bool ends_unpushed(GroupId task, const Want& want, const Task& request) const;
  bool goes_before_at(GroupId first, GroupId second, const Task& request, const Task* Meeting::*side) const;
  std::map<ProviderId, std::set<GroupId>> find_pushers() const;

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Earlier earlier_;
  mutable std::optional<std::map<ProviderId, std::set<GroupId>>> pushers_;
};

} // namespace director::analysis
