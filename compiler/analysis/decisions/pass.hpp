#pragma once
// SPDX-License-Identifier: MIT
// One decision (semantics.md, section 4) based on a Moment: all assignments that may result. It follows the rules of
// the pass where they are determined, and picks where they are not: among equals, whether a push is in force, what plan
// a group had that is held only as a need. So the results include the engine's decision.

#include "compiler/analysis/decisions/few.hpp"
#include "compiler/analysis/decisions/moment.hpp"
#include "compiler/analysis/decisions/seen.hpp"
#include "compiler/base/choice_sequence.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// A push that a unit may make at some time: a push remains for longer than the decision that made it.
struct PossiblePush {
  Row by = 0, to = 0, unmet = 0; ///< edge, provider, condition
  bool operator==(const PossiblePush&) const = default;
};

/// Why something was not granted, in some decision.
struct Reasons {
  Rows lacking = 0;  ///< conditions that did not hold
  Rows taken = 0;    ///< groups that were not available
  Rows holders = 0;  ///< edges that held these groups
  Rows first = 0;    ///< of a provider: others of its group that came before it
  Rows together = 0; ///< of a task: edges granted only together with it that had nothing to run
  void add(const Reasons& other) {
    lacking |= other.lacking, taken |= other.taken, holders |= other.holders;
    first |= other.first, together |= other.together;
  }
};

/// Collected over all decisions.
struct Gathered {
  std::vector<PossiblePush> pushes, found; ///< assumed ones, and all that were made
  std::vector<Reasons> passed_over;        ///< by provider
  std::vector<Reasons> refused;            ///< by edge
  std::size_t passes = 0;
  std::int64_t steps = 0; ///< steps taken: edges compared, providers examined
};

class Pass {
public:
  Pass(const Component& part, ChoiceSequence& picks, Gathered& gathered)
      : part_(part),
        picks_(picks),
        gathered_(gathered) {}
  /// Sets the input of the next passes.
  void begin(const Moment& last, Rows anew);
  /// The next assignment, with new reasons to run in `outdated`. Empty: since begin() other picks have led to the same.
  std::optional<Moment> run();

private:
  struct Chain {
    std::array<Row, Component::most_groups + 2> edges; ///< root's, ..., the holder of the edge's requester, the edge
    std::uint32_t size;
    bool complete; ///< it begins at root
    Row edge() const { return edges[size - 1]; }
    bool below(Row ancestor) const;
  };
  struct Choice {
    Chain chain;
    Row group, provider, plan;
    Rows claims;  ///< groups
    Rows lacking; ///< conditions
  };
  using By = std::array<Row, Component::most_groups>;
  using ChainBy = std::array<Chain, Component::most_groups>; ///< of the holder of each group; empty: none
  template <class T>
  using ByCondition = std::array<T, Component::most_conditions>;
  using Edges = Few<Row, Component::most_edges>;
  using Groups = Few<Row, Component::most_groups>;
  using Providers = Few<Row, Component::most_providers>;
  using Plans = Few<Row, Component::most_plans>;
  using Chains = Few<Chain, Component::most_groups>;
  using Unit = Groups; ///< edges of one requester, each to another group
  using Combination = Few<Choice, Component::most_groups>;
  enum class Stage : std::uint32_t { taking, handing_over, finishing };
  /// Everything that the rest of a pass depends on.
  struct PassState {
    Rows candidates, tried, refused, forgotten, keeping, open, picked_unsure, taken_to_hold;
    std::array<int, Component::most_groups> standing, picked_among;
    By by, active, plan, flags, denied;
    std::uint16_t unused;
    Stage stage;
  };

