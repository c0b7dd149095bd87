// Header: compiler/diff/ranks/shifts.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/ranks/shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace director::compiler::diff {

namespace {

enum class Extent { never, sometimes, always };

Extent extent_of(std::size_t wins, std::size_t all) {
  return wins == 0 ? Extent::never : wins < all ? Extent::sometimes : Extent::always;
}

Extent extent_of(const Encounters& encounters) {
  const auto wins = std::count_if(encounters.begin(), encounters.end(), [](const auto& each) { return each.second; });
  return extent_of(static_cast<std::size_t>(wins), encounters.size());
}

/// How often the group is taken where two tasks are requested at once, in whatever way they lead to it.
struct Taken {
  std::size_t wins = 0, all = 0;
};

std::map<Encounter, Taken> by_place(const Encounters& encounters) {
  std::map<Encounter, Taken> out;
  for (auto [encounter, wins] : encounters) {
    encounter.takes = encounter.loses = {};
    Taken& taken = out[encounter];
    taken.wins += wins ? 1 : 0;
    ++taken.all;
  }
  return out;
}

} // namespace

ChangeKind kind_of(Shift shift) {
  return shift < Shift::lost ? ChangeKind::takeover_gained : ChangeKind::takeover_lost;
}

std::string sentence(Shift shift, const std::string& winner, const std::string& what) {
  const auto [can, cases] = [&]() -> std::pair<const char*, const char*> {
    switch (shift) {
    case Shift::gained: return {"can now", ""};
    case Shift::always: return {"can now always", ""};
    case Shift::more: return {"can", " in more cases now"};
    case Shift::lost: return {"can no longer", ""};
    case Shift::not_always: return {"can no longer always", ""};
    case Shift::fewer: return {"can", " in fewer cases now"};
    case Shift::more_in_passing: return {"can", " in more cases now, while control passes"};
    case Shift::fewer_in_passing: break;
    }
    return {"can", " in fewer cases now, while control passes"};
  }();
  return fmt::format("{} {} take {}{}", winner, can, what, cases);
}

std::vector<Shift> shifts(const Encounters& before, const Encounters& now) {
  const Extent was = extent_of(before), is = extent_of(now);
  if (was != is) {
    if (was == Extent::never) return {Shift::gained};
    if (is == Extent::never) return {Shift::lost};
    return {is == Extent::always ? Shift::always : Shift::not_always};
  }
  if (was != Extent::sometimes) return {};
  bool more = false, fewer = false;
  auto old = before.begin();
  for (const auto& [encounter, wins] : now) {
    while (old != before.end() && old->first < encounter) ++old;
    if (old == before.end() || old->first != encounter) continue;
    more = more || (wins && !old->second);
    fewer = fewer || (!wins && old->second);
  }
  const std::map<Encounter, Taken> places = by_place(before);
  for (const auto& [place, taken] : by_place(now)) {
    const auto at = places.find(place);
    if (at == places.end()) continue;
    const Extent then = extent_of(at->second.wins, at->second.all), here = extent_of(taken.wins, taken.all);
    more = more || here > then;
    fewer = fewer || here < then;
  }
  std::vector<Shift> out;
  if (more) out.push_back(Shift::more);
  if (fewer) out.push_back(Shift::fewer);
  return out;
}

Mate differing_mate(const Encounters& before, const Encounters& now) {
  const auto [was, is] = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
  Mate out; // those without a mate come first
  for (const Encounter* each : {was == before.end() ? nullptr : &was->first, is == now.end() ? nullptr : &is->first}) {
    if (each == nullptr) continue;
    if (each->mate == 0) return {};
    out = {each->mate, each->is_losers};
  }
  return out;
}

} // namespace director::compiler::diff
