// Header: tests/bench/random_behaviour.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/random_behaviour.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace bench {

namespace {

using Names = std::vector<std::string>;

class Writer {
public:
  Writer(std::size_t groups, std::uint64_t seed)
      : random_(seed),
        states_(std::max<std::size_t>(4, groups / 10)),
        leaves_(std::max<std::size_t>(3, groups / 4)),
        skills_(std::max<std::size_t>(3, groups / 3)),
        planners_(std::max<std::size_t>(3, groups - leaves_ - skills_)),
        roots_(std::max<std::size_t>(2, planners_ / 3)) {}

  std::string write() {
    add("behaviour: at_random\nlanguage: 1\nstates:\n");
    for (std::size_t i = 0; i < states_; ++i)
      add("  State{}: {{values: [a, b, c, d], initial: a, external: true}}\n", i);
    add("triggers: [Tick, Tock]\nroots:\n");
    for (std::size_t i = 0; i < roots_; ++i)
      add("  Plan{}: {{priority: {{low: {}, high: {}}}}}\n", i, 2 * i, 2 * (i + roots_) + 1);
    add("groups:\n");
    for (std::size_t i = 0; i < leaves_; ++i) add("  Leaf{}: {{}}\n", i);
    for (std::size_t i = 0; i < skills_; ++i) add_skill(i);
    for (const Names& below : below_planners()) add_planner(below);
    return text_;
  }

private:
  template <class... Given>
  void add(fmt::format_string<Given...> format, Given&&... given) {
    text_ += fmt::format(format, std::forward<Given>(given)...);
  }
  std::string condition(const char* comparison) {
    return fmt::format("State{} {} {}", random_.below(states_), comparison, "abcd"[random_.below(4)]);
  }
  static void add_new(Names& names, std::string name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }

  /// Neighbours share a leaf, so that there is one component. Later providers need less.
  void add_skill(std::size_t number) {
    Names needs;
    add_new(needs, fmt::format("Leaf{}", number % leaves_));
    add_new(needs, fmt::format("Leaf{}", (number + 1) % leaves_));
    for (std::size_t more = random_.below(3); more > 0; --more)
      add_new(needs, fmt::format("Leaf{}", random_.below(leaves_)));
    const std::size_t providers = 1 + random_.below(3);
    add("  Skill{}:\n    providers:\n", number);
    for (std::size_t i = 0; i < providers; ++i) {
      add("      - {{name: way{}", i);
      if (i + 1 < providers) add(", when: [{}]", condition("=="));
      if (providers > 1 && random_.percent(50)) add(", causing: [{}]", condition("=="));
      if (random_.percent(20)) add(", triggers: [Tick]");
      add(", needs: [{0}], tasks: [{0}]}}\n", fmt::join(needs, ", "));
      if (needs.size() > 1) needs.pop_back();
    }
  }

  /// The requests of each planner: skills in turn and at random, and behind the roots each planner has one or two above
  /// it.
  std::vector<Names> below_planners() {
    std::vector<Names> below(planners_);
    for (std::size_t i = 0; i < std::max(skills_, planners_); ++i)
      add_new(below[i % planners_], fmt::format("Skill{}", i % skills_));
    for (Names& names : below) {
      for (std::size_t more = 1 + random_.below(2); more > 0; --more)
        add_new(names, fmt::format("Skill{}", random_.below(skills_)));
    }
    for (std::size_t i = roots_; i < planners_; ++i) {
      add_new(below[random_.below(i)], fmt::format("Plan{}", i));
      if (random_.percent(50)) add_new(below[random_.below(i)], fmt::format("Plan{}", i));
    }
    return below;
  }

  void add_planner(const Names& below) {
    add("  Plan{}:\n", number_++);
    if (random_.percent(40)) add("    when: [{}]\n", condition("!="));
    if (random_.percent(30)) add("    triggers: [Tick, Tock]\n");
    const std::size_t packs = std::min<std::size_t>(1 + random_.below(3), below.size());
    std::vector<Names> dealt(packs);
    for (std::size_t i = 0; i < below.size(); ++i) dealt[random_.below(packs)].push_back(below[i]);
    add("    packs:\n");
    for (std::size_t i = 0; i < packs; ++i) {
      if (dealt[i].empty()) dealt[i].push_back(below[i]);
      std::size_t priority = dealt[i].size();
      Names tasks;
      for (const std::string& task : dealt[i])
        tasks.push_back(fmt::format("{}: {{priority: {}, apart: true}}", task, priority--));
      add("      pack{}: {{{}}}\n", i, fmt::join(tasks, ", "));
    }
  }

  Random random_;
  std::size_t states_, leaves_, skills_, planners_, roots_;
  std::size_t number_ = 0; ///< of the next planner
  std::string text_;
};

} // namespace

std::string random_behaviour(std::size_t groups, std::uint64_t seed) { return Writer(groups, seed).write(); }

} // namespace bench
