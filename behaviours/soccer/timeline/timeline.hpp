#pragma once
// SPDX-License-Identifier: MIT
// Shape: turns the engine's events into a timeline for people: a line where something changes, the runs in between as
// one number. It knows names and tables and nothing of soccer, so it tells of any behaviour. Unit: microseconds of the
// behaviour's time. Errors: none.

#include "behaviours/soccer/timeline/page.hpp"
#include "runtime/core/observer.hpp"

#include <string>
#include <vector>

/// What the rows are called that events name: the functions that every generated behaviour has in `names`.
struct Names {
  using Name = const char* (*)(director::Index row);
  Name group, provider, state, condition;
  const char* (*value)(director::Index state, std::int32_t number);
};

/// How often something happened.
struct Counts {
  int runs = 0;
  int pushes = 0;
  int take_overs = 0; ///< of what somebody held who would have gone on
  int hand_overs = 0; ///< of tasks from one requester to another, without a stop
  int faults = 0;
};

class Timeline {
public:
  Timeline(const Names& names, Page page) : names_(names), page_(page) {}

  director::Observer observer();                ///< for the constructor of a Behaviour
  void tell_of(const director::Tables& tables); ///< its tables, before its first step; they have to live as long
  void finish();                                ///< writes what is still held back
  const Counts& counts() const { return counts_; }

private:
  using Event = director::Event;
  using Index = director::Index;

  /// What is known of a group, from its events alone.
  struct Row {
    bool resource = false;          ///< somebody needs it, or it serves only such groups
    Index edge = director::nil;     ///< by which it is held
    Index before = director::nil;   ///< who held it before, if that is news
    Index provider = director::nil; ///< told last
    bool new_holder = false;        ///< not told yet
    bool done = false;              ///< told for this task
    std::uint64_t displaced = 0;    ///< the micro-step in which its request had to give way
    int runs = 0;                   ///< since the last aside
  };

  /// Things of one kind that happen together and make one line.
  struct Joined {
    std::string_view what;
    std::string who, list, rest;
    std::uint64_t micro_step = 0;
    director::Time time = 0;
  };

  void tell(const Event& event);
  void input(const Event& event);
  void run(const Event& event);
  void done(const Event& event);
  void grant(const Event& event);
  void lose(const Event& event);
  void queue(const Event& event);
  void push(const Event& event);
  void set(const Event& event);
  void change(const Event& event, std::string_view what, const std::string& by);
  void refused(const Event& event);

  std::string group(Index index) const { return names_.group(index); }
  std::string condition(Index index) const { return names_.condition(index); }
  std::string state(Index index) const { return names_.state(index); }
  std::string value(const Event& event) const { return names_.value(event.state, event.value); }
  Index requester(Index edge) const; ///< nil also for the program and for limbo
  std::string with_provider(Index provider) const;
  void join(const Event& event, std::string_view what, const std::string& who, const std::string& item,
            const std::string& rest);
  void flush();
  void line(director::Time time, std::string_view what, std::string_view who, std::string_view words = "");
  void runs_so_far();

  Names names_;
  Page page_;
  director::Tables tables_;
  Counts counts_;
  std::vector<Row> rows_;
  std::vector<std::int32_t> values_;       ///< state: told last
  std::vector<std::uint8_t> told_waiting_; ///< edge
  Joined joined_;
  Event last_run_;                 ///< who sets a state is who ran last
  Index expiring_ = director::nil; ///< state
  director::Time last_line_ = 0;
  std::string last_text_;
  int runs_ = 0; ///< since the last aside
};
