#pragma once
// SPDX-License-Identifier: MIT
// One decision (semantics.md, section 4) from what a Moment knows: all assignments that may come of it. It follows the
// pass rule by rule where that is known, and picks where it is not: among equals, whether a push stands, what plan
// a group had that is held only as a need. So what the engine decides is among what comes out.

#include "compiler/analysis/decisions/moment.hpp"
#include "compiler/analysis/decisions/picks.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

/// That a unit may push, at some time: a push stays for longer than the decision that made it.
struct PossiblePush {
  Row by = 0, to = 0, unmet = 0; ///< edge, provider, condition
  bool operator==(const PossiblePush&) const = default;
};

/// Why something was not granted, in some decision.
struct Reasons {
  Rows lacking = 0;  ///< conditions that did not hold
  Rows taken = 0;    ///< groups that were not available
  Rows holders = 0;  ///< edges that held them
  Rows first = 0;    ///< of a provider: others of its group that came before it
  Rows together = 0; ///< of a task: edges granted only together with it that had nothing to run
  void add(const Reasons& other) {
    lacking |= other.lacking, taken |= other.taken, holders |= other.holders;
    first |= other.first, together |= other.together;
  }
};

/// What is gathered over all decisions.
struct Gathered {
  std::vector<PossiblePush> pushes, found; ///< those that are reckoned with, and all that were made
  std::vector<Reasons> passed_over;        ///< by provider
  std::vector<Reasons> refused;            ///< by edge
  std::size_t passes = 0;
  std::int64_t steps = 0; ///< that were taken: edges that were compared, providers that were looked at
};

class Pass {
public:
  Pass(const Component& part, const Moment& last, Rows anew, Picks& picks, Gathered& gathered);
  /// Who holds what, runs what, and for what; news is in outdated. Nothing: other picks have led to the same.
  std::optional<Moment> run();

private:
  struct Chain {
    std::array<Row, Component::most_groups + 2> edges{}; ///< the edge, who holds its requester, ...
    std::size_t size = 0;
    bool complete = false; ///< it ends at root
    Row edge() const { return edges[0]; }
    bool below(Row ancestor) const;
  };
  struct Choice {
    Chain chain;
    Row group = 0, provider = 0, plan = 0;
    Rows claims = 0;          ///< groups
    std::vector<Row> lacking; ///< conditions
  };
  using Combination = std::vector<Choice>;
  using By = std::array<Row, Component::most_groups>;

  // Section 4.1
  static bool is_limbo(Row edge) { return edge >= Moment::limbo && edge != nothing; }
  Row requester(Row edge) const { return edge >= Moment::limbo ? nothing : part_.edges[edge].requester; }
  const Level& level(Row edge) const;
  Chain chain_of(const By& by, Row edge) const;
  Chain claimed(Row edge) const { return chain_of(now_.by, edge); }
  Chain before_now(Row edge) const { return chain_of(last_.by, edge); }
  static Chain below(const Chain& holder, Row edge);
  int compare(const Chain& a, const Chain& b) const;
  bool before(const Chain& a, const Chain& b) const { return compare(a, b) < 0; }

  // Section 4.2
  bool available(Row group, const Chain& to);
  bool alive(Row edge) const;

  // Section 4.3: choices.cpp
  bool holds(Row condition) const;
  bool applies(Row by, const Chain& edge) const { return before(claimed(by), edge) && !edge.below(by); }
  const PossiblePush* standing(Row group);
  std::vector<Row> preference(Row group, const Chain& edge);
  std::vector<Row> plans_in_order(const Choice& choice);
  std::vector<Chain> chains_of(const Choice& choice) const;
  void add_lacking(Row provider, std::vector<Row>& out);
  void add_lacking(Row provider, const Chain& edge, std::vector<Row>& out);
  std::vector<Choice> choices(Row edge, bool with_conditions);
  std::optional<Combination> first_combination(const std::vector<Row>& members, bool with_conditions);
  Row holder_of(Row group) const { return now_.by[group] != nothing ? now_.by[group] : last_.by[group]; }
  void note_taken(Row group, Reasons& reasons) const;
  void note(Row provider, const Reasons& why);

  // Section 4.4
  void begin();
  bool is_known();
  bool take_candidates();
  Row first_candidate();
  std::vector<Row> unit_of(Row first);
  bool alone(Row edge) const;
  bool stale(Row group) const;
  bool may_ask(Row requester) const;
  bool granted_before(Row edge) const;
  void take(const std::vector<Row>& unit);
  void take_below_stale(Row member);
  bool grant_alone(Row member);
  void grant(const Combination& combination);
  void claim(Row edge, Row group, Row provider, Row plan, bool granted);
  void follow(Row group);
  bool deferred(const Combination& combination) const;
  bool denied_in_vain();
  bool hand_over();
  Moment finish();

  // Refuse: refusal.cpp
  using Lengths = std::vector<int>; ///< by condition; 0: no way is known
  void refuse(const std::vector<Row>& unit);
  bool can_be_pushed(Row provider, const Chain& member, const std::vector<Row>& unit, bool surely) const;
  int way(Row provider, const Chain& member, const std::vector<Row>& unit, bool surely, const Lengths& known,
          std::vector<Row>* first_lacking);
  Lengths search(const Chain& member, const std::vector<Row>& unit, bool surely);
  bool may_be_kept_for(Row condition, const std::vector<Row>& unit) const;
  void add_pushes(const Chain& member, Row unmet, const std::vector<Row>& unit, std::vector<PossiblePush>& out);

  const Component& part_;
  const Moment& last_;
  Rows anew_;
  Picks& picks_;
  Gathered& gathered_;
  Moment now_;
  Rows candidates_ = 0, tried_ = 0, refused_ = 0, forgotten_ = 0;
  Rows keeping_ = 0; ///< edges whose pushes may stand
  std::vector<Row> denied_;
  std::array<int, Component::most_groups> standing_{}; ///< -2: not asked; -1: none; else a push
  std::array<int, Component::most_groups> asked_{};    ///< of how many that was picked
  Reasons blame_;                                      ///< of the unit in hand
  std::vector<signed char> unsure_;                    ///< provider: whether its conditions hold
  enum class Stage : Row { taking, handing_over, finishing };
  Stage stage_ = Stage::taking;
  Rows open_ = 0;    ///< groups that have not been handed over
  std::string here_; ///< bytes of what is_known() looks at
};

} // namespace director::analysis
