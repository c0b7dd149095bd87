#pragma once
// SPDX-License-Identifier: MIT
// Decides whether an author's assertion is true: proven, refuted, or not decided. Never a guess: a refutation is a
// scenario that was played, a proof by exploration has visited every state, and a static proof names what it depends
// on.

#include "compiler/explore/search/search.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct Verdict {
  enum class Kind { proven, refuted, undecided };
  Kind kind = Kind::undecided;
  std::string why;                     ///< a clause without a full stop
  bool more_states = false;            ///< undecided: there are states beyond the bound
  bool explored = false;               ///< it depends on an exploration, so on what that leaves out
  std::vector<Taken> way;              ///< refuted: how it happens; can_run, proven: likewise. Otherwise empty
  std::vector<dsl::Note> notes;        ///< refuted: what leads to it in the specification
  std::optional<std::string> scenario; ///< of that way; its `behaviour` is the given path
};

/// `proven`, `refuted`, `not decided`
std::string_view name_of(Verdict::Kind kind);

/// `never_together [Travel, Reach]`, as it is written in the behaviour.
std::string words_of(const Assertion& assertion, const Model& model);

/// Without any exploration, from the declarations and the facts of the checks (at_once.cpp); empty if these do not
/// decide it.
std::optional<Verdict> prove_at_once(const Assertion& assertion, const Model& model);

/// For each assertion of the Model: at once, otherwise by lean explorations, of everything and of what leads to its
/// groups, which find possible events sooner than a full one, so they can refute and find what runs, but prove nothing
/// else. Empty if undecided.
std::vector<std::optional<Verdict>> decide_early(const Ground& ground, SearchOptions options,
                                                 const std::string& behaviour);
std::vector<std::size_t> without_verdict(const std::vector<std::optional<Verdict>>& verdicts);

/// The others, by a full exploration that watched them.
std::vector<Verdict> decide_late(const Ground& ground, std::vector<std::optional<Verdict>> early,
                                 const Searched& searched, const std::string& behaviour);

/// All of the above, up to `bound` states.
std::vector<Verdict> decide_assertions(const Ground& ground, std::size_t bound);

} // namespace director::compiler
