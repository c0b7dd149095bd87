#pragma once
// SPDX-License-Identifier: MIT
// The Spec: behaviour files as they are written, every leaf with its place, no name resolved. Source: the language
// page. A `span` covers a whole thing, from its key (or dash) to its last character; `name.span` is its name alone.
// Lists keep the order of the file.

#include "dsl/lexical/duration.hpp"
#include "dsl/source/span.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace director::dsl {

enum class Op { equal, not_equal, less, less_equal, greater, greater_equal };

/// `allow: [id]`, one for each id of the list.
struct AllowSpec {
  Word id;
  std::optional<Word> because;
  bool operator==(const AllowSpec&) const = default;
};

/// `Phase == ready|set`, `Stability == standing within 2 s`. A bare `Phase` (in `sets` only) has `any` and no values.
struct ConditionSpec {
  Span span{};
  Word state;
  Located<Op> op;
  std::vector<Word> values;
  std::optional<Located<Duration>> within; ///< in `causing` only
  bool any = false;
  bool operator==(const ConditionSpec&) const = default;
};

struct LevelSpec {
  Word name; ///< empty where the task has one level without a name
  Located<std::int32_t> priority;
  Located<bool> optional, apart;
  bool operator==(const LevelSpec&) const = default;
};

/// An entry of `tasks`, a pack or `roots`.
struct TaskSpec {
  Word name;
  std::vector<LevelSpec> levels; ///< never empty; in the order of the file
  std::optional<Word> doc;
  std::vector<AllowSpec> allow;
  Span span{};
  bool operator==(const TaskSpec&) const = default;
};

struct PackSpec {
  Word name;
  std::vector<TaskSpec> tasks;
  Span span{};
  bool operator==(const PackSpec&) const = default;
};

struct ProviderSpec {
  Word name;           ///< `default`, at the place of the group's name, where the group has the provider's keys itself
  bool direct = false; ///< ... and then true; `doc` and `allow` are the group's
  std::vector<ConditionSpec> when, stay, causing, sets;
  std::vector<Word> needs, uses, triggers; ///< a trigger may be a promise: `Walk.halting.broken`
  std::optional<Located<Duration>> every;
  std::optional<std::vector<TaskSpec>> tasks; ///< at most one of these two
  std::optional<std::vector<PackSpec>> packs;
  std::optional<Word> doc;
  std::vector<AllowSpec> allow;
  Span span{};
  bool operator==(const ProviderSpec&) const = default;
};

/// `start: true`, `stop: {sets: [...]}`.
struct HandlerSpec {
  std::vector<ConditionSpec> sets;
  Span span{};
  bool operator==(const HandlerSpec&) const = default;
};

struct GroupSpec {
  Word name;
  std::optional<Word> doc, layer, module, data;
  Located<bool> realtime;
  std::optional<HandlerSpec> start, stop;
  std::vector<Word> uses, triggers; ///< beside `providers`: for all of them
  std::vector<ConditionSpec> sets;  ///< likewise
  std::vector<ProviderSpec> providers;
  std::vector<AllowSpec> allow;
  Span span{};
  bool operator==(const GroupSpec&) const = default;
};

struct ExtendSpec {
  Word group;
  std::optional<Word> before;
  std::vector<ProviderSpec> providers;
  std::optional<Word> doc;
  Span span{};
  bool operator==(const ExtendSpec&) const = default;
};

struct RangeSpec {
  Located<std::int64_t> low, high; ///< low <= high
  Span span{};
  bool operator==(const RangeSpec&) const = default;
};

struct ExpiresSpec {
  Located<Duration> after;
  std::optional<Word> to;
  bool operator==(const ExpiresSpec&) const = default;
};

struct StateSpec {
  Word name;
  std::optional<Word> type;
  std::optional<std::vector<Word>> values;
  std::vector<Word> unordered;
  std::optional<RangeSpec> range;
  std::optional<Word> initial;
  Located<bool> external;
  std::optional<ExpiresSpec> expires;
  std::optional<Word> of;
  std::optional<Word> doc;
  std::vector<AllowSpec> allow;
  Span span{};
  bool operator==(const StateSpec&) const = default;
};

struct AssertionSpec {
  enum class Kind { never_together, beats, can_run, soft };
  Located<Kind> kind;
  std::vector<Word> groups; ///< beats: winner, loser; soft: from, to
  Span span{};
  bool operator==(const AssertionSpec&) const = default;
};

struct LimitsSpec {
  std::optional<Located<std::int64_t>> trials, pass; ///< above 0
  bool operator==(const LimitsSpec&) const = default;
};

struct CppSpec {
  std::optional<Word> name_space;
  std::vector<Word> headers;
  bool operator==(const CppSpec&) const = default;
};

struct ImportSpec {
  Word path;                  ///< as written, relative to the importing file
  std::optional<FileId> file; ///< nothing where it could not be read
  bool operator==(const ImportSpec&) const = default;
};

/// One behaviour file.
struct BehaviourSpec {
  FileId file{};
  Word name; ///< `behaviour:`
  std::optional<Word> doc;
  std::vector<ImportSpec> imports;
  CppSpec cpp;
  std::vector<Word> layers;
  std::vector<StateSpec> states;
  std::vector<Word> triggers;
  std::vector<Word> externs; ///< `extern:`
  std::optional<std::vector<TaskSpec>> roots;
  std::vector<GroupSpec> groups;
  std::vector<ExtendSpec> extend;
  std::vector<AssertionSpec> assertions;
  LimitsSpec limits;
  std::vector<AllowSpec> allow;
  Span span{}; ///< the whole file
  bool operator==(const BehaviourSpec&) const = default;
};

/// In order of declaration: imported files before those that import them, the main file last.
struct Spec {
  std::vector<BehaviourSpec> files;
  bool operator==(const Spec&) const = default;
};

} // namespace director::dsl
