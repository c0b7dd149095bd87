// Header: compiler/analysis/uncovered/uncovered.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/uncovered/uncovered.hpp"

#include "compiler/analysis/requests/earlier.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// Gaps of one task are looked for up to this many: a larger number tells the reader nothing more.
constexpr std::size_t most_gaps = 1'000;

class UncoveredFinder {
public:
  UncoveredFinder(const Input& input, const Unserved& unserved)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        grants_(input.conflicts.grants()),
        unserved_(unserved),
        earlier_(model_, facts_, shared_.requests(), shared_.rivals(), shared_.budget()) {}

  std::vector<Uncoveredness> find() {
    for (const GroupId group : model_.groups.ids()) {
      if (facts_.requested.contains(group) && (unserved_.never_runs(group) || grants_.is_tried(group))) look_at(group);
    }
    return std::move(found_);
  }

private:
  struct Gap {
    Box box;
    std::string words;
    const Request* where = nullptr;
  };

  /// Whether the first box is within the second one.
  bool lies_within(const Box& inner, const Box& outer) const {
    return std::all_of(outer.begin(), outer.end(), [&](const auto& entry) {
      const auto at = inner.find(entry.first);
      const Possible all{facts_.values[entry.first], model_.states[entry.first].may_be_unset()};
      const Possible& own = at == inner.end() ? all : at->second;
      return own.values.subset_of(entry.second.values) && (entry.second.unset || !own.unset);
    });
  }

  /// Keeps the larger of two gaps, if one is within the other.
  void add(Gap gap, std::vector<Gap>& gaps) const {
    if (std::any_of(gaps.begin(), gaps.end(), [&](const Gap& each) { return lies_within(gap.box, each.box); })) return;
    const auto is_inner = [&](const Gap& each) { return lies_within(each.box, gap.box); };
    gaps.erase(std::remove_if(gaps.begin(), gaps.end(), is_inner), gaps.end());
    gaps.push_back(std::move(gap));
  }

  /// The parts of a gap in which the request may exist, although earlier providers of its requester go first where they
  /// can run. One of these that looks at no state of the gap is left out of the words: it matters only if nothing
  /// remains.
  std::vector<Box> open_parts(const Request& request, const Box& gap) const {
    if (!request.requester) return {gap};
    std::vector<Region> near;
    for (Region& each : earlier_.before(*request.requester, gap)) {
      const auto is_in_gap = [&](const auto& entry) {
        const auto at = gap.find(entry.first);
        return at != gap.end() &&
               at->second != Possible{facts_.values[entry.first], model_.states[entry.first].may_be_unset()};
      };
      if (std::any_of(each.states.begin(), each.states.end(), is_in_gap)) near.push_back(std::move(each));
    }
    Gaps parts{{gap}};
    if (!near.empty()) parts = find_gaps(model_, facts_, gap, near, shared_.budget());
    if (!parts.decided) parts.boxes = {gap};
    const auto is_closed = [&](const Box& part) { return !earlier_.may_exist(request, part); };
    parts.boxes.erase(std::remove_if(parts.boxes.begin(), parts.boxes.end(), is_closed), parts.boxes.end());
    return std::move(parts.boxes);
  }

  void look_at(GroupId group) {
    if (unserved_.is_in_conflict(group)) return;
    std::vector<Region> open = unserved_.ways_for(group).of(group);
    unserved_.add_cycles(group, open);
    if (unserved_.never_runs(group)) {
      const Request& first = shared_.requests().of(group).front();
      found_.push_back({group, {std::string(everywhere)}, true, {}, &first});
      return;
    }
    if (open.empty() || std::any_of(open.begin(), open.end(), [](const Region& way) { return way.states.empty(); }))
      return;
    std::vector<Gap> gaps;
    std::set<std::string> seen;
    bool all = true; // false: there are more than could be listed
    const auto look = [&](const Box& start, const Request& request) {
      const Gaps found = find_gaps(model_, facts_, start, open, shared_.budget());
      if (!found.decided)
        shared_.budget().leave_open(model_.groups[group].name.span,
                                    fmt::format("whether some provider of {} can always run", name_of(model_, group)));
      all = all && found.all;
      for (const Box& box : found.boxes) {
        for (const Box& part : open_parts(request, box)) {
          std::string words = gap_in_words(model_, facts_, part);
          if (seen.insert(words).second) add({part, std::move(words), &request}, gaps);
        }
      }
    };
    const std::vector<Request>& requests = shared_.requests().of(group);
    const bool is_root =
        std::any_of(requests.begin(), requests.end(), [](const Request& request) { return !request.requester; });
    for (const Request& request : requests) {
      if (is_root && request.requester) continue;
      for (const Region& region : shared_.requests().regions(request)) {
        all = all && gaps.size() < most_gaps;
        if (all || gaps.empty()) look(box_of(facts_.values, region), request);
      }
    }
    if (!gaps.empty()) found_.push_back(finding_for(group, gaps, all));
  }

  static Uncoveredness finding_for(GroupId group, const std::vector<Gap>& gaps, bool all) {
    Uncoveredness out{group, {}, all, {}, gaps.front().where};
    for (const Gap& gap : gaps) {
      out.gaps.push_back(gap.words);
      out.boxes.push_back(gap.box);
    }
    return out;
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Grants& grants_;
  const Unserved& unserved_;
  const Earlier earlier_;
  std::vector<Uncoveredness> found_;
};

} // namespace

std::vector<Uncoveredness> find_uncovered(const Input& input, const Unserved& unserved) {
  return UncoveredFinder(input, unserved).find();
}

} // namespace director::analysis
