#pragma once
// SPDX-License-Identifier: MIT
// The Model: a whole deployment with every name resolved. Built once by resolve(), never changed afterwards; everything
// behind it (graph, checks, lowering, generation) reads it. Ids are in declaration order: an imported file comes before
// its importer; providers are in order of preference, group after group.

#include "compiler/model/ids.hpp"
#include "compiler/model/listed_values.hpp"
#include "compiler/model/value_set.hpp"
#include "dsl/source/span.hpp"
#include "dsl/spec.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

using dsl::Span;
using dsl::Word;

/// A use of a name, and the thing that it resolves to.
template <class IdType>
struct Use {
  IdType id{};
  Span span{};
};

/// Microseconds. Always above 0.
using Microseconds = std::int64_t;

struct State {
  Word name;
  std::optional<std::string> type;     ///< the C++ enum that the user named
  bool is_range = false;               ///< integers low..high; else the words of `values`, numbered from 0, ascending
  std::int64_t low = 0, high = 0;      ///< the domain; for words 0 and count - 1
  ListedValues values;                 ///< empty for a range
  std::vector<Span> value_spans;       ///< where each value is declared
  std::vector<std::int64_t> unordered; ///< sentinels: satisfy no < <= > >=
  std::optional<std::int64_t> initial;
  Span initial_span{};
  bool external = false;
  struct Expires {
    Microseconds after = 0;
    std::optional<std::int64_t> to; ///< nothing: becomes unset
    Span span{};
  };
  std::optional<Expires> expires;
  std::optional<Use<GroupId>> of; ///< set by that group only, back to `initial` when it stops
  std::string doc;
  std::string value_text(std::int64_t value) const;                  ///< the word, or the digits
  std::optional<std::int64_t> value_of(std::string_view text) const; ///< nothing: it has no such value

  /// All values; a value that is unset is not among them.
  ValueSet domain() const { return ValueSet::interval(low, high); }
  /// Whether it may be unset: it has no initial value, or one that expires to unset.
  bool may_be_unset() const { return !initial || (expires && !expires->to); }
};

/// (state, operator, values): a condition in the sense of semantics.md. One row for each different spelling, so that
/// "the same condition" means the same row. `any` (a bare state name in `sets`) accepts every value.
struct Condition {
  enum class Op { equal, not_equal, less, less_equal, greater, greater_equal, any };
  StateId state{};
  Op op = Op::equal;
  std::vector<std::int64_t> operands; ///< as written; several only for equal and not_equal
  ValueSet accepts;                   ///< the values that satisfy it (unset never does)
  std::string text;                   ///< normal form, as in `Stability == ready|set`
};

struct ConditionUse {
  ConditionId id{};
  Span span{};
  std::optional<Microseconds> within; ///< only in `causing`
};

/// One static way in which an edge can be requested.
struct Level {
  std::int32_t priority = 0;
  bool optional = false;
  bool apart = false;
  /// Whether it is in one unit with the other tasks of its pack for which this is true. (Each request of root is a unit
  /// by itself.)
  bool shares_unit() const { return !optional && !apart; }
  bool operator==(const Level&) const = default;
};

/// An entry of `tasks`, of a pack or of `roots`.
struct Task {
  GroupId target{};
  EdgeId edge{};
  Span span{};
  struct NamedLevel {
    std::string name;        ///< empty where the level was written without one
    std::uint32_t level = 0; ///< index into Edge::levels
    Span span{};
  };
  std::vector<NamedLevel> levels; ///< never empty; the first is the default
  std::string doc;
};

struct Pack {
  std::string name; ///< empty for flat `tasks`
  Span span{};
  std::vector<Task> tasks;
  std::string doc;
  bool requests(EdgeId edge) const; ///< one of the tasks is requested through the edge
};

struct Provider {
  GroupId group{};
  std::string name; ///< `default` if the group has the provider's keys itself
  Span span{};      ///< of the name (of the group's name for `default`)
  bool direct = false;
  std::vector<ConditionUse> when, stay, causing, sets; ///< `sets` with the entries beside `providers`
  std::vector<Use<GroupId>> needs, uses;
  std::vector<Use<TriggerId>> triggers;
  std::optional<Microseconds> every;
  bool has_packs = false;
  std::vector<Pack> packs; ///< named packs; or one without a name that holds the flat `tasks`; or none at all
  std::string doc;

  /// Whether the group is among its needs.
  bool needs_group(GroupId id) const {
    return std::any_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) { return need.id == id; });
  }
};

struct Handler {
  Span span{};
  std::vector<ConditionUse> sets;
};

struct Group {
  Word name;
  std::vector<ProviderId> providers; ///< in order of preference; consecutive ids
  std::optional<Handler> start, stop;
  std::optional<Use<LayerId>> layer;
  ModuleId module{};
  std::string data; ///< C++ type of the task's data; empty: none
  Span data_span{};
  bool realtime = false;
  std::vector<EdgeId> edges;      ///< that it requests or needs, in declaration order; consecutive ids
  std::vector<EdgeId> requesters; ///< edges that lead to it, in order of id
  std::string doc;
};

