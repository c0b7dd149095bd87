// Header: compiler/checks/check.hpp. Test: compiler/checks/unbounded_choice.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/trials.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace director::checks {

namespace {

/// Limit for counting, whatever limit was set.
constexpr std::int64_t most_counted = 1'000'000'000;

class UnboundedChoice {
public:
  UnboundedChoice(const Input& input, Findings& findings)
      : model_(input.model),
        budget_(input.shared.budget()),
        trials_(model_, std::min(std::max(model_.trials.most, model_.pass.most), most_counted) + 1, budget_),
        findings_(findings) {}

  void check() {
    for (const Task& root : model_.roots) look_at(trials_.alone(root));
    for (const GroupId group : model_.groups.ids()) look_at(group);
    const std::vector<PassTrials> passes = trials_.passes();
    for (std::uint32_t component = 0; component < passes.size(); ++component) {
      if (reported_.count(component) == 0 && passes[component].sum.count > model_.pass.most) report(passes[component]);
    }
  }

private:
  void look_at(GroupId group) {
    for (const ProviderId id : model_.groups[group].providers) {
      for (const Pack& pack : model_.providers[id].packs) {
        if (const CountedUnit unit = trials_.together(pack); !unit.members.empty()) look_at(unit);
        for (const Task& task : pack.tasks) {
          if (!model_.may_be_member(task)) look_at(trials_.alone(task));
        }
      }
    }
  }

  void look_at(const CountedUnit& unit) {
    const TrialCount count = trials_.decision(unit);
    if (count.count > model_.trials.most || (!count.complete && !budget_.exhausted())) {
      report(unit, count);
      reported_.insert(trials_.component(unit.members.front()->target));
    } else if (!count.complete) {
      const Task& first = *unit.members.front();
      budget_.leave_open(first.span, fmt::format("in how many ways {} can be met", name_of(model_, first.target)));
    }
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

  void report(const PassTrials& pass) {
    std::vector<PassTrials::Share> shares = pass.shares;
    std::stable_sort(shares.begin(), shares.end(), [](const PassTrials::Share& a, const PassTrials::Share& b) {
      return a.count.count > b.count.count;
    });
    const auto span = [&](const PassTrials::Share& share) {
      return share.root != nullptr ? share.root->span : model_.providers[share.provider].span;
    };
    const auto words = [&](const PassTrials::Share& share) {
      return share.root != nullptr ? name_of(model_, share.root->target)
                                   : fmt::format("the tasks of {}", name_of(model_, share.provider));
    };
    dsl::Diagnostic& finding = findings_.add(
        span(shares.front()), fmt::format("one pass over all that has to do with {} may try {} combinations, and {} "
                                          "are allowed",
                                          words(shares.front()), amount(pass.sum), model_.pass.most));
    constexpr std::size_t most_noted = 5;
    for (std::size_t i = 0; i < shares.size() && i < most_noted; ++i)
      finding.notes.push_back(
          {span(shares[i]), fmt::format("up to {} for {}", shares[i].count.count, words(shares[i]))});
    if (model_.pass.span != Span{}) finding.notes.push_back({model_.pass.span, "this is the limit"});
    finding.help = "make tasks `apart`, give the groups fewer providers, or raise `limits: {pass: ...}`";
  }

  const Model& model_;
  Budget& budget_;
  Trials trials_;
  Findings& findings_;
  std::set<std::uint32_t> reported_; ///< components with one decision that is too large already
};

} // namespace

void unbounded_choice(const Input& input, Findings& findings) { UnboundedChoice(input, findings).check(); }

} // namespace director::checks
