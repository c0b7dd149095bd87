// Header: compiler/transitions/matrix.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
//
// A cell is two or three plays of a text: the row's beginning, then the column's request, then the row's done. The
// values from outside for the column are searched, the fewest first: none, since what is missing may be pushed for;
// then one of those that the column's conditions need; and so on.
#include "compiler/transitions/matrix.hpp"

#include "compiler/base/list_of.hpp"
#include "compiler/transitions/beginnings.hpp"
#include "compiler/transitions/changes.hpp"
#include "compiler/transitions/judge.hpp"
#include "compiler/transitions/scenario_pieces.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace director::compiler {

namespace transitions {

class TransitionFinder {
public:
  /// `behaviour`: its file, as it is written in a scenario.
  TransitionFinder(const Model& model, const Lowered& lowered, std::string behaviour)
      : model_(model),
        player_(model, lowered, behaviour),
        judge_(model, lowered, player_),
        beginner_(model, player_),
        pieces_(model, std::move(behaviour)),
        leaves_choice_(leaves_choice(model)) {}

  /// `only`: these rows; empty: all. `most`: work.
  TransitionMatrix find(const std::vector<GroupId>& only, std::size_t most) {
    std::vector<GroupId> wanted;
    const IdSet<GroupId> led_to = find_led_to(model_);
    for (const GroupId id : model_.groups.ids()) {
      if (model_.groups[id].edges.empty()) continue;
      if (!only.empty() && std::find(only.begin(), only.end(), id) == only.end()) continue;
      (led_to.contains(id) ? wanted : out_.not_requested).push_back(id);
    }
    if (wanted.size() > most_rows) {
      out_.left_out = fmt::format(
          "The transition matrix is left out: {} groups would be its rows, and it is played for at "
          "most {}. `directorc docs --transitions GROUP,GROUP` plays it for some of them; a deployment that "
          "requests fewer has one of all.",
          wanted.size(), most_rows);
      return std::move(out_);
    }
    out_.limited = !only.empty();
    for (const GroupId id : wanted) out_.rows.push_back(row(id, find_ways(model_, id)));
    for (std::size_t i = 0; i < out_.rows.size(); ++i) {
      std::vector<Transition> cells;
      for (std::size_t j = 0; j < out_.rows.size() && work() <= most; ++j) cells.push_back(cell(i, j));
      out_.rows[i].cells = std::move(cells);
    }
    if (work() > most) leave_out();
    return std::move(out_);
  }

  Transition between(GroupId first, GroupId second) {
    const std::optional<std::size_t> from = row_of(first), to = row_of(second);
    return from && to ? cell(*from, *to) : Transition{};
  }

  bool reaches(GroupId group) {
    const std::optional<std::size_t> row = row_of(group);
    return row && out_.rows[*row].reached;
  }

  std::size_t work() const { return player_.work(); }

private:
  using Kind = Transition::Kind;

  void leave_out() {
    out_.left_out = fmt::format("The transition matrix is left out: playing all {} of its cells would take too long. "
                                "`directorc docs --transitions GROUP,GROUP` plays it for some groups.",
                                out_.rows.size() * out_.rows.size());
    out_.rows.clear();
    out_.pieces.clear();
  }

  /// Empty if no chain leads there.
  std::optional<std::size_t> row_of(GroupId id) {
    const auto [at, fresh] = row_of_.try_emplace(id, std::nullopt);
    if (!fresh) return at->second;
    const std::vector<Way> ways = find_ways(model_, id);
    if (ways.empty()) return {};
    out_.rows.push_back(row(id, ways));
    at->second = out_.rows.size() - 1;
    return at->second;
  }

  TransitionMatrix::Row row(GroupId id, const std::vector<Way>& ways) {
    TransitionMatrix::Row out;
    out.group = id;
    beginnings_.emplace_back();
    std::string why;
    if (std::optional<Beginning> found = beginner_.find(ways, why)) {
      const auto& [way, outside] = std::tie(found->way, found->outside);
      out.given = words_of(outside.given, model_);
      out.reached = true;
      out.states = words_of(outside.values, model_);
      for (std::size_t i = 0; i < way.links.size(); ++i) out.chain.push_back(way.group(i));
      out.words = words_of(out, model_);
      beginnings_.back() = std::move(*found);
      return out;
    }
    out.words =
        why.empty() ? "No values from outside were found that meet all conditions on the way to it." : why + ".";
    return out;
  }

