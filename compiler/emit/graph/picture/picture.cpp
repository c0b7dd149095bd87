// Header: compiler/emit/graph/picture/picture.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/picture.hpp"

#include "compiler/emit/graph/picture/boxes.hpp"
#include "compiler/emit/graph/picture/focus.hpp"
#include "compiler/emit/graph/picture/group_arrows.hpp"
#include "compiler/emit/graph/picture/layers.hpp"
#include "compiler/emit/graph/picture/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace director::compiler {

namespace {

using ArrowKind = PictureArrow::Kind;
using View = PictureOptions::View;
using Fold = PictureOptions::Fold;

/// Limit: with more boxes an arrow represents all providers and packs of a group, and its tooltip names the requester.
constexpr std::size_t most_boxes_in_detail = 40;

bool is_seen(View view, ArrowKind kind) {
  switch (view) {
  case View::all: return kind != ArrowKind::take;
  case View::tasks: return kind == ArrowKind::task || kind == ArrowKind::both;
  case View::needs: return kind == ArrowKind::need || kind == ArrowKind::both;
  case View::pushes: return kind == ArrowKind::push;
  case View::takes: break;
  }
  return kind == ArrowKind::take;
}

/// Adds the lines that are not there yet.
void add_lines(std::string& all, const std::string& more) {
  for (std::size_t at = 0; at <= more.size();) {
    const std::size_t end = std::min(more.find('\n', at), more.size());
    const std::string line = more.substr(at, end - at);
    if (("\n" + all + "\n").find("\n" + line + "\n") == std::string::npos) all += "\n" + line;
    at = end + 1;
  }
}

class Painter {
public:
  Painter(const Model& model, const Graph& graph, const dsl::Sources& sources, const PictureOptions& options)
      : model_(model),
        graph_(graph),
        options_(options),
        words_(model, sources),
        maker_(model, options, words_),
        box_of_(model.groups.size()) {}

  Picture paint() {
    picture_.title = model_.name;
    picture_.doc = model_.doc;
    picture_.all_groups = model_.groups.size();
    picture_.fold = options_.fold;
    for (const ArrowKind kind : {ArrowKind::task, ArrowKind::need, ArrowKind::push, ArrowKind::take}) {
      if (is_seen(options_.view, kind)) picture_.kinds.push_back(kind);
    }
    if (options_.moment) picture_.moment = options_.moment->title;
    if (options_.moment) picture_.values = options_.moment->values;
    for (const Moment& frame : options_.frames) {
      picture_.longest_head = std::max(picture_.longest_head, frame.title.size());
      for (const std::string& value : frame.values)
        picture_.longest_head = std::max(picture_.longest_head, value.size());
    }
    arrows_ = seen_arrows(Detail::packs);
    add_boxes();
    if (picture_.boxes.size() > most_boxes_in_detail) leave_out_packs();
    add_arrows();
    add_flaws();
    arrange_in_layers(model_, graph_, options_.fold != Fold::layers, picture_);
    if (picture_.boxes.empty()) picture_.nothing = why_empty();
    return std::move(picture_);
  }

private:
  std::vector<GroupArrow> seen_arrows(Detail detail) const {
    const IdSet<GroupId> chosen = groups_in_focus(model_, graph_, options_);
    std::vector<GroupArrow> all = find_requests(model_, detail);
    if (options_.moment) mark_requests(model_, *options_.moment, all);
    for (GroupArrow& push :
         options_.moment ? pushes_of(model_, *options_.moment, options_.frames) : find_pushes(model_, graph_))
      all.push_back(std::move(push));
    for (GroupArrow& take : find_takes(model_, options_.take_overs)) all.push_back(std::move(take));
    std::erase_if(all, [&](const GroupArrow& arrow) {
      if (!is_seen(options_.view, arrow.kind)) return true;
      if (chosen.contains(arrow.from) && chosen.contains(arrow.to)) return false;
      return arrow.kind != ArrowKind::take || !is_in_focus(arrow.from, arrow.to, arrow.over, graph_, options_);
    });
    for (GroupArrow& arrow : all) {
      if (arrow.kind != ArrowKind::both || options_.view == View::all) continue;
      arrow.kind = options_.view == View::tasks ? ArrowKind::task : ArrowKind::need;
    }
    return all;
  }

