#pragma once
// SPDX-License-Identifier: MIT
// The lines of a trace as events of the behaviour on which they are replayed, which may be another version than the one
// recorded.

#include "compiler/trace/lookup.hpp"
#include "compiler/trace/permits.hpp"
#include "compiler/trace/trace_lines.hpp"

#include <deque>
#include <string>

namespace director::compiler {

struct RecordedEvent {
  std::size_t line = 0; ///< counts from 1
  std::string text;     ///< as TraceLine::text
  Event event;          ///< with the rows of the behaviour that is played
  Lookup::Found was;    ///< with the rows of the recorded one; its problem: no recorder has written this line
  std::uint64_t dropped = 0;
  std::string problem; ///< why the behaviour that is played has no such event
  /// It is no decision: an input, or what a body or handler requested or set, which cannot be replayed.
  bool is_impossible = false;
  std::string help; ///< what to do about the problem; may be empty
};

class RecordedEvents {
public:
  /// `model`, `names`: of the behaviour to play. `recorded`: of the recorded one if that is another version; null: the
  /// same.
  RecordedEvents(TraceLines& lines, const Model& model, const director::Names& names, const director::Names* recorded);

  /// The event after so many others; null: there is none. Events about the recorder, a full inbox or an exhausted
  /// budget are skipped: they decide nothing.
  const RecordedEvent* ahead(std::size_t places);
  /// Whether the next event is an answer that is impossible for what its requests, behind it, leave out.
  bool leaves_out_too_much();
  void pop() { waiting_.pop_front(); }
  /// Whether a later one of the requests of the same run has this line: their order is that of their declaration, and
  /// no decision. This one, or one that is impossible, becomes the next.
  bool bring_forward(const std::string& line);

  /// The line, as it is written with the levels of the behaviour that is played.
  std::string expected(const RecordedEvent& recorded) const;
  /// Why no recorder of the recorded behaviour has written this line; empty: one may have.
  std::string damage_of(const RecordedEvent& recorded) const;

  bool is_other() const { return is_other_; } ///< another version was recorded
  const director::Names& recorded_names() const { return recorded_names_; }
  /// The last events of steps that ended before they were at rest, from the next event on.
  std::deque<Event>& early_ends() { return early_ends_; }

private:
  void judge(RecordedEvent& recorded);
  void find_level(RecordedEvent& recorded);

  TraceLines& lines_;
  const director::Names names_;
  const director::Names recorded_names_;
  const bool is_other_;
  const bool maps_levels_; ///< another version, and the trace says what its levels mean
  const Lookup lookup_, recorded_lookup_;
  Permits permits_;
  Event answer_; ///< the last recorded one, with the rows of the recorded version
  std::deque<RecordedEvent> waiting_;
  std::deque<Event> early_ends_;
};

} // namespace director::compiler