  /// The row's beginning, with `only_certain` if it can begin so.
  const Beginning& certain_beginning(std::size_t row) {
    const Beginning& usual = beginnings_[row];
    if (usual.only_certain) return usual;
    const auto [at, fresh] = certain_beginnings_.try_emplace(row, usual);
    std::string why;
    if (!fresh) return at->second;
    if (std::optional<Beginning> found = beginner_.begin(usual.way, usual.outside, true, why))
      at->second = std::move(*found);
    return at->second;
  }

  Transition cell(std::size_t i, std::size_t j) {
    Transition out;
    const TransitionMatrix::Row &first = out_.rows[i], &second = out_.rows[j];
    CellContext context{model_, first, second};
    if (first.reached && second.reached) {
      const Beginning& column = beginnings_[j];
      const Beginning& row = column.only_certain ? certain_beginning(i) : beginnings_[i];
      const bool same = i == j || row.way.passes(second.group) || column.way.passes(first.group) ||
                        row.rest.is_under(model_, second.group, row.way.last().edge);
      out.kind = same ? Kind::same_chain : Kind::never;
      if (!same) decide(row, column, out, context);
      if ((is_stuck(out) || context.ender) && leaves_choice_ && !row.only_certain) {
        if (std::optional<Transition> certain = certain_cell(i, j)) return std::move(*certain);
      }
      if (is_stuck(out)) {
        if (std::optional<Transition> given = given_cell(i, j, row)) return std::move(*given);
      }
    } else if (i == j) {
      out.kind = Kind::unreachable;
    }
    out.words = words_of(out, context);
    return out;
  }

  static bool is_stuck(const Transition& cell) { return cell.kind == Kind::never || cell.kind == Kind::endless; }

  /// Nothing if the column never runs, or the engine does not come to rest.
  std::optional<Transition> running_cell(const Beginning& row, const Beginning& column, CellContext& context) {
    Transition out;
    out.kind = Kind::never;
    decide(row, column, out, context);
    return is_stuck(out) ? std::nullopt : std::optional(std::move(out));
  }

  /// With `only_certain`, if the column runs then: what a body may choose should not be why it does not, nor why the
  /// row ends.
  std::optional<Transition> certain_cell(std::size_t i, std::size_t j) {
    const Beginning& row = certain_beginning(i);
    if (!row.only_certain) return {};
    CellContext context{model_, out_.rows[i], out_.rows[j]};
    std::optional<Transition> out = running_cell(row, beginnings_[j], context);
    if (out) out->words = words_of(*out, context);
    return out;
  }

  /// With the values that the column begins with and that bodies on its chain set, if the column runs then.
  std::optional<Transition> given_cell(std::size_t i, std::size_t j, Beginning row) {
    const Beginning& column = beginnings_[j];
    const std::vector<ProviderId> setters = beside(model_, column.way);
    for (const ProviderId id : setters) {
      for (const auto& each : settable(model_, id, column.outside.given)) {
        const auto now = row.rest.values.find(each.first);
        if (now == row.rest.values.end() || now->second != each.second) row.given.insert(each);
      }
    }
    if (row.given.empty()) return {};
    CellContext context{model_, out_.rows[i], out_.rows[j]};
    std::optional<Transition> out = running_cell(row, column, context);
    if (!out) return {};
    std::vector<std::pair<ProviderId, Values>> set; // in the order in which they ran
    for (const SetState& each : context.set_states) {
      const auto given = row.given.find(each.state);
      if (given == row.given.end() || given->second != each.value) continue;
      if (std::find(setters.begin(), setters.end(), each.by) == setters.end()) continue;
      auto at = std::find_if(set.begin(), set.end(), [&](const auto& entry) { return entry.first == each.by; });
      if (at == set.end()) at = set.insert(at, {each.by, {}});
      at->second.insert(*given);
    }
    if (set.empty()) return {}; // it does not run because of that
    out->words = words_of(*out, context);
    for (const auto& [id, values] : set)
      out->words += fmt::format(" {} sets {}.", model_.full_name(id), list_of(words_of(values, model_)));
    return out;
  }

