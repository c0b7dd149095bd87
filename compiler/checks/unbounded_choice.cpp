// Header: compiler/checks/check.hpp. Test: compiler/checks/unbounded_choice.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/trials.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::checks {

namespace {

/// Limit for counting, whatever limit was set.
constexpr std::int64_t most_counted = 1'000'000'000;

/// The trials of one pass over a component for one requester.
struct Share {
  std::int64_t trials = 0;
  Span span{};
  std::string words; ///< "the tasks of `Plan`"
};

struct InPass {
  TrialCount sum;
  std::vector<Share> shares;
  bool reported = false; ///< one decision of it is too large already
};

class UnboundedChoice {
public:
  UnboundedChoice(const Input& input, Findings& findings)
      : model_(input.model),
        component_(input.graph.component),
        budget_(input.shared.budget()),
        trials_(model_, std::min(std::max(model_.trials.most, model_.pass.most), most_counted) + 1, budget_),
        findings_(findings) {}

  void check() {
    for (const Task& root : model_.roots) {
      look_at(trials_.alone(root));
      add(root.target, trials_.pass(root), root.span, name_of(model_, root.target));
    }
    for (const GroupId group : model_.groups.ids()) look_at(group);
    for (const auto& [component, in_pass] : passes_) {
      if (!in_pass.reported && in_pass.sum.count > model_.pass.most) report(in_pass);
    }
  }

private:
  void look_at(GroupId group) {
    for (const ProviderId id : model_.groups[group].providers) {
      for (const Pack& pack : model_.providers[id].packs) {
        if (const CountedUnit unit = trials_.together(pack); !unit.members.empty()) look_at(unit);
        for (const Task& task : pack.tasks) {
          if (!may_be_member(model_, task)) look_at(trials_.alone(task));
        }
      }
    }
    if (const LargestPack largest = trials_.pass(group); largest.count.count > 0)
      add(group, largest.count, model_.providers[largest.provider].span,
          fmt::format("the tasks of {}", name_of(model_, largest.provider)));
  }

  void look_at(const CountedUnit& unit) {
    const TrialCount count = trials_.decision(unit);
    if (count.count > model_.trials.most || (!count.complete && !budget_.exhausted())) {
      report(unit, count);
      passes_[component_[unit.members.front()->target.value]].reported = true;
    } else if (!count.complete) {
      const Task& first = *unit.members.front();
      budget_.leave_open(first.span, fmt::format("in how many ways {} can be met", name_of(model_, first.target)));
    }
  }

  void add(GroupId group, TrialCount count, Span span, std::string words) {
    InPass& pass = passes_[component_[group.value]];
    pass.sum.count += std::min(count.count, most_counted);
    pass.sum.complete = pass.sum.complete && count.complete;
    pass.shares.push_back({count.count, span, std::move(words)});
  }

  static std::string amount(const TrialCount& count) {
    return fmt::format("{}{}", count.complete ? "" : "at least ", count.count);
  }

  /// The members with the largest product.
  std::vector<const Task*> worst_of(const CountedUnit& unit) {
    return *std::max_element(unit.colliding.begin(), unit.colliding.end(), [&](const auto& a, const auto& b) {
      return trials_.product(a).count < trials_.product(b).count;
    });
  }

  void report(const CountedUnit& unit, const TrialCount& count) {
    const std::vector<const Task*> members = worst_of(unit);
    // Reducing the task with the most ways helps most.
    const Task* worst = *std::max_element(members.begin(), members.end(), [&](const Task* a, const Task* b) {
      return trials_.ways(a->target).count < trials_.ways(b->target).count;
    });
    const bool alone = unit.members.size() == 1;
    dsl::Diagnostic& finding = findings_.add(
        worst->span, alone ? fmt::format("{} can be met in {} ways, and one decision may try {}",
                                         name_of(model_, worst->target), amount(count), model_.trials.most)
                           : fmt::format("one decision about the tasks that are granted with {} may try {} "
                                         "combinations, and {} are allowed",
                                         name_of(model_, worst->target), amount(count), model_.trials.most));
    for (const Task* member : members) {
      if (alone) break;
      const TrialCount ways = trials_.ways(member->target);
      finding.notes.push_back({member->span, fmt::format("{}: {} {}{}", name_of(model_, member->target), amount(ways),
                                                         ways.count == 1 ? "way" : "ways",
                                                         members.size() > 1 ? ", each with each of the others here, as "
                                                                              "they can claim the same group"
                                                                            : "")});
    }
    for (const ProviderId provider : model_.groups[worst->target].providers) {
      const PlanCount plans = trials_.plans(provider);
      if (plans.tried() <= 1) continue;
      std::string note = fmt::format("{} has {} {}", name_of(model_, provider), amount({plans.plans, plans.complete}),
                                     plans.plans == 1 ? "plan" : "plans");
      if (plans.dead_ends != 0)
        note += fmt::format(", and {} choices that end at a group that is needed twice",
                            amount({plans.dead_ends, plans.complete}));
      finding.notes.push_back({model_.providers[provider].span, std::move(note)});
    }
    if (model_.trials.span != Span{}) finding.notes.push_back({model_.trials.span, "this is the limit"});
    finding.help = alone
                       ? "give the needed groups fewer providers, or raise `limits: {trials: ...}`"
                       : "make one of them `apart`, give the groups fewer providers, or raise `limits: {trials: ...}`";
  }

  void report(const InPass& pass) {
    std::vector<Share> shares = pass.shares;
    std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.trials > b.trials; });
    dsl::Diagnostic& finding = findings_.add(
        shares.front().span, fmt::format("one pass over all that has to do with {} may try {} combinations, and {} are "
                                         "allowed",
                                         shares.front().words, amount(pass.sum), model_.pass.most));
    constexpr std::size_t most_noted = 5;
    for (std::size_t i = 0; i < shares.size() && i < most_noted; ++i)
      finding.notes.push_back({shares[i].span, fmt::format("up to {} for {}", shares[i].trials, shares[i].words)});
    if (model_.pass.span != Span{}) finding.notes.push_back({model_.pass.span, "this is the limit"});
    finding.help = "make tasks `apart`, give the groups fewer providers, or raise `limits: {pass: ...}`";
  }

  const Model& model_;
  const std::vector<Node>& component_;
  Budget& budget_;
  Trials trials_;
  Findings& findings_;
  std::map<Node, InPass> passes_;
};

} // namespace

void unbounded_choice(const Input& input, Findings& findings) { UnboundedChoice(input, findings).check(); }

} // namespace director::checks
