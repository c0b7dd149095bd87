// Header: compiler/analysis/states/covering.hpp. Test: tests/compiler/analysis/states/covering_test.cpp.
// SPDX-License-Identifier: MIT
//
// Every region has to lack something: one of its states has a value that it does not accept. That is satisfiability of
// clauses over many-valued variables: if only one state of a region can still deny it, that state is decided (unit
// propagation); if nothing more follows, the state that occurs in the most and shortest open regions is split in two
// (Davis, Logemann and Loveland 1962; Jeroslow and Wang 1990). A group has at most some hundred providers: there a
// search that learns from conflicts (CaDiCaL 1.5.3) took two to twenty times as long, and decision diagrams of random
// conditions on sixty states exceeded all memory.
#include "compiler/analysis/states/covering.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace director::analysis {

namespace {

/// For one question: a real one takes a thousandth, and this a fraction of a second.
constexpr std::int64_t covering_steps = 2'000'000;

using Word = std::uint64_t;
constexpr std::size_t word_bits = 64;

/// A state, cut where some region begins or ends: between two cuts all values are equivalent.
struct Column {
  StateId state{};
  std::vector<ValueSet::Interval> cells;
  bool may_be_unset = false; ///< then the bit after those of the cells
  std::size_t first = 0;     ///< of its words, in the row of all columns
  std::size_t words = 0;
};

/// What one region accepts of one state.
struct Entry {
  std::size_t column;
  std::size_t mask; ///< its first word, in the row of all masks
};

Possible possible_at(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start, StateId state) {
  const auto at = start.find(state);
  return at == start.end() ? Possible{values[state], model.states[state].may_be_unset()} : at->second;
}

/// Whether no place of the box is in the region.
bool is_apart(const IdTable<StateId, ValueSet>& values, const Box& box, const Region& region) {
  return std::any_of(region.states.begin(), region.states.end(), [&](const auto& entry) {
    const auto at = box.find(entry.first);
    return !(at == box.end() ? values[entry.first] : at->second.values).overlaps(entry.second);
  });
}

class OpeningSearch {
public:
  OpeningSearch(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start,
                const std::vector<Region>& regions, std::int64_t steps)
      : steps_(steps) {
    std::map<StateId, std::vector<const ValueSet*>> accepted;
    for (const Region& region : regions) {
      for (const auto& [state, set] : region.states) accepted[state].push_back(&set);
    }
    std::map<StateId, std::size_t> places;
    for (const auto& [state, sets] : accepted) {
      places[state] = columns_.size();
      add_column(state, possible_at(model, values, start, state), sets);
    }
    first_entry_.push_back(0);
    for (const Region& region : regions) {
      for (const auto& [state, set] : region.states) add_entry(places[state], set);
      first_entry_.push_back(entries_.size());
    }
  }

  Covering run() {
    std::vector<std::size_t> all(first_entry_.size() - 1);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    open_.push_back(std::move(all));
    while (steps_ > 0) {
      if (!narrow()) {
        if (!turn_back()) return Covering::covered;
      } else if (open_.back().empty()) {
        return Covering::open;
      } else {
        split();
      }
    }
    return Covering::undecided;
  }

  std::int64_t steps_left() const { return std::max<std::int64_t>(steps_, 0); }

  /// What is left of the states in the regions.
  Box box() const {
    Box out;
    for (const Column& column : columns_) {
      Possible& here = out[column.state];
      for (std::size_t i = 0; i < column.cells.size(); ++i) {
        if (has_bit(&now_[column.first], i)) here.values.add_last(column.cells[i]);
      }
      here.unset = column.may_be_unset && has_bit(&now_[column.first], column.cells.size());
    }
    return out;
  }

private:
  /// A state that was split, to try the other part if this one has no solution.
  struct Split {
    std::size_t changes;
    Entry entry;
  };
  struct Change {
    std::size_t word;
    Word before;
  };

  static bool has_bit(const Word* words, std::size_t bit) {
    return ((words[bit / word_bits] >> (bit % word_bits)) & 1U) != 0;
  }
  static void set_bit(std::vector<Word>& words, std::size_t first, std::size_t bit) {
    words[first + bit / word_bits] |= Word{1} << (bit % word_bits);
  }