  void leave_out_packs() {
    picture_.packs_left_out = true;
    arrows_ = seen_arrows(Detail::groups);
    for (PictureBox& box : picture_.boxes) {
      for (PictureRow& row : box.rows) row.packs.clear();
    }
  }

  std::string why_empty() const {
    const std::string where = options_.focus.empty() ? "" : ", of those in the focus";
    if (options_.view == View::pushes)
      return (options_.moment ? "no group is pushed" : "no group may push another one") + where;
    if (options_.view == View::takes)
      return "no group may take anything from one that is not requested below it" + where;
    return "there are no groups";
  }

  /// Whether these views show only the ends of their arrows.
  bool only_ends() const { return options_.view == View::pushes || options_.view == View::takes; }

  IdSet<GroupId> drawn() const {
    if (!only_ends()) return groups_in_focus(model_, graph_, options_);
    IdSet<GroupId> out(model_.groups.size());
    for (const GroupArrow& arrow : arrows_) {
      out.add(arrow.from);
      out.add(arrow.to);
    }
    return out;
  }

  void add_boxes() {
    const IdSet<GroupId> chosen = drawn();
    arrows_to_ = IdTable<GroupId, std::vector<std::size_t>>(model_.groups.size());
    leads_ = IdSet<GroupId>(model_.groups.size());
    flawed_ = IdSet<GroupId>(model_.groups.size());
    for (const PictureFlaws::Line& line : options_.flaws.lines) flawed_.add(line.group);
    for (const PictureFlaws::Request& request : options_.flaws.requests) {
      if (request.from) flawed_.add(*request.from);
    }
    find_marks();
    for (std::size_t i = 0; i < arrows_.size(); ++i) {
      arrows_to_[arrows_[i].to].push_back(i);
      leads_.add(arrows_[i].from);
    }
    std::vector<std::vector<GroupId>> sets; // in order of their first group
    std::map<std::string, std::size_t> set_of;
    for (const GroupId id : model_.groups.ids()) {
      if (!chosen.contains(id)) continue;
      const std::string key = set_key(id);
      const auto [found, fresh] = set_of.try_emplace(key, sets.size());
      if (fresh) sets.emplace_back();
      sets[found->second].push_back(id);
    }
    drawn_ = chosen;
    for (const std::vector<GroupId>& set : sets) {
      for (const GroupId id : set) box_of_[id] = picture_.boxes.size();
      picture_.boxes.push_back(options_.fold != Fold::nothing ? maker_.folded(set)
                               : set.size() > 1               ? maker_.alike(set)
                                                              : maker_.group(set.front()));
      mark(picture_.boxes.back());
    }
  }

  /// Groups with the same key share a box.
  std::string set_key(GroupId id) const {
    const Group& group = model_.groups[id];
    if (options_.fold == Fold::modules) return fmt::format("module {}", group.module.value);
    if (options_.fold == Fold::layers) return group.layer ? fmt::format("layer {}", group.layer->id.value) : "layer";
    const std::string alone = fmt::format("group {}", id.value);
    if (group.providers.empty() || flawed_.contains(id)) return alone;
    const PictureRow row = words_.row(group.providers.front());
    const bool plain = group.providers.size() == 1 && row.name.empty() && row.lines.empty() && row.packs.empty() &&
                       words_.handler_lines(group).empty() && !maker_.is_root(id) && !maker_.is_focused(id);
    if (!plain) return alone;
    const auto is_queued = [&](const Moment* moment) { return standing(id, *moment).mark == Moment::Mark::queued; };
    if (std::any_of(moments_.begin(), moments_.end(), is_queued)) return alone;
    std::string key =
        fmt::format("layer {} data {}", group.layer ? std::to_string(group.layer->id.value) : "", group.data);
    for (const Moment* moment : moments_)
      key += fmt::format(" {} {}", static_cast<int>(standing(id, *moment).mark), standing(id, *moment).note);
    bool requested = false;
    if (leads_.contains(id)) return alone;
    for (const std::size_t i : arrows_to_[id]) {
      const GroupArrow& arrow = arrows_[i];
      requested = true;
      const auto place = [](const std::optional<std::size_t>& of) { return of ? std::to_string(*of) : ""; };
      key += fmt::format("; {} {} {} {} {} {} {}", arrow.from.value, place(arrow.row), place(arrow.pack),
                         static_cast<int>(arrow.kind), arrow.optional, arrow.apart, arrow.label);
      for (const std::vector<GroupArrow>& marked : marked_)
        key += fmt::format(" {}", marked[i].mark ? static_cast<int>(*marked[i].mark) : -1);
    }
    return requested ? key : alone;
  }

