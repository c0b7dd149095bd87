#pragma once
// SPDX-License-Identifier: MIT
// Requests, needs, pushes and take-overs as arrows between groups, before groups are assigned to boxes.

#include "compiler/emit/graph/picture/picture.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct GroupArrow {
  GroupId from{}, to{};
  std::optional<std::size_t> row, pack; ///< as in PictureEnd
  PictureArrow::Kind kind = PictureArrow::Kind::task;
  bool optional = false, apart = false;
  std::string label;
  std::string words; ///< the tooltip
  Span span{};       ///< where it is declared first
  std::optional<Moment::Mark> mark;
  bool hidden = false;      ///< at this moment; another frame shows it
  std::vector<bool> over{}; ///< of a take-over: what may be taken, by group
};

/// Whether each provider and pack has arrows of its own, or all of a group share one.
enum class Detail : bool { groups, packs };

/// Requests and needs, by group and target.
std::vector<GroupArrow> find_requests(const Model& model, Detail detail);

/// An arrow for each two groups of which one may push the other.
std::vector<GroupArrow> find_pushes(const Model& model, const Graph& graph);

/// An arrow for each two groups of which one may take something from the other.
std::vector<GroupArrow> find_takes(const Model& model, const std::vector<TakeOver>& take_overs);

/// The pushes of a moment, and no others.
std::vector<GroupArrow> pushes_of(const Model& model, const Moment& moment);
/// The pushes of all frames, each once; those of other moments are hidden.
std::vector<GroupArrow> pushes_of(const Model& model, const Moment& moment, const std::vector<Moment>& frames);

/// Marks what runs, waits or is not requested at that moment.
void mark_requests(const Model& model, const Moment& moment, std::vector<GroupArrow>& arrows);

/// The levels of a request: `20`, `normal 10, urgent 80`. Empty if all requests of its requester have the priority 0.
struct Manner {
  std::string text;
  bool optional = false, apart = false; ///< at each level
  bool operator==(const Manner&) const = default;
};
Manner manner_of(const Model& model, const Task& task, bool numbers);

/// Whether some of these has a priority other than 0.
bool has_priorities(const Model& model, const std::vector<Task>& tasks);

/// `Walk.halting`, `Kick`, `Striker.ready, pack go`.
std::string requester_name(const Model& model, ProviderId provider, const Pack* pack);

/// `Walk: It walks.`, on one line; the name alone without a `doc`.
std::string with_doc(const std::string& name, std::string doc);

} // namespace director::compiler