  void decide(const Beginning& row, const Beginning& column, Transition& out, CellContext& context) {
    const Script script = script_of(model_, row.way, column.way, row.until());
    const std::string begin = player_.beginning(row.way, row.outside);
    const auto& [all, usual] = changes_for(model_, row, column);
    std::optional<Play> decided;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Values& change = all[i];
      const bool is_usual = i < usual;
      const Play now = player_.play(script, begin + request_step(model_, column.way, change), 2, column.way);
      if (runs_now(row, column, now, change, out, context) ||
          (is_undone(now.trial, change) && runs_where_the_outside_stands(row, column, now, change, out, context)))
        return;
      if (is_usual && never_rests(now, change, out, context)) return;
      const Play later = player_.play(script, now.steps + done_step(), 2, column.way);
      context.when_done = true;
      if (is_usual && never_rests(later, change, out, context)) return;
      context.when_done = false;
      const bool runs_later = later.trial.good && runs_at_all(later.trial.rest, column.way);
      if (!is_usual && !runs_later) continue; // that it never runs is said of the usual values
      const bool ends = runs_later && !runs(now.trial.rest, row.way) && player_.ends_by(row, column, change, {});
      out.kind = ends ? Kind::condition_lost : runs_later ? Kind::waits : Kind::never;
      out.states = words_of(change, model_);
      out.pushes = judge_.pushes_of(now.trial, row);
      judge_.find_losses(row, column, now.trial, out, context);
      context.row_ended = !runs(now.trial.rest, row.way);
      context.why = runs_later ? now.trial.why : later.trial.why;
      context.is_requested = now.trial.is_requested;
      decided = later;
      if (runs_later) break;
    }
    if (decided) keep_play(*decided, context, out);
  }

  bool runs_now(const Beginning& row, const Beginning& column, const Play& now, const Values& change, Transition& out,
                CellContext& context) {
    if (!now.trial.good || !runs_at_all(now.trial.rest, column.way)) return false;
    out.states = words_of(change, model_);
    judge_.judge(row, column, now, change, out, context);
    keep_play(now, context, out);
    return true;
  }

  bool never_rests(const Play& play, const Values& change, Transition& out, CellContext& context) {
    if (!play.trial.endless) return false;
    out.kind = Kind::endless;
    out.states = words_of(change, model_);
    context.round = play.trial.round;
    keep_play(play, context, out);
    return true;
  }

  /// Whether a value that was just set from outside has changed already.
  static bool is_undone(const Trial& trial, const Values& change) {
    return std::any_of(change.begin(), change.end(), [&](const auto& entry) {
      const auto at = trial.rest.values.find(entry.first);
      return at == trial.rest.values.end() || at->second != entry.second;
    });
  }

  /// A promise takes time, and does not change sensed values.
  bool runs_where_the_outside_stands(const Beginning& row, const Beginning& column, const Play& before,
                                     const Values& change, Transition& out, CellContext& context) {
    const Script script = script_of(model_, row.way, column.way, row.until(change));
    return runs_now(row, column, player_.play(script, before.steps, 2, column.way), change, out, context);
  }

  void keep_play(const Play& play, CellContext& context, Transition& out) {
    context.set_states = set_states_of(play.trial.events);
    out.scenario = pieces_.scenario_of(play, context.row.group, context.column.group, out_.pieces);
  }

  const Model& model_;
  const Player player_;
  const Judge judge_;
  const Beginnings beginner_;
  ScenarioPieces pieces_;
  bool leaves_choice_ = false;
  TransitionMatrix out_;
  std::vector<Beginning> beginnings_;                    ///< by row
  std::map<std::size_t, Beginning> certain_beginnings_;  ///< by index of the row, on first use: with `only_certain`
  std::map<GroupId, std::optional<std::size_t>> row_of_; ///< indices of rows, which are made on first use
};

} // namespace transitions

TransitionMatrix find_transitions(const Model& model, const Lowered& lowered, const std::string& behaviour,
                                  const std::vector<GroupId>& only, std::size_t most_work) {
  return transitions::TransitionFinder(model, lowered, dsl::yaml_word(behaviour)).find(only, most_work);
}

struct TransitionPlays::Finder : transitions::TransitionFinder {
  using TransitionFinder::TransitionFinder;
};

TransitionPlays::TransitionPlays(const Model& model, const Lowered& lowered)
    : finder_(std::make_unique<Finder>(model, lowered, "behaviour.yaml")) {}

TransitionPlays::~TransitionPlays() = default;

Transition TransitionPlays::between(GroupId first, GroupId second) { return finder_->between(first, second); }

bool TransitionPlays::reaches(GroupId group) { return finder_->reaches(group); }

std::size_t TransitionPlays::work() const { return finder_->work(); }

} // namespace director::compiler
