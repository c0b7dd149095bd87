// Header: runtime/hosted/why_notes.hpp. Test: tests/compiler/cli/commands/why_test.cpp,
// tests/runtime/live/moment_lines_test.cpp. SPDX-License-Identifier: MIT
#include "runtime/hosted/why_notes.hpp"

#include "runtime/hosted/why/hindrances.hpp"
#include "runtime/hosted/why/unit_contests.hpp"
#include "runtime/hosted/why/why_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace director {

namespace {

using About = WhyNote::About;

/// Limit for the providers with a note each.
constexpr std::size_t most_providers = 8;

class Noting {
public:
  Noting(const View& view, const Names& names)
      : v_(view),
        t_(*view.tables),
        words_(view, names),
        hindrances_(view, words_),
        contests_(view) {}

  std::vector<WhyNote> about(const Because& because) {
    switch (because.kind) {
    case Because::Kind::condition: condition(because); break;
    case Because::Kind::lost:
    case Because::Kind::need_held:
    case Because::Kind::reserved: chain(because.holder, "it is held for"); break;
    case Because::Kind::running:
      chain(because.edge, "it runs for");
      passed_over(because);
      break;
    case Because::Kind::no_provider: disabled(because.group); break;
    case Because::Kind::together:
      if (because.group == nil) {
        unit(because);
      } else {
        disabled_below(because.group);
      }
      break;
    case Because::Kind::not_requested: requesters(because.asked); break;
    default: break;
    }
    return std::move(notes_);
  }

private:
  void add(std::string text, About about, Index row) { notes_.push_back({std::move(text), about, row}); }

  /// The chain of requesters up to the program.
  void chain(Index edge, std::string_view word) {
    std::string text(word);
    const Index first = edge;
    for (std::string_view between = " "; edge != nil && !v_.is_limbo(edge); between = ", that for ") {
      const Index requester = t_.edges[edge].requester;
      text += std::string(between) + (requester == nil ? "the program" : words_.group(requester)) + ", priority " +
              std::to_string(v_.priority(edge));
      if (requester == nil) break;
      edge = v_.holder(requester);
    }
    add(std::move(text), About::edge, first);
  }

  void condition(const Because& because) {
    const Index state = t_.conditions[because.condition].state;
    const std::string name = words_.state(state);
    add(name + " is " + words_.value(state), About::condition, because.condition);
    const auto all = causers(t_, because.condition);
    const auto pushed = std::find_if(all.begin(), all.end(), [&](Index row) { return hindrances_.is_pushed(row); });
    for (const Index row : all)
      add(hindrances_.causer(row, because, pushed == all.end() ? nil : *pushed), About::provider, row);
    if (t_.states[state].external) add("the outside may set " + name, About::state, state);
    if (because.provider != nil) others(because);
    if (because.provider != nil) other_ways(because);
  }

  /// Why the group does not run in another provider than the one whose condition it waits for. What could cause that
  /// condition is told already.
  void other_ways(const Because& because) {
    const auto all = causers(t_, because.condition);
    std::size_t count = 0;
    for (const Index each : t_.groups[because.group].providers.rows()) {
      if (each == because.provider || std::find(all.begin(), all.end(), each) != all.end()) continue;
      const std::string reason = hindrances_.hindrance(each, because.member);
      if (reason.empty() || ++count > most_providers) continue;
      add(words_.provider(each) + " would do too, but " + reason, About::provider, each);
    }
  }

  /// Why the group does not run in a provider that is preferred to the active one.
  void passed_over(const Because& because) {
    const GroupAssignment& row = v_.assignment[because.asked];
    if (row.active == nil) return;
    if (hindrances_.is_pushed(row.active) && (row.flags & flag::in_force) != 0) {
      add(words_.provider(row.active) + " is pushed for " + words_.edge(row.push.edge), About::provider, row.active);
      return;
    }
    std::size_t count = 0;
    for (Index each = t_.groups[because.asked].providers.begin; each != row.active && count < most_providers; ++each) {
      const std::string reason = hindrances_.hindrance(each, because.edge);
      if (reason.empty()) continue;
      add(words_.provider(each) + " is preferred, but " + reason, About::provider, each);
      ++count;
    }
  }

