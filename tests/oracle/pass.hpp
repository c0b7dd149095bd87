#pragma once
// SPDX-License-Identifier: MIT
// semantics.md, section 4: arbitration, from nothing. One Pass object is one pass; arbitrate() repeats it as in 4.2.

#include "tests/oracle/order.hpp"

#include <map>
#include <utility>

namespace director::oracle {

/// The cases that one arbitration met, for tests of coverage, and what they found.
struct Notes {
  int denials = 0;          ///< a group was denied to an edge because of an equal
  int repetitions = 0;      ///< repeated passes
  int deferrals = 0;        ///< 4.4, Defer
  int later_plans = 0;      ///< a target was granted with a plan that is not its provider's first
  int ladders = 0;          ///< a push was made whose chain is longer than one
  int limbo = 0;            ///< groups put in limbo
  int most_repetitions = 0; ///< the most repetitions of one arbitration
  int settling = 0;         ///< the most micro-steps in a row that only arbitrated once more
  /// For each edge that the last pass refused: the edges that had claimed the groups when it was tried.
  std::map<EdgeId, IdTable<GroupId, std::optional<EdgeId>>> claimed_before;
};

/// The new assignment, after section 4 and before section 5.
Assignment arbitrate(const Parts& parts, const Facts& facts, const Assignment& last, Notes& notes);

/// 4.3: a provider of the edge's target, and a plan for its needs.
struct Choice {
  Chain chain; ///< of the edge
  GroupId group{};
  ProviderId provider{};
  Plan plan;
  std::vector<ConditionId> lacking; ///< the false conditions of the provider and of the plan that count
  EdgeId edge() const { return chain.edge(); }
};
using Combination = std::vector<Choice>; ///< one for each member of a unit

class Pass {
public:
  using Denial = std::pair<GroupId, EdgeId>; ///< the group was denied because of this holder

  Pass(const Parts& parts, const Facts& facts, const Assignment& last, const std::set<EdgeId>& forgotten, Notes& notes);

  void take_candidates();
  std::optional<EdgeId>
  wrongly_denied() const; ///< 4.2: the first holder that did not claim what was denied because of it
  void hand_over();
  Assignment finish();

private:
  // The functions of order.cpp with the tables of this pass.
  Chain claimed_chain(EdgeId edge) const { return chain_of(parts_, now_.held, edge); }
  Chain previous_chain(EdgeId edge) const { return chain_of(parts_, last_.held, edge); }

  // available.cpp: 4.2
  bool available(GroupId group, const Chain& to);
  bool alive(EdgeId edge) const;

  // choices.cpp: 4.3
  bool applies(const Push& push, const Chain& edge) const;
  std::vector<ProviderId> preference(GroupId group, const Chain& edge) const;
  static std::vector<std::pair<PlanEntry, Chain>> chains_of(const Choice& choice); ///< of its plan
  std::vector<Plan> plans_in_order(const Choice& choice) const;
  bool plan_available(const Choice& choice);
  std::vector<Choice> choices(EdgeId edge, bool with_conditions);
  bool waived(ProviderId provider, ConditionId condition, const Chain& edge) const;
  std::vector<ConditionId> lacking(ProviderId provider) const;                    ///< nothing is waived
  std::vector<ConditionId> lacking(ProviderId provider, const Chain& edge) const; ///< for an edge that would hold it
  std::optional<Combination> first_combination(const std::vector<EdgeId>& members, bool with_conditions);

  // pass.cpp: 4.4
  std::vector<EdgeId> unit_of(EdgeId first) const;
  bool stale(GroupId group) const;
  bool granted_before(EdgeId edge) const { return last_.granted_to(edge, parts_.target(edge)); }
  void take(const std::vector<EdgeId>& unit);
  void take_below_stale(EdgeId member);
  bool may_ask(const std::optional<GroupId>& requester) const;
  bool grant_alone(EdgeId member);
  void grant(const Combination& combination);
  void claim(const Choice& choice, bool granted);
  void follow(GroupId requester);
  bool deferred(const Combination& combination) const;
  void keep_pushes(const std::vector<EdgeId>& unit);
  void keep_serving_pushes(const Combination& combination);
  void finish_pushes();

  // refuse.cpp: 4.4, Refuse
  struct Unmet {
    Chain member;
    ConditionId condition{};
  };
  /// A way to make a condition true, 4.4.
  struct Way {
    ProviderId causing{};
    std::optional<ConditionId> lacking; ///< the first condition that it, or its plan, lacks
    int length = 0;
  };
  using Ways = std::map<ConditionId, Way>;
  void refuse(const std::vector<EdgeId>& unit);
  std::vector<Unmet> unmet(const Combination& combination) const;
  bool can_be_caused(ConditionId condition) const;
  bool can_be_pushed(ProviderId provider, const Chain& member, const std::vector<EdgeId>& unit) const;
  bool plan_is_free(const Plan& plan) const;
  std::optional<Way> way(ConditionId condition, const Chain& member, const std::vector<EdgeId>& unit,
                         const Ways& known) const;
  Ways search(const Chain& member, const std::vector<EdgeId>& unit) const;
  void push(const std::vector<EdgeId>& unit, const std::vector<Unmet>& unmet);

  const Parts& parts_;
  const Facts& facts_;
  const Assignment& last_;
  const std::set<EdgeId>& forgotten_;
  Notes& notes_;
  Order order_;
  Assignment now_;
  std::set<EdgeId> candidates_, tried_, refused_;
  std::vector<Denial> denials_;
};

} // namespace director::oracle
