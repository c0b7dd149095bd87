// Header: runtime/hosted/why_notes.hpp. Test: tests/compiler/cli/commands/why_test.cpp,
// tests/runtime/live/moment_lines_test.cpp. SPDX-License-Identifier: MIT
#include "runtime/hosted/why_notes.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace director {

namespace {

using About = WhyNote::About;

/// Limit for the providers with a note each.
constexpr std::size_t most_providers = 8;

class Noting {
public:
  Noting(const View& view, const Names& names) : v_(view), t_(*view.tables), n_(names) {}

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

  std::string group(Index row) const { return n_.group(n_.self, row); }
  std::string edge(Index row) const { return n_.edge(n_.self, row); }
  /// `Walk.halting`; `Walk` if the group declares the provider directly.
  std::string provider(Index row) const {
    const std::string_view own = n_.provider(n_.self, row);
    const std::string of = group(t_.providers[row].group);
    return own == "default" ? of : of + "." + std::string(own);
  }
  std::string value(Index state) const {
    const std::int32_t number = v_.values[state].value;
    if (number == unset) return "unset";
    const std::string name = n_.value(n_.self, state, number);
    return name.empty() ? std::to_string(number) : name;
  }

  /// The chain of requesters up to the program.
  void chain(Index edge, std::string_view word) {
    std::string text(word);
    const Index first = edge;
    for (std::string_view between = " "; edge != nil && !v_.is_limbo(edge); between = ", that for ") {
      const Index requester = t_.edges[edge].requester;
      text += std::string(between) + (requester == nil ? "the program" : group(requester)) + ", priority " +
              std::to_string(v_.priority(edge));
      if (requester == nil) break;
      edge = v_.holder(requester);
    }
    add(std::move(text), About::edge, first);
  }

  void condition(const Because& because) {
    const Index state = t_.conditions[because.condition].state;
    const std::string name = n_.state(n_.self, state);
    add(name + " is " + value(state), About::condition, because.condition);
    const auto all = causers(t_, because.condition);
    const auto pushed = std::find_if(all.begin(), all.end(), [&](Index row) { return is_pushed(row); });
    for (const Index row : all) causer(row, because, pushed == all.end() ? nil : *pushed);
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
      const std::string reason = hindrance(each, because.member);
      if (reason.empty() || ++count > most_providers) continue;
      add(provider(each) + " would do too, but " + reason, About::provider, each);
    }
  }

  /// Why the group does not run in a provider that is preferred to the active one.
  void passed_over(const Because& because) {
    const GroupAssignment& row = v_.assignment[because.asked];
    if (row.active == nil) return;
    if (is_pushed(row.active) && (row.flags & flag::in_force) != 0) {
      add(provider(row.active) + " is pushed for " + edge(row.push.edge), About::provider, row.active);
      return;
    }
    std::size_t count = 0;
    for (Index each = t_.groups[because.asked].providers.begin; each != row.active && count < most_providers; ++each) {
      const std::string reason = hindrance(each, because.edge);
      if (reason.empty()) continue;
      add(provider(each) + " is preferred, but " + reason, About::provider, each);
      ++count;
    }
  }

  /// What keeps the provider from running: it is disabled, or the first thing that it lacks. Empty: nothing that can be
  /// seen at the provider itself.
  std::string hindrance(Index row, Index request) const {
    if (v_.enabled[row] == 0) return "is disabled";
    for (const Index each : t_.list(t_.providers[row].when)) {
      const Index state = t_.conditions[each].state;
      if (t_.accepts(t_.conditions[each], v_.values[state].value)) continue;
      return std::string(n_.condition(n_.self, each)) + " is false: " + n_.state(n_.self, state) + " is " +
             value(state);
    }
    for (const Index need : t_.list(t_.providers[row].needs)) {
      const Index target = t_.edges[need].target, holder = v_.holder(target);
      if (is_in_the_way(holder, need, request)) return group(target) + " is held by " + edge(holder);
    }
    return "";
  }

  /// Or what keeps the only provider of a need from running, or of a need of that.
  std::string hindrance_with_needs(Index row, Index request) const {
    std::string out = hindrance(row, request);
    for (const Index need : t_.list(t_.providers[row].needs)) {
      const Range providers = t_.groups[t_.edges[need].target].providers;
      if (!out.empty() || providers.size() != 1) continue;
      out = hindrance_with_needs(providers.begin, request);
      if (out.empty()) continue;
      out = group(t_.edges[need].target) + ", which it needs, " +
            (v_.enabled[providers.begin] == 0 ? "" : "cannot run: ") + out;
    }
    return out;
  }

