#pragma once
// SPDX-License-Identifier: MIT
// What the parts of a comparison share: the two behaviours, the changes so far, and how things are matched.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/diff/change.hpp"
#include "compiler/pipeline.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace director::compiler::diff {

/// What may ever happen in one of the behaviours, its impossible conditions as they are. Computed on first use: most of
/// it takes longer than comparing.
class Possible {
public:
  explicit Possible(const Checked& checked) : checked_(checked) {}
  const analysis::Facts& facts() const;
  /// By the group that waits: the providers that its task may push.
  const std::map<GroupId, std::set<ProviderId>>& pushes() const;

private:
  const Checked& checked_;
  mutable std::optional<analysis::Facts> facts_;
  mutable std::optional<std::map<GroupId, std::set<ProviderId>>> pushes_;
};

/// Two behaviours without errors in text and names, whose places are in one set of sources.
struct Pair {
  const Checked& before;
  const Checked& after;
  const Model& old_model = before.model;
  const Model& new_model = after.model;
  const Possible possible_before{before}, possible_after{after};
};

class Changes {
public:
  BehaviourChange& add(ChangeKind kind, std::string subject, std::string message, std::optional<Span> before,
                       std::optional<Span> after) {
    all_.push_back({kind, std::move(subject), std::move(message), before, after, false, {}});
    return all_.back();
  }
  const std::vector<BehaviourChange>& all() const { return all_; }
  /// Returns the changes, the most dangerous first; of one kind in the order of discovery.
  std::vector<BehaviourChange> take() {
    std::stable_sort(all_.begin(), all_.end(),
                     [](const BehaviourChange& a, const BehaviourChange& b) { return a.kind < b.kind; });
    return std::move(all_);
  }

private:
  std::vector<BehaviourChange> all_;
};

inline std::string ticked(std::string_view word) { return "`" + std::string(word) + "`"; }

/// "`a`, `b` and `c`"
std::string ticked_list(const std::vector<std::string>& words);

inline const std::string& name_of(const Model& model, GroupId id) { return model.groups[id].name.value; }

/// "`a`, `b` or `c`", of many the first ones and the count of the rest.
std::string few(const std::set<std::string>& words, std::string_view last);

/// The provider of one group, by its own name.
std::optional<ProviderId> find_provider(const Model& model, const Group& group, const std::string& name);

/// "the program", "`Striker`"
std::string requester_name(const Model& model, const std::optional<GroupId>& requester);

/// Those of the first that are not in the second, in order.
inline std::vector<std::string> missing_in(const std::vector<std::string>& first,
                                           const std::vector<std::string>& second) {
  const std::unordered_set<std::string_view> known(second.begin(), second.end());
  std::vector<std::string> out;
  for (const std::string& each : first) {
    if (!known.contains(each)) out.push_back(each);
  }
  return out;
}

/// Whether the common elements are in another order.
inline bool is_reordered(const std::vector<std::string>& first, const std::vector<std::string>& second) {
  return missing_in(first, missing_in(first, second)) != missing_in(second, missing_in(second, first));
}

/// An absent bound is larger than any.
inline ChangeKind bound_change(const std::optional<Microseconds>& before, const std::optional<Microseconds>& after) {
  const bool grew = before && (!after || *after > *before);
  return grew ? ChangeKind::bound_grew : ChangeKind::bound_shrank;
}

// One function for each part of the model. Things that only one side has are reported by the part that they belong to.
void compare_program(const Pair& pair, Changes& changes);
void compare_states(const Pair& pair, Changes& changes);
void compare_groups(const Pair& pair, Changes& changes);
void compare_provider(const Pair& pair, ProviderId before, ProviderId after, Changes& changes);
void compare_requests(const Pair& pair, Changes& changes);
void compare_ranks(const Pair& pair, Changes& changes);
void compare_pushes(const Pair& pair, Changes& changes);
/// Consequences of all of the above, if they are decided.
void compare_reach(const Pair& pair, Changes& changes);
TransitionsPlayed compare_transitions(const Pair& pair, Changes& changes);
/// `alike`: nothing else has changed.
void compare_findings(const Pair& pair, bool alike, Changes& changes);

} // namespace director::compiler::diff
