#pragma once
// SPDX-License-Identifier: MIT
// Whether what an author relies on is true: proven, refuted, or not decided. Never a guess: a refutation is a scenario
// that was played, a proof by exploration has seen every state, and a static proof says what it rests on.

#include "compiler/explore/search.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct Verdict {
  enum class Kind { proven, refuted, undecided };
  Kind kind = Kind::undecided;
  std::string why;                     ///< a clause without a full stop
  bool explored = false;               ///< it rests on an exploration, so on what that leaves out
  std::vector<Taken> way;              ///< refuted: how it happens; can_run, proven: likewise. Otherwise empty
  std::optional<std::string> scenario; ///< of that way; its `behaviour` is what was told
};

/// `proven`, `refuted`, `not decided`
std::string_view name_of(Verdict::Kind kind);

/// `never_together [Travel, Reach]`, as it is written in the behaviour.
std::string words_of(const Assertion& assertion, const Model& model);

/// Without exploring anything, from needs and priorities alone; nothing where that does not tell.
std::optional<Verdict> prove_at_once(const Assertion& assertion, const Model& model);

/// Of each assertion of the Model: at once, else by lean explorations, of everything and of what leads to its groups,
/// which find what can happen sooner than one of everything does, and so can refute and find what runs, but prove
/// nothing else. Nothing where that does not tell.
std::vector<std::optional<Verdict>> decide_early(const Ground& ground, SearchOptions options,
                                                 const std::string& behaviour);
std::vector<std::size_t> without_verdict(const std::vector<std::optional<Verdict>>& verdicts);

/// The others by an exploration of everything that looked at them.
std::vector<Verdict> decide_late(const Ground& ground, std::vector<std::optional<Verdict>> early,
                                 const Searched& searched, const std::string& behaviour);

/// States that are looked through for one assertion or one provider alone.
inline constexpr std::size_t states_of_focus = 20'000;

/// States that `check` and `generate` explore at most, twice.
inline constexpr std::size_t states_of_check = 100'000;

/// All of the above, for as long as `bound` allows.
std::vector<Verdict> decide_assertions(const Ground& ground, std::size_t bound);

} // namespace director::compiler
