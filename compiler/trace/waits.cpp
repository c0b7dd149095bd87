// Header: compiler/trace/waits.hpp. Test: tests/compiler/trace/waits_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/waits.hpp"

#include "compiler/lower/row_names.hpp"
#include "compiler/play/why/why.hpp"
#include "runtime/hosted/trace/run_ends.hpp"
#include "runtime/hosted/why_notes.hpp"

#include <map>
#include <utility>

namespace director::compiler {

namespace {

using Kind = Event::Kind;

class Asking final : public ReplayWatch {
public:
  Asking(const Model& model, const Lowered& lowered, const dsl::Sources& sources)
      : model_(model),
        lowered_(lowered),
        sources_(sources),
        rows_(model, lowered),
        groups_(model.groups.size()) {}

  void event(const Event& event, std::size_t line) override {
    last_line_ = line;
    const bool decides = is_decision(event.kind);
    if (decides && decision_line_ == 0) decision_line_ = line;
    anew_ = anew_ || decides || may_change_notes(event);
    if (event.kind == Kind::run) ran_ = event.group;
    if (event.group == nil) return;
    Standing& standing = groups_[event.group];
    const bool ends_its_request = ends_request(event) && event.edge == standing.holder;
    if (ends_hold(event) || ends_its_request) standing.is_reported = true;
    if (ends_its_request) standing.is_doubtful = true;
    if (event.kind == Kind::grant) standing.is_doubtful = false;
    if (event.kind == Kind::release) standing.is_without_effect = false;
  }

  void stepped(const View& view) override {
    for (Index group = 0; group < groups_.size(); ++group) {
      note_held(view, group);
      note_push(view, group);
    }
    for (Index group = 0; group < groups_.size(); ++group) look(view, group);
    anew_ = false;
    decision_line_ = 0;
    ran_ = nil;
  }

  Waits found(const Replayed& replayed) {
    out_.last_line = last_line_;
    out_.replayed = replayed;
    return std::move(out_);
  }
  director::Names names() const { return rows_.names(); }

private:
  struct Standing {
    Because because{};
    std::uint32_t text = 0; ///< as in Change
    Index holder = nil;
    bool is_live = false;           ///< before this micro-step
    bool is_reported = false;       ///< whether an event of this one reports its end
    bool is_doubtful = false;       ///< by the end of its request alone
    bool is_without_effect = false; ///< the push on it, when it ran last in the provider of that push
  };

  static bool is_decision(Kind kind) {
    return kind == Kind::grant || kind == Kind::lose || kind == Kind::queue || kind == Kind::push ||
           kind == Kind::release;
  }
  /// An answer contains values, requesters, priorities, and disabled providers.
  static bool may_change_notes(const Event& event) {
    switch (event.kind) {
    case Kind::set:
    case Kind::given:
    case Kind::ask:
    case Kind::withdraw: return true;
    case Kind::input:
      return event.input == Event::Input::request || event.input == Event::Input::cancel ||
             event.input == Event::Input::set || event.input == Event::Input::enable ||
             event.input == Event::Input::disable || event.input == Event::Input::expire;
    default: return false;
    }
  }

  void note_held(const View& view, Index group) {
    Standing& standing = groups_[group];
    const bool is_live = view.assignment[group].active != nil;
    anew_ =
        anew_ || is_live != standing.is_live; // an answer says of a group that could cause something whether it runs
    if (standing.is_live && !is_live && !standing.is_reported) out_.held.push_back({last_line_, group});
    const bool is_doubtful = standing.is_doubtful || is_requested_by(view, view.holder(group), ran_);
    if (standing.is_live && is_live && is_doubtful && !view.granted(group)) out_.stays.push_back({last_line_, group});
    standing.is_live = is_live;
    standing.holder = view.holder(group);
    standing.is_reported = standing.is_doubtful = false;
  }

  void note_push(const View& view, Index group) {
    const GroupAssignment& now = view.assignment[group];
    bool& is_without_effect = groups_[group].is_without_effect;
    if (now.push.edge == nil || now.push.provider != now.active || !now.granted()) return;
    if (is_without_effect == !now.in_force()) return;
    is_without_effect = !now.in_force();
    (is_without_effect ? out_.without_effect : out_.in_force).push_back({last_line_, group});
  }

  /// Whether that group may request this edge, and has just had the opportunity.
  static bool is_requested_by(const View& view, Index edge, Index group) {
    return group != nil && edge < view.tables->edges.size() && view.tables->edges[edge].requester == group;
  }

  static bool waits(const View& view, Index group) {
    if (view.granted(group)) return false;
    for (const Index edge : view.tables->list(view.tables->groups[group].requesters)) {
      if (view.requested(edge)) return true;
    }
    return false;
  }

  void look(const View& view, Index group) {
    Standing& standing = groups_[group];
    if (!waits(view, group)) return change(standing, group, 0);
    const Because because = why(view, group);
    if (standing.text != 0 && !anew_ && because == standing.because) return;
    standing.because = because;
    change(standing, group,
           text_of(to_text(reason_why(view, because, model_, lowered_, rows_.names()), sources_),
                   is_blocked(because) ? Waits::Blocker{because.group, because.holder} : Waits::Blocker{}));
  }

  std::uint32_t text_of(std::string text, const Waits::Blocker& blocker) {
    const auto [at, is_new] =
        texts_.try_emplace({std::move(text), blocker}, static_cast<std::uint32_t>(out_.texts.size() + 1));
    if (is_new) out_.texts.push_back(at->first.first), out_.blockers.push_back(blocker);
    return at->second;
  }

  /// From the decision on, so that a reader of the events sees it beside its cause.
  void change(Standing& standing, Index group, std::uint32_t text) {
    if (standing.text == text) return;
    standing.text = text;
    out_.changes.push_back({decision_line_ != 0 ? decision_line_ : last_line_, group, text});
  }

  const Model& model_;
  const Lowered& lowered_;
  const dsl::Sources& sources_;
  const RowNames rows_;
  std::vector<Standing> groups_;
  std::map<std::pair<std::string, Waits::Blocker>, std::uint32_t> texts_;
  std::size_t last_line_ = 0, decision_line_ = 0; ///< of the first decision of the micro-step; 0: none yet
  Index ran_ = nil;                               ///< in this micro-step
  bool anew_ = false;
  Waits out_;
};

} // namespace

Waits find_waits(TraceLines& lines, const Model& model, const Lowered& lowered, const dsl::Sources& sources) {
  Asking asking(model, lowered, sources);
  const Replayed replayed = replay(lines, model, asking.names(), &asking);
  return asking.found(replayed);
}

} // namespace director::compiler