  static const Moment::Standing& standing(GroupId id, const Moment& moment) { return moment.groups[id.value]; }

  /// Computes the shown moments, and the marked arrows of each.
  void find_marks() {
    moments_.clear();
    marked_.clear();
    if (!options_.moment) return;
    for (const Moment& frame : options_.frames) moments_.push_back(&frame);
    if (moments_.empty()) moments_.push_back(&*options_.moment);
    for (const Moment* moment : moments_) mark_requests(model_, *moment, marked_.emplace_back(arrows_));
  }

  void mark(PictureBox& box) const {
    if (!options_.moment) return;
    const Moment::Standing now = standing_of(box, *options_.moment);
    box.mark = now.mark;
    box.note = now.note;
    const auto add_frame = [](Moment::Standing then, std::vector<Moment::Standing>& out) {
      then.active.reset();
      if (std::find(out.begin(), out.end(), then) == out.end()) out.push_back(std::move(then));
    };
    for (const Moment& frame : options_.frames) add_frame(standing_of(box, frame), box.frames);
    if (box.kind == PictureBox::Kind::folded) {
      for (std::size_t i = 0; i < box.groups.size(); ++i) {
        box.members[i].now = standing(box.groups[i], *options_.moment);
        for (const Moment& frame : options_.frames) add_frame(standing(box.groups[i], frame), box.members[i].frames);
      }
    }
    const Group& group = model_.groups[box.groups.front()];
    for (std::size_t row = 0; row < box.rows.size(); ++row)
      box.rows[row].is_active = standing(box.groups.front(), *options_.moment).active == group.providers[row];
  }

  /// Of several statuses, that with the highest rank is shown: what runs, in a box with something that waits.
  static int rank(Moment::Mark mark) {
    using Mark = Moment::Mark;
    return mark == Mark::pushed ? 4 : mark == Mark::running ? 3 : mark == Mark::queued ? 2 : mark == Mark::held ? 1 : 0;
  }

  /// Of the groups of a box.
  static Moment::Standing standing_of(const PictureBox& box, const Moment& moment) {
    Moment::Standing out;
    for (const GroupId id : box.groups) {
      if (rank(standing(id, moment).mark) > rank(out.mark)) out = standing(id, moment);
    }
    if (box.kind == PictureBox::Kind::folded) out.note.clear();
    return out;
  }

  void add_arrows() {
    std::map<std::tuple<PictureEnd, PictureEnd, int, std::string>, std::size_t> places;
    for (const GroupArrow& from_groups : arrows_) {
      PictureArrow arrow = placed(from_groups);
      const bool folded = options_.fold != Fold::nothing;
      const bool takes = from_groups.kind == ArrowKind::take;
      const bool pushes = from_groups.kind == ArrowKind::push || takes;
      const bool is_view = takes || (pushes && options_.view == View::pushes); // which shows nothing else
      if (folded && !is_view && arrow.from.box == arrow.to.box) continue;
      const int kind = !folded || pushes ? static_cast<int>(from_groups.kind) : -1;
      const auto [found, fresh] = places.try_emplace({arrow.from, arrow.to, kind, folded ? std::string{} : arrow.label},
                                                     picture_.arrows.size());
      if (fresh) {
        picture_.arrows.push_back(std::move(arrow));
        continue;
      }
      PictureArrow& known = picture_.arrows[found->second];
      if (known.kind != arrow.kind) known.kind = ArrowKind::both;
      if (known.mark && arrow.mark && rank(*arrow.mark) > rank(*known.mark)) known.mark = arrow.mark;
      known.optional = known.optional && arrow.optional;
      known.apart = known.apart && arrow.apart;
      known.hidden = known.hidden && arrow.hidden;
      if (folded && pushes) add_lines(known.label, arrow.label);
      known.about.words += "\n" + arrow.about.words;
    }
  }

