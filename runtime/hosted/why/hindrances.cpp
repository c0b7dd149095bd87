// Header: runtime/hosted/why/hindrances.hpp. Test: tests/compiler/cli/commands/why_test.cpp,
// tests/runtime/live/moment_lines_test.cpp. SPDX-License-Identifier: MIT
#include "runtime/hosted/why/hindrances.hpp"

#include <algorithm>

namespace director {

std::string Hindrances::hindrance(Index row, Index request) const {
  if (v_.enabled[row] == 0) return "is disabled";
  for (const Index each : t_.list(t_.providers[row].when)) {
    if (!lacks(each)) continue;
    const Index state = t_.conditions[each].state;
    return words_.condition(each) + " is false: " + words_.state(state) + " is " + words_.value(state);
  }
  for (const Index need : t_.list(t_.providers[row].needs)) {
    const Index target = t_.edges[need].target, holder = v_.holder(target);
    if (is_in_the_way(holder, need, request)) return words_.group(target) + " is held by " + words_.edge(holder);
  }
  return "";
}

std::string Hindrances::causer(Index row, const Because& because, Index pushed) const {
  const Index of = t_.providers[row].group;
  const GroupAssignment& standing = v_.assignment[of];
  std::string text = words_.provider(row);
  if (v_.enabled[row] == 0) {
    text += is_pushed(row) ? " is pushed for " + words_.edge(standing.push.edge) + ", and is disabled"
                           : " could cause it, and is disabled";
  } else if (standing.active == row && (standing.flags & flag::in_force) != 0) {
    text += " is to cause it: pushed for " + words_.edge(standing.push.edge);
  } else if (standing.active == row) {
    text += " could cause it, and runs";
  } else if (is_pushed(row) && outranks(standing.holder, standing.push.edge)) {
    text += " is pushed for " + words_.edge(standing.push.edge) + ", without effect: " + holder_words(of);
  } else if (is_pushed(row)) {
    const std::string reason = hindrance_with_needs(row, standing.push.edge);
    text += " is pushed for " + words_.edge(standing.push.edge) + ", and cannot run now" +
            (reason.empty() ? "" : ": " + reason);
  } else if (!is_requested(of)) {
    text += " could cause it, but nothing requests " + words_.group(of);
  } else if (!standing.granted()) {
    text += " could cause it, but " + words_.group(of) + " waits itself";
  } else if (const Index outside = unpromised(row); outside != nil) {
    text += " cannot cause it now: " + words_.condition(outside) + " is false, and no enabled provider promises that";
  } else {
    text += " could cause it, and is not pushed for " + words_.edge(because.edge);
    if (pushed != nil) text += ", because " + words_.provider(pushed) + " is";
    if (pushed == nil && outranks(standing.holder, because.member)) text += ": " + holder_words(of);
  }
  return text;
}

bool Hindrances::is_pushed(Index row) const {
  const Push& push = v_.assignment[t_.providers[row].group].push;
  return push.edge != nil && push.provider == row;
}

bool Hindrances::is_requested(Index group) const {
  for (const Index edge : t_.list(t_.groups[group].requesters)) {
    if (v_.requested(edge)) return true;
  }
  return false;
}

std::string Hindrances::holder_words(Index of) const {
  return words_.group(of) + " is held by " + words_.edge(v_.holder(of)) + ", which does not rank after it";
}

/// Or what keeps the only provider of a need from running, or of a need of that.
std::string Hindrances::hindrance_with_needs(Index row, Index request) const {
  std::string out = hindrance(row, request);
  for (const Index need : t_.list(t_.providers[row].needs)) {
    const Range providers = t_.groups[t_.edges[need].target].providers;
    if (!out.empty() || providers.size() != 1) continue;
    out = hindrance_with_needs(providers.begin, request);
    if (out.empty()) continue;
    out = words_.group(t_.edges[need].target) + ", which it needs, " +
          (v_.enabled[providers.begin] == 0 ? "" : "cannot run: ") + out;
  }
  return out;
}

bool Hindrances::is_in_the_way(Index holder, Index need, Index request) const {
  return holder != nil && holder != need && request != nil && !v_.is_limbo(holder) &&
         stands_in_the_way(v_, holder, request);
}

bool Hindrances::find_plan(Index row, Index request, std::vector<Index>& plan) const {
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

/// A false condition of the provider that no push can make true; `nil`: none.
Index Hindrances::unpromised(Index row) const {
  for (const Index each : t_.list(t_.providers[row].when)) {
    if (lacks(each) && !is_promised(each)) return each;
  }
  return nil;
}

bool Hindrances::lacks(Index condition) const {
  return !t_.accepts(t_.conditions[condition], v_.values[t_.conditions[condition].state].value);
}

bool Hindrances::is_promised(Index condition) const {
  return any(causers(t_, condition), [&](Index provider) { return v_.enabled[provider] != 0; });
}

/// A push has an effect only on what goes after the request that made it.
bool Hindrances::outranks(Index holder, Index request) const {
  return holder != nil && request != nil && !v_.is_limbo(holder) && stands_in_the_way(v_, holder, request);
}

} // namespace director