/// requester -> target. Root edges come first, then those of each group, in the order of semantics.md, section 1.
struct Edge {
  std::optional<GroupId> requester; ///< nothing: root
  GroupId target{};
  std::vector<Level> levels;  ///< different ones only, the first one is the first that was declared; empty: need only
  bool needed = false;        ///< some provider of the requester needs the target
  Span span{};                ///< where it was declared first
  bool has_mandatory() const; ///< a level
  bool has_optional() const;  ///< the same
};

struct Trigger {
  std::string name; ///< `Sensors`, or `Walk.halting.broken`
  Span span{};
  std::optional<ProviderId> promise; ///< it fires when this provider's `within` runs out
  std::string doc;
};

struct Module {
  std::string name;
  std::vector<GroupId> groups; ///< in order
};

struct Layer {
  Word name;
};

struct Assertion {
  enum class Kind { never_together, beats, can_run, soft };
  Kind kind = Kind::can_run;
  Span span{};
  std::vector<Use<GroupId>> groups; ///< beats: winner, loser; soft: from, to
};

/// `allow: [id]` on a thing: findings inside `scope` (the thing's whole text) are not reported.
struct Allowance {
  Word id;
  Span scope{};
};

struct Model {
  std::string name;
  std::string name_space;           ///< C++ namespace
  std::vector<std::string> headers; ///< to include, in order, each once
  std::string doc;
  Span name_span{};
  bool deployment = false; ///< the main file has `roots`
  IdTable<StateId, State> states;
  IdTable<ConditionId, Condition> conditions;
  IdTable<GroupId, Group> groups;
  IdTable<ProviderId, Provider> providers;
  IdTable<EdgeId, Edge> edges;
  IdTable<TriggerId, Trigger> triggers; ///< declared ones first, then the promises that are listened to
  IdTable<ModuleId, Module> modules;    ///< in order of their first group
  IdTable<LayerId, Layer> layers;
  std::vector<Task> roots; ///< entries of the main file's `roots`; their edges are the first edges
  std::vector<Use<GroupId>> externs;
  std::vector<Assertion> assertions;
  std::vector<Allowance> allowances;
  /// A key of `limits`; without a place if it is not written.
  struct Limit {
    std::int64_t most = 10'000;
    Span span{};
  };
  Limit trials; ///< of one decision
  Limit pass;   ///< of one pass over one component

  /// Whether the test holds for some level at which the task is requested.
  template <class Test>
  bool any_level(const Task& task, const Test& test) const {
    const std::vector<Level>& all = edges[task.edge].levels;
    return std::any_of(task.levels.begin(), task.levels.end(),
                       [&](const Task::NamedLevel& named) { return test(all[named.level]); });
  }
  /// ... for each of them.
  template <class Test>
  bool each_level(const Task& task, const Test& test) const {
    return !any_level(task, [&](const Level& level) { return !test(level); });
  }
  /// Whether it is granted together with the other mandatory tasks of its pack: at some level, at each, or at its
  /// first.
  bool may_be_member(const Task& task) const {
    return any_level(task, [](const Level& level) { return level.shares_unit(); });
  }
  bool is_always_member(const Task& task) const {
    return each_level(task, [](const Level& level) { return level.shares_unit(); });
  }
  bool is_usually_member(const Task& task) const {
    return edges[task.edge].levels[task.levels.front().level].shares_unit();
  }
  /// Whether a body that requests the pack of this task may leave it out: it is optional at one of its levels.
  bool may_be_left_out(const Task& task) const {
    return any_level(task, [](const Level& level) { return level.optional; });
  }

  /// Whether anything happens without an input when time passes, if no body waits.
  bool uses_time() const;
  /// Whether one of the group's providers is among these.
  bool has_any(GroupId group, const IdSet<ProviderId>& some) const;
  const Group& group_of(ProviderId id) const { return groups[providers[id].group]; }
  /// `Walk.halting`, or `Kick` for a provider called `default`.
  std::string full_name(ProviderId id) const;
  /// The same, but `Walk.default` if `Walk` got other providers by `extend`: what is said of one is not true of all.
  std::string distinct_name(ProviderId id) const;
  /// `root>Kick`, `Walk>LeftLeg`.
  std::string edge_name(EdgeId id) const;
  std::optional<GroupId> find_group(std::string_view name) const;
  std::optional<StateId> find_state(std::string_view name) const;
  /// In the role of a Causing: on the same state, and values(c) a non-empty subset of values(w).
  bool satisfies(ConditionId causing, ConditionId when) const;
  /// Whether some `causing` of the provider satisfies the condition.
  bool causes(ProviderId provider, ConditionId when) const;
};

} // namespace director::compiler