  PictureArrow placed(const GroupArrow& from_groups) const {
    const bool whole = options_.fold != Fold::nothing;
    const bool row_of_target = from_groups.kind == ArrowKind::push;
    PictureArrow out;
    out.from.box = box_of_[from_groups.from];
    out.to.box = box_of_[from_groups.to];
    PictureEnd& end = row_of_target ? out.to : out.from;
    if (!whole && !picture_.boxes[end.box].rows.empty() && !picture_.boxes[end.box].is_direct())
      end.row = from_groups.row;
    if (!whole) end.pack = from_groups.pack;
    out.kind = from_groups.kind;
    out.optional = from_groups.optional;
    out.apart = from_groups.apart;
    out.mark = from_groups.mark;
    out.hidden = from_groups.hidden;
    out.label = whole && !row_of_target && from_groups.kind != ArrowKind::take ? std::string{} : from_groups.label;
    out.about = words_.at(from_groups.words, from_groups.span);
    return out;
  }

  /// A missing group gets a box of its own, below its requester.
  void add_flaws() {
    for (const PictureFlaws::Line& line : options_.flaws.lines) {
      if (!drawn_.contains(line.group)) continue;
      PictureBox& box = picture_.boxes[box_of_[line.group]];
      const PictureLine added{line.is_error ? PictureLine::Kind::wrong : PictureLine::Kind::doubtful, line.key,
                              line.text};
      const bool in_row = line.row && *line.row < box.rows.size();
      (in_row ? box.rows[*line.row].lines : box.lines).push_back(added);
    }
    std::map<std::string, std::size_t> known;
    for (const PictureFlaws::Request& request : options_.flaws.requests) {
      if (request.from && !drawn_.contains(*request.from)) continue;
      const auto [at, fresh] = known.try_emplace(request.name, picture_.boxes.size());
      if (fresh) {
        PictureBox box;
        box.kind = PictureBox::Kind::missing;
        box.name = request.name;
        if (request.from) box.groups = {*request.from};
        box.about = words_.at(fmt::format("{}: there is no such group", request.name), request.span);
        picture_.boxes.push_back(std::move(box));
      }
      if (!request.from) {
        picture_.boxes[at->second].requested = request.priorities;
        continue;
      }
      PictureArrow arrow;
      arrow.from.box = box_of_[*request.from];
      const PictureBox& from = picture_.boxes[arrow.from.box];
      if (!from.is_direct() && !from.rows.empty()) arrow.from.row = request.row;
      arrow.to.box = at->second;
      arrow.kind = request.need ? ArrowKind::need : ArrowKind::task;
      arrow.missing = true;
      arrow.label = "\u2716";
      arrow.about = words_.at(fmt::format("{} {} {}, which no group is called", model_.groups[*request.from].name.value,
                                          request.need ? "needs" : "requests", request.name),
                              request.span);
      picture_.arrows.push_back(std::move(arrow));
    }
    picture_.wrong = options_.flaws.elsewhere;
  }

  const Model& model_;
  const Graph& graph_;
  const PictureOptions& options_;
  const PictureWords words_;
  const BoxMaker maker_;
  IdTable<GroupId, std::size_t> box_of_;
  std::vector<GroupArrow> arrows_;
  std::vector<const Moment*> moments_;                   ///< of all frames, or the one that is shown
  std::vector<std::vector<GroupArrow>> marked_;          ///< the arrows in each of these
  IdTable<GroupId, std::vector<std::size_t>> arrows_to_; ///< places of arrows
  IdSet<GroupId> flawed_;                                ///< with a fault
  IdSet<GroupId> drawn_;                                 ///< has a box
  IdSet<GroupId> leads_;                                 ///< an arrow begins there
  Picture picture_;
};

} // namespace

Picture make_picture(const Model& model, const Graph& graph, const dsl::Sources& sources,
                     const PictureOptions& options) {
  return Painter(model, graph, sources, options).paint();
}

} // namespace director::compiler
