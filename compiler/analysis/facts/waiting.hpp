#pragma once
// SPDX-License-Identifier: MIT
// Which tasks ever wait for a condition, and for which providers' (semantics.md 4.4, "Refuse"): of a unit that is
// refused the first combination counts whose groups are available, whatever its conditions.

#include "compiler/analysis/facts/facts.hpp"

#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace director::analysis {

/// Whatever is there for the second one's needs is there for the first one's.
bool needs_no_more(const Provider& first, const Provider& second);

/// Of one moment: what the facts allow when it is asked.
class Waiting {
public:
  Waiting(const Model& model, const Facts& facts);

  /// Its conditions may be what a task for its group waits for. Not where an earlier one needs nothing that it does not
  /// need too, unless a push moves it to the front.
  bool may_be_first(ProviderId id) const;

  /// A task for this requested group may be refused for a condition, its own or that of another member of its unit.
  bool may_wait(GroupId group);

private:
  /// Where a task is asked for.
  struct Entry {
    ProviderId provider{};
    const Pack* pack = nullptr;
    bool in_unit = false;
  };

  /// A member of its unit may be refused for a condition.
  bool unit_waits(const Pack& pack);
  /// As far as conditions go it can be granted wherever it can be had at all.
  bool is_carefree(GroupId group, const Region& context);
  bool can_do_without(GroupId group, const Region& context, std::set<GroupId>& above) const;
  bool holds_always(GroupId group, const Region& context, std::set<GroupId>& seen) const;

  const Model& model_;
  const Facts& facts_;
  std::unordered_map<EdgeId, std::vector<Entry>> entries_;
  std::unordered_map<const Pack*, bool> unit_waits_;
  std::map<GroupId, bool> carefree_; ///< in its own context
};

} // namespace director::analysis