  /// The other conditions that are false of the provider, and of those that its needs lead to first: pushes have to
  /// cause all of them.
  void others(const Because& because) {
    const auto lacks_too = [&](Index row) { return row != because.condition && hindrances_.lacks(row); };
    const std::string_view nothing = ", and no enabled provider promises it, so nothing is pushed";
    for (const Index row : t_.list(t_.providers[because.provider].when)) {
      if (!lacks_too(row)) continue;
      add(words_.condition(row) + " is false too" + std::string(hindrances_.is_promised(row) ? "" : nothing),
          About::condition, row);
    }
    if (t_.providers[because.provider].group != because.group || pushes(because.member)) return;
    std::vector<Index> plan{because.provider};
    if (!hindrances_.find_plan(because.provider, because.member, plan)) return;
    for (std::size_t i = 1; i < plan.size(); ++i) {
      for (const Index row : t_.list(t_.providers[plan[i]].when)) {
        if (!lacks_too(row) || hindrances_.is_promised(row)) continue;
        add(words_.condition(row) + " of " + words_.provider(plan[i]) + ", which " + words_.group(because.group) +
                " needs, is false too" + std::string(nothing),
            About::condition, row);
      }
    }
  }

  /// Whether something is pushed for the request.
  bool pushes(Index request) const {
    for (Index row = 0; row < t_.groups.size(); ++row) {
      if (v_.assignment[row].push.edge == request) return true;
    }
    return false;
  }

  void disabled(Index group) {
    const Range providers = t_.groups[group].providers;
    for (Index row = providers.begin; row != providers.end; ++row) {
      if (v_.enabled[row] == 0) add(words_.provider(row) + " is disabled", About::provider, row);
    }
  }

  /// The disabled providers of the group, and of the groups that it may need.
  void disabled_below(Index group) {
    std::vector<Index> groups{group};
    for (std::size_t i = 0; i < groups.size(); ++i) {
      disabled(groups[i]);
      const Range providers = t_.groups[groups[i]].providers;
      for (Index row = providers.begin; row != providers.end; ++row) {
        for (const Index need : t_.list(t_.providers[row].needs)) {
          const Index target = t_.edges[need].target;
          if (std::find(groups.begin(), groups.end(), target) == groups.end()) groups.push_back(target);
        }
      }
    }
  }

  /// The members of the unit, and what two of them need, if that alone is why they cannot all be granted.
  void unit(const Because& because) {
    const Index requester = t_.edges[because.edge].requester;
    if (requester == nil) return;
    std::vector<Index> members;
    for (const Index edge : t_.groups[requester].edges.rows()) {
      if (!v_.requested(edge)) continue;
      const Level& level = t_.levels[v_.request[edge].level];
      if (!level.optional && !level.apart) members.push_back(edge);
    }
    std::vector<std::string> tasks;
    for (const Index edge : members) tasks.push_back(words_.group(t_.edges[edge].target));
    add(words_.group(requester) + " requests " + listed(tasks) + " as one unit, which is granted as a whole or waits",
        About::edge, because.edge);
    for (const Index contested : contests_.contested_by(members)) {
      tasks.clear();
      bool is_member = false;
      Index user = nil;
      for (const Index edge : members) {
        const Index target = t_.edges[edge].target;
        is_member = is_member || target == contested;
        if (target == contested || !contests_.cannot_do_without(target, contested)) continue;
        tasks.push_back(words_.group(target));
        if (user == nil || user == because.edge) user = edge; // the place of the other one, if there are two
      }
      add(listed(tasks) + (is_member ? tasks.size() == 1 ? " needs " : " need " : " each need ") +
              words_.group(contested) + (is_member ? ", which is another task of the unit" : ""),
          About::edge, user);
    }
  }

  /// "a, b and c".
  static std::string listed(const std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i)
      out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return out;
  }

  void requesters(Index group_row) {
    for (const Index edge : t_.list(t_.groups[group_row].requesters)) {
      const Index requester = t_.edges[edge].requester;
      if (requester == nil) {
        add("the program may", About::edge, edge);
      } else {
        const bool lives = v_.assignment[requester].active != nil;
        if (t_.edges[edge].levels.empty()) { // a need, which requests nothing
          add(words_.group(requester) + (lives ? " may need it, and does not now" : " may need it, and does not run"),
              About::edge, edge);
          continue;
        }
        add(words_.group(requester) + (lives ? " may, and does not request it now" : " may, and does not run"),
            About::edge, edge);
      }
    }
  }

  const View& v_;
  const Tables& t_;
  const WhyWords words_;
  const Hindrances hindrances_;
  UnitContests contests_;
  std::vector<WhyNote> notes_;
};

constexpr std::array<std::string_view, 11> kinds{"running",   "not_requested", "no_provider", "lost",
                                                 "need_held", "together",      "condition",   "outdated",
                                                 "deferred",  "reserved",      "limbo"};

} // namespace

std::vector<WhyNote> why_notes(const View& view, const Because& because, const Names& names) {
  return Noting(view, names).about(because);
}

std::string_view name_of(Because::Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

} // namespace director