  // Section 4.1: order.cpp
  static bool is_limbo(Row edge) { return edge >= Moment::limbo && edge != nothing; }
  Row requester(Row edge) const { return edge >= Moment::limbo ? nothing : part_.edges[edge].requester; }
  const Level& level(Row edge) const;
  static Chain below(const Chain& holder, Row edge);
  Chain chain_of(const ChainBy& holders, Row edge) const;
  Chain claimed(Row edge) const { return chain_of(holders_, edge); }
  Chain before_now(Row edge) const { return chain_of(last_holders_, edge); }
  Chain last_holder(Row group) const;
  int compare(const Chain& a, const Chain& b) const;
  bool before(const Chain& a, const Chain& b) const { return compare(a, b) < 0; }

  // Section 4.2: order.cpp
  bool available(Row group, const Chain& to);
  bool alive(Row edge) const;

  // Section 4.3: choices.cpp
  bool holds(Row condition) const;
  bool applies(Row by, const Chain& edge) const { return before(claimed(by), edge) && !edge.below(by); }
  const PossiblePush* standing(Row group);
  Providers preference(Row group, const Chain& edge);
  Plans plans_in_order(const Choice& choice);
  Chains chains_of(const Choice& choice) const;
  Rows lacking(Row provider);
  Rows lacking(Row provider, const Chain& edge);
  void add_choices(Row edge, bool with_conditions);
  std::optional<Combination> first_combination(const Unit& members, bool with_conditions);
  Row holder_of(Row group) const { return now_.by[group] != nothing ? now_.by[group] : last_.by[group]; }
  void note_taken(Row group, Reasons& reasons) const;
  void note(Row provider, const Reasons& why);

  // Section 4.4
  void begin_way();
  bool is_known();
  bool take_candidates();
  bool stale(Row group) const;
  bool may_request(Row requester) const;
  bool granted_before(Row edge) const;
  void take(const Unit& unit);
  void take_below_stale(Row member);
  bool grant_alone(Row member);
  void grant(const Combination& combination);
  void claim(Row edge, Row group, Row provider, Row plan, bool granted);
  void hold(Row group, Row edge);
  void follow(Row group);
  bool deferred(const Combination& combination) const;
  bool denied_in_vain();
  bool hand_over();
  Moment finish();

  // The order of candidates: order.cpp
  Row first_candidate();
  Unit unit_of(Row first);
  bool alone(Row edge) const;
  bool shares_unit(Row edge, Row other) const; ///< or is the same

  // Refuse: refusal.cpp
  using Lengths = ByCondition<int>; ///< 0: no path is known
  void refuse(const Unit& unit);
  std::vector<Row> lacking_in_order(const Choice& choice) const;
  bool can_be_pushed(Row provider, const Chain& member, const Unit& unit, bool surely) const;
  int way(Row provider, const Chain& member, const Unit& unit, bool surely, const Lengths& known,
          std::vector<Row>* first_lacking);
  Lengths search(const Chain& member, const Unit& unit, bool surely);
  bool may_be_kept_for(Row condition, const Unit& unit) const;
  void add_pushes(const Chain& member, Row unmet, const Unit& unit, std::vector<PossiblePush>& out);

  const Component& part_;
  ChoiceSequence& picks_;
  Gathered& gathered_;
  Moment last_, now_;
  ChainBy last_holders_{}, holders_{};
  Rows anew_ = 0;
  Rows candidates_ = 0, tried_ = 0, refused_ = 0, forgotten_ = 0;
  Rows keeping_ = 0; ///< edges whose pushes may remain
  Groups denied_;
  std::array<int, Component::most_groups> standing_{};     ///< a push, or none: -1
  std::array<int, Component::most_groups> picked_among_{}; ///< the number of pushes from which that was picked
  Reasons blame_;                                          ///< of the current unit
  Rows picked_unsure_ = 0, taken_to_hold_ = 0;             ///< providers for which it was picked whether their
                                                           ///< conditions hold
  Stage stage_ = Stage::taking;
  Rows open_ = 0;               ///< groups that have not been handed over
  std::vector<Choice> choices_; ///< of the current unit, member by member
  Seen<PassState> known_;       ///< since begin()
};

} // namespace director::analysis
