// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.4: a unit that is refused, and the pushes that it may make. Which pushes of other units conflict with
// these is unknown, so there are two answers for what can be pushed: certainly, and possibly. The shortest path is
// among those that are no longer than the shortest certain one.
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

template <class List>
bool contains(const List& rows, Row row) {
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

} // namespace

void Pass::refuse(const Unit& unit) {
  for (const Row member : unit) refused_ |= bit(member);
  const std::optional<Combination> combination = first_combination(unit, false);
  if (!combination) return; // blocked: it loses its pushes
  const auto keep = [&] {
    for (const Row member : unit) keeping_ |= bit(member);
  };
  if (deferred(*combination)) return keep();
  Rows causable = 0;
  for (const Component::ProviderRow& provider : part_.providers) causable |= provider.causes;
  for (const Choice& choice : *combination) {
    if ((choice.lacking & ~causable) != 0) return; // it waits for inputs from outside
  }
  keep();
  std::vector<PossiblePush> made;
  for (const Choice& choice : *combination) {
    for (const Row condition : lacking_in_order(choice)) {
      const std::size_t before = made.size();
      add_pushes(choice.chain, condition, unit, made);
      if (made.size() == before && !may_be_kept_for(condition, unit)) return; // not served: no new push is made
    }
  }
  for (const PossiblePush& push : made) {
    if (std::find(gathered_.found.begin(), gathered_.found.end(), push) == gathered_.found.end())
      gathered_.found.push_back(push);
  }
}

std::vector<Row> Pass::lacking_in_order(const Choice& choice) const {
  std::vector<Row> out;
  const auto add = [&](Row provider) {
    for (const Row condition : part_.providers[provider].when) {
      if ((choice.lacking & bit(condition)) != 0) out.push_back(condition);
    }
  };
  add(choice.provider);
  for (const Component::Planned& entry : part_.providers[choice.provider].plans[choice.plan]) add(entry.provider);
  return out;
}

bool Pass::may_be_kept_for(Row condition, const Unit& unit) const {
  return std::any_of(gathered_.pushes.begin(), gathered_.pushes.end(), [&](const PossiblePush& push) {
    return contains(unit, push.by) && (part_.providers[push.to].causes & bit(condition)) != 0;
  });
}

bool Pass::can_be_pushed(Row provider, const Chain& member, const Unit& unit, bool surely) const {
  const Row group = part_.providers[provider].group;
  if (now_.by[group] != nothing) return false;
  if (surely && std::any_of(gathered_.pushes.begin(), gathered_.pushes.end(), [&](const PossiblePush& push) {
        return part_.providers[push.to].group == group && push.to != provider && !contains(unit, push.by);
      }))
    return false;
  return std::any_of(part_.groups[group].requesters.begin(), part_.groups[group].requesters.end(), [&](Row edge) {
    if (last_.level[edge] == nothing || edge == member.edge()) return false;
    const Chain requesting = before_now(edge);
    return requesting.complete && before(member, requesting) && !requesting.below(member.edge());
  });
}

/// The length of the path by this provider; 0: there is none.
int Pass::way(Row provider, const Chain& member, const Unit& unit, bool surely, const Lengths& known,
              std::vector<Row>* first_lacking) {
  gathered_.steps += static_cast<std::int64_t>(part_.providers[provider].plans.size());
  if (!can_be_pushed(provider, member, unit, surely)) return 0;
  int best = 0;
  for (const Component::Plan& plan : part_.providers[provider].plans) {
    int length = 1;
    bool is_way = true;
    Row first = nothing;
    const auto add = [&](Row one) {
      const Rows missing = lacking(one);
      for (const Row condition : part_.providers[one].when) {
        if ((missing & bit(condition)) == 0) continue;
        is_way = is_way && known[condition] != 0;
        length += known[condition];
        if (first == nothing) first = condition;
      }
    };
    add(provider);
    for (const Component::Planned& entry : plan) {
      is_way = is_way && now_.by[entry.group] == nothing;
      add(entry.provider);
    }
    if (!is_way) continue;
    if (first_lacking != nullptr) first_lacking->push_back(first);
    if (best == 0 || length < best) best = length;
  }
  return best;
}

/// A least fixed point: lengths only decrease.
Pass::Lengths Pass::search(const Chain& member, const Unit& unit, bool surely) {
  Lengths known{};
  for (bool more = true; more;) {
    more = false;
    for (Row provider = 0; provider < part_.providers.size(); ++provider) {
      const Rows causes = part_.providers[provider].causes;
      ++gathered_.steps;
      if (causes == 0) continue;
      const int length = way(provider, member, unit, surely, known, nullptr);
      if (length == 0) continue;
      for (const Row condition : each(causes)) {
        if (known[condition] != 0 && known[condition] <= length) continue;
        known[condition] = length;
        more = true;
      }
    }
  }
  return known;
}

/// Adds the pushes of paths that may be the shortest, each with the last provider.
void Pass::add_pushes(const Chain& member, Row unmet, const Unit& unit, std::vector<PossiblePush>& out) {
  const Lengths maybe = search(member, unit, false), sure = search(member, unit, true);
  if (maybe[unmet] == 0) return;
  Rows seen = bit(unmet);
  for (std::vector<Row> open{unmet}; !open.empty();) {
    const Row aim = open.back();
    open.pop_back();
    Row best = nothing; // of the certain ones
    for (Row provider = 0; provider < part_.providers.size(); ++provider) {
      if ((part_.providers[provider].causes & bit(aim)) == 0) continue;
      std::vector<Row> lacking;
      const int length = way(provider, member, unit, false, maybe, &lacking);
      if (length == 0) continue;
      const bool is_late = sure[aim] != 0 && (length > sure[aim] || (length == sure[aim] && best != nothing));
      if (is_late) continue;
      if (sure[aim] != 0 && way(provider, member, unit, true, sure, nullptr) == sure[aim]) best = provider;
      for (const Row next : lacking) {
        if (next == nothing) {
          out.push_back({member.edge(), provider, aim});
        } else if ((seen & bit(next)) == 0) {
          seen |= bit(next);
          open.push_back(next);
        }
      }
    }
  }
}

} // namespace director::analysis