  void add_column(StateId state, const Possible& possible, const std::vector<const ValueSet*>& sets) {
    Column column{state, {}, possible.unset, now_.size(), 0};
    std::vector<std::int64_t> cuts; // where something begins
    for (const ValueSet* set : sets) {
      for (const ValueSet::Interval& each : set->intervals()) {
        cuts.push_back(each.low);
        if (each.high != std::numeric_limits<std::int64_t>::max()) cuts.push_back(each.high + 1);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (const ValueSet::Interval& each : possible.values.intervals()) {
      std::int64_t low = each.low;
      for (auto cut = std::upper_bound(cuts.begin(), cuts.end(), low); cut != cuts.end() && *cut <= each.high; ++cut) {
        column.cells.push_back({low, *cut - 1});
        low = *cut;
      }
      column.cells.push_back({low, each.high});
    }
    const std::size_t bits = column.cells.size() + (possible.unset ? 1 : 0);
    column.words = std::max<std::size_t>((bits + word_bits - 1) / word_bits, 1);
    now_.resize(now_.size() + column.words, 0);
    for (std::size_t bit = 0; bit < bits; ++bit) set_bit(now_, column.first, bit);
    columns_.push_back(std::move(column));
  }

  void add_entry(std::size_t place, const ValueSet& accepted) {
    const Column& column = columns_[place];
    const std::size_t mask = masks_.size();
    masks_.resize(mask + column.words, 0);
    steps_ -= static_cast<std::int64_t>(column.words);
    // A cell is completely within an accepted interval, or completely outside.
    for (const ValueSet::Interval& each : accepted.intervals()) {
      const auto begins_before = [](const ValueSet::Interval& cell, std::int64_t low) { return cell.low < low; };
      auto cell = std::lower_bound(column.cells.begin(), column.cells.end(), each.low, begins_before);
      for (; cell != column.cells.end() && cell->low <= each.high; ++cell)
        set_bit(masks_, mask, static_cast<std::size_t>(cell - column.cells.begin()));
    }
    entries_.push_back({place, mask});
  }

  /// Whether the state can still have a value that the region accepts, and one that it does not.
  struct Standing {
    bool may_hold = false, may_lack = false;
  };
  Standing standing(const Entry& entry) const {
    const Column& column = columns_[entry.column];
    Standing out;
    for (std::size_t i = 0; i < column.words; ++i) {
      const Word here = now_[column.first + i], mask = masks_[entry.mask + i];
      out.may_hold = out.may_hold || (here & mask) != 0;
      out.may_lack = out.may_lack || (here & ~mask) != 0;
    }
    return out;
  }

  void keep(const Entry& entry, bool accepted) {
    const Column& column = columns_[entry.column];
    for (std::size_t i = 0; i < column.words; ++i) {
      Word& here = now_[column.first + i];
      changes_.push_back({column.first + i, here});
      here &= accepted ? masks_[entry.mask + i] : ~masks_[entry.mask + i];
    }
  }

  /// The status of a region: it certainly lacks something, or these of its states can still have a value that it does
  /// not accept.
  struct Chances {
    bool lacks = false;
    std::size_t count = 0;
    std::size_t last = 0; ///< entry
  };
  Chances chances(std::size_t region) {
    Chances out;
    for (std::size_t i = first_entry_[region]; i < first_entry_[region + 1] && !out.lacks; ++i) {
      --steps_;
      const Standing at = standing(entries_[i]);
      if (!at.may_hold) out.lacks = true;
      if (!at.may_lack) continue;
      ++out.count;
      out.last = i;
    }
    return out;
  }

  /// Unit propagation. False: some region cannot lack anything any more.
  bool narrow() {
    std::vector<std::size_t>& open = open_.back();
    for (bool changed = true; changed;) {
      changed = false;
      std::size_t kept = 0;
      for (const std::size_t region : open) {
        --steps_;
        const Chances at = chances(region);
        if (at.lacks) continue;
        if (at.count == 0) return false;
        if (at.count == 1) {
          keep(entries_[at.last], false);
          changed = true;
        } else {
          open[kept++] = region;
        }
      }
      open.resize(kept);
    }
    return true;
  }

  void split() {
    // A region with one chance less counts four times as much.
    constexpr std::size_t most_weighed = 15;
    std::vector<std::uint64_t> weights(columns_.size(), 0);
    for (const std::size_t region : open_.back()) {
      const std::uint64_t weight = std::uint64_t{1}
                                   << (2 * (most_weighed - std::min(chances(region).count, most_weighed)));
      for (std::size_t i = first_entry_[region]; i < first_entry_[region + 1]; ++i) {
        if (standing(entries_[i]).may_lack) weights[entries_[i].column] += weight;
      }
    }
    const auto best = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    const Entry* entry = nullptr;
    std::size_t fewest = 0;
    for (const std::size_t region : open_.back()) {
      for (std::size_t i = first_entry_[region]; i < first_entry_[region + 1]; ++i) {
        if (entries_[i].column != best || !standing(entries_[i]).may_lack) continue;
        const std::size_t count = chances(region).count;
        if (entry != nullptr && count >= fewest) continue;
        entry = &entries_[i];
        fewest = count;
      }
    }
    splits_.push_back({changes_.size(), *entry});
    open_.push_back(open_.back());
    keep(*entry, false);
  }

  /// Backtracks to the last split whose other part was not tried.
  bool turn_back() {
    if (splits_.empty()) return false;
    const Split split = splits_.back();
    splits_.pop_back();
    open_.pop_back();
    for (; changes_.size() > split.changes; changes_.pop_back()) now_[changes_.back().word] = changes_.back().before;
    keep(split.entry, true);
    return true;
  }

  std::int64_t steps_;
  std::vector<Column> columns_;
  std::vector<Entry> entries_;           ///< region after region
  std::vector<std::size_t> first_entry_; ///< of each region, and behind the last one
  std::vector<Word> masks_;
  std::vector<Word> now_;                      ///< what is left of each column
  std::vector<std::vector<std::size_t>> open_; ///< regions that do not lack anything yet, after each split
  std::vector<Split> splits_;
  std::vector<Change> changes_;
};

/// All values of some sets, without a copy of what is united so far for each of them.
ValueSet united(const std::vector<const ValueSet*>& sets) {
  std::vector<ValueSet::Interval> all;
  for (const ValueSet* set : sets) all.insert(all.end(), set->intervals().begin(), set->intervals().end());
  std::sort(all.begin(), all.end(),
            [](const ValueSet::Interval& a, const ValueSet::Interval& b) { return a.low < b.low; });
  ValueSet out;
  for (std::size_t i = 0; i < all.size();) {
    ValueSet::Interval joined = all[i];
    for (++i; i < all.size() && all[i].low <= joined.high; ++i) joined.high = std::max(joined.high, all[i].high);
    out.add_last(joined);
  }
  return out;
}

/// Those that restrict the same state and no other one are joined, and come first: unit propagation does the same with
/// them, but each of them would need a mask of all values between which another one begins or ends, and there may be
/// as many as a group has providers.
std::vector<Region> join(const std::vector<const Region*>& regions) {
  std::map<StateId, std::vector<const ValueSet*>> alone;
  for (const Region* region : regions) {
    if (region->states.size() == 1) alone[region->states.begin()->first].push_back(&region->states.begin()->second);
  }
  std::vector<Region> out;
  for (const auto& [state, sets] : alone) out.emplace_back().states.emplace(state, united(sets));
  for (const Region* region : regions) {
    if (region->states.size() != 1) out.push_back(*region);
  }
  return out;
}

/// Whether every place of the box is in the region.
bool is_within(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& box, const Region& region) {
  return std::all_of(region.states.begin(), region.states.end(), [&](const auto& entry) {
    const auto at = box.find(entry.first);
    if (at == box.end())
      return !model.states[entry.first].may_be_unset() && values[entry.first].subset_of(entry.second);
    return !at->second.unset && at->second.values.subset_of(entry.second);
  });
}

/// Adds the initial value of each state, if no region includes any part of it.
void widen(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start,
           const std::vector<Region>& regions, Box& box) {
  for (auto& [state, here] : box) {
    const Possible before = here;
    here = possible_at(model, values, start, state);
    const bool apart = here == before || std::all_of(regions.begin(), regions.end(), [&](const Region& region) {
                         return is_apart(values, box, region);
                       });
    if (!apart) here = before;
  }
}

} // namespace

Box box_of(const IdTable<StateId, ValueSet>& values, const Region& region) {
  Box out;
  for (const auto& [state, accepted] : region.states)
    out.emplace(state, Possible{values[state].intersected(accepted), false});
  return out;
}

Covering find_covering(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start,
                       const std::vector<Region>& regions, Budget& budget, Box* opening) {
  for (const auto& [state, possible] : start) {
    if (possible.empty()) return Covering::covered;
  }
  // Regions outside of the box would only be examined in vain.
  std::vector<const Region*> meeting;
  for (const Region& region : regions) {
    if (is_apart(values, start, region)) continue;
    if (is_within(model, values, start, region)) return Covering::covered;
    meeting.push_back(&region);
  }
  if (opening != nullptr) *opening = start;
  if (meeting.empty() || (meeting.size() == 1 && opening == nullptr)) return Covering::open;
  const std::vector<Region> near = join(meeting);
  const std::int64_t granted = budget.grant(covering_steps);
  OpeningSearch search(model, values, start, near, granted);
  const Covering out = search.run();
  budget.spend(granted - search.steps_left());
  if (out == Covering::open && opening != nullptr) {
    *opening = search.box();
    widen(model, values, start, near, *opening);
    for (const auto& [state, possible] : start) opening->emplace(state, possible);
  }
  return out;
}

} // namespace director::analysis