  bool is_in_the_way(Index holder, Index need, Index request) const {
    return holder != nil && holder != need && request != nil && !v_.is_limbo(holder) &&
           stands_in_the_way(v_, holder, request);
  }

  /// The other conditions that are false of the provider, and of those that its needs lead to first: pushes have to
  /// cause all of them.
  void others(const Because& because) {
    const auto lacks_too = [&](Index row) { return row != because.condition && lacks(row); };
    const std::string_view nothing = ", and no enabled provider promises it, so nothing is pushed";
    for (const Index row : t_.list(t_.providers[because.provider].when)) {
      if (!lacks_too(row)) continue;
      add(std::string(n_.condition(n_.self, row)) + " is false too" + std::string(is_promised(row) ? "" : nothing),
          About::condition, row);
    }
    if (t_.providers[because.provider].group != because.group || pushes(because.member)) return;
    std::vector<Index> plan{because.provider};
    if (!find_plan(because.provider, because.member, plan)) return;
    for (std::size_t i = 1; i < plan.size(); ++i) {
      for (const Index row : t_.list(t_.providers[plan[i]].when)) {
        if (!lacks_too(row) || is_promised(row)) continue;
        add(std::string(n_.condition(n_.self, row)) + " of " + provider(plan[i]) + ", which " + group(because.group) +
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

  /// Adds, for each need, the first enabled provider for which all groups are free for the request.
  bool find_plan(Index row, Index request, std::vector<Index>& plan) const {
    for (const Index need : t_.list(t_.providers[row].needs)) {
      const Index target = t_.edges[need].target;
      const bool is_taken =
          std::any_of(plan.begin(), plan.end(), [&](Index each) { return t_.providers[each].group == target; });
      if (is_taken || is_in_the_way(v_.holder(target), need, request)) return false;
      bool found = false;
      for (const Index each : t_.groups[target].providers.rows()) {
        if (v_.enabled[each] == 0) continue;
        const std::size_t before = plan.size();
        plan.push_back(each);
        found = find_plan(each, request, plan);
        if (found) break;
        plan.resize(before);
      }
      if (!found) return false;
    }
    return true;
  }

  /// Whether its group is to change to it, if it can run.
  bool is_pushed(Index row) const {
    const Push& push = v_.assignment[t_.providers[row].group].push;
    return push.edge != nil && push.provider == row;
  }

  /// The state of a provider that promises the condition. `pushed`: the first one that is, or nil.
  void causer(Index row, const Because& because, Index pushed) {
    const Index of = t_.providers[row].group;
    const GroupAssignment& standing = v_.assignment[of];
    std::string text = provider(row);
    if (v_.enabled[row] == 0) {
      text += is_pushed(row) ? " is pushed for " + edge(standing.push.edge) + ", and is disabled"
                             : " could cause it, and is disabled";
    } else if (standing.active == row && (standing.flags & flag::in_force) != 0) {
      text += " is to cause it: pushed for " + edge(standing.push.edge);
    } else if (standing.active == row) {
      text += " could cause it, and runs";
    } else if (is_pushed(row) && outranks(standing.holder, standing.push.edge)) {
      text += " is pushed for " + edge(standing.push.edge) + ", without effect: " + holder_words(of);
    } else if (is_pushed(row)) {
      const std::string reason = hindrance_with_needs(row, standing.push.edge);
      text +=
          " is pushed for " + edge(standing.push.edge) + ", and cannot run now" + (reason.empty() ? "" : ": " + reason);
    } else if (!is_requested(of)) {
      text += " could cause it, but nothing requests " + group(of);
    } else if (!standing.granted()) {
      text += " could cause it, but " + group(of) + " waits itself";
    } else if (const Index outside = unpromised(row); outside != nil) {
      text += " cannot cause it now: " + std::string(n_.condition(n_.self, outside)) +
              " is false, and no enabled provider promises that";
    } else {
      text += " could cause it, and is not pushed for " + edge(because.edge);
      if (pushed != nil) text += ", because " + provider(pushed) + " is";
      if (pushed == nil && outranks(standing.holder, because.member)) text += ": " + holder_words(of);
    }
    add(std::move(text), About::provider, row);
  }

  /// A false condition of the provider that no push can make true; `nil`: none.
  Index unpromised(Index row) const {
    for (const Index each : t_.list(t_.providers[row].when)) {
      if (lacks(each) && !is_promised(each)) return each;
    }
    return nil;
  }

  bool lacks(Index condition) const {
    return !t_.accepts(t_.conditions[condition], v_.values[t_.conditions[condition].state].value);
  }

  bool is_promised(Index condition) const {
    return any(causers(t_, condition), [&](Index provider) { return v_.enabled[provider] != 0; });
  }

  bool is_requested(Index group) const {
    for (const Index edge : t_.list(t_.groups[group].requesters)) {
      if (v_.requested(edge)) return true;
    }
    return false;
  }

  /// A push has an effect only on what goes after the request that made it.
  bool outranks(Index holder, Index request) const {
    return holder != nil && request != nil && !v_.is_limbo(holder) && stands_in_the_way(v_, holder, request);
  }

  std::string holder_words(Index of) const {
    return group(of) + " is held by " + edge(v_.holder(of)) + ", which does not rank after it";
  }

  void disabled(Index group) {
    const Range providers = t_.groups[group].providers;
    for (Index row = providers.begin; row != providers.end; ++row) {
      if (v_.enabled[row] == 0) add(provider(row) + " is disabled", About::provider, row);
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
    for (const Index edge : members) tasks.push_back(group(t_.edges[edge].target));
    add(group(requester) + " requests " + listed(tasks) + " as one unit, which is granted as a whole or waits",
        About::edge, because.edge);
    for (const Index contested : contested_by(members)) {
      tasks.clear();
      bool is_member = false;
      Index user = nil;
      for (const Index edge : members) {
        const Index target = t_.edges[edge].target;
        is_member = is_member || target == contested;
        if (target == contested || !contains(indispensable(target), contested)) continue;
        tasks.push_back(group(target));
        if (user == nil || user == because.edge) user = edge; // the place of the other one, if there are two
      }
      add(listed(tasks) + (is_member ? tasks.size() == 1 ? " needs " : " need " : " each need ") + group(contested) +
              (is_member ? ", which is another task of the unit" : ""),
          About::edge, user);
    }
  }

  static bool contains(const std::vector<Index>& list, Index row) {
    return std::find(list.begin(), list.end(), row) != list.end();
  }

  /// "a, b and c".
  static std::string listed(const std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i)
      out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return out;
  }

  /// The groups that more than one of the edges has to take, without those that are only needed by another one of them.
  std::vector<Index> contested_by(const std::vector<Index>& edges) {
    std::map<Index, std::size_t> takers;
    for (const Index edge : edges) {
      for (const Index row : indispensable(t_.edges[edge].target)) ++takers[row];
    }
    std::vector<Index> shared, out;
    for (const auto& [row, count] : takers) {
      if (count > 1) shared.push_back(row);
    }
    std::copy_if(shared.begin(), shared.end(), std::back_inserter(out), [&](Index row) {
      return std::none_of(shared.begin(), shared.end(),
                          [&](Index other) { return other != row && contains(indispensable(other), row); });
    });
    return out;
  }

  /// The group, and what every enabled provider of it needs, directly or not.
  const std::vector<Index>& indispensable(Index group_row) {
    const auto known = indispensable_.find(group_row);
    if (known != indispensable_.end()) return known->second;
    indispensable_[group_row] = {group_row}; // also while the groups below are examined: a cycle ends here
    std::optional<std::vector<Index>> common;
    for (const Index provider : t_.groups[group_row].providers.rows()) {
      if (v_.enabled[provider] == 0) continue;
      std::vector<Index> needs;
      for (const Index need : t_.list(t_.providers[provider].needs)) {
        for (const Index row : indispensable(t_.edges[need].target)) needs.push_back(row);
      }
      if (!common) {
        common = std::move(needs);
      } else {
        std::erase_if(*common, [&](Index row) { return !contains(needs, row); });
      }
    }
    std::vector<Index>& out = indispensable_[group_row];
    for (const Index row : common.value_or(std::vector<Index>{})) {
      if (!contains(out, row)) out.push_back(row);
    }
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
          add(group(requester) + (lives ? " may need it, and does not now" : " may need it, and does not run"),
              About::edge, edge);
          continue;
        }
        add(group(requester) + (lives ? " may, and does not request it now" : " may, and does not run"), About::edge,
            edge);
      }
    }
  }

  const View& v_;
  const Tables& t_;
  const Names& n_;
  std::vector<WhyNote> notes_;
  std::map<Index, std::vector<Index>> indispensable_; ///< by group
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
