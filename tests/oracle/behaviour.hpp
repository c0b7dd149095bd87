#pragma once
// SPDX-License-Identifier: MIT
// semantics.md, sections 3, 5, 6 and 7: a running behaviour. It takes micro-steps, arbitrates after each, and acts on
// the difference. Bodies stands for the program; the result is a list of lines as in the `expect` of a scenario.

#include "tests/oracle/pass.hpp"

#include <deque>
#include <string>

namespace director::oracle {

using Time = Microseconds;
using Settings = std::vector<std::pair<StateId, std::int64_t>>;

/// Section 6: what a provider can read.
struct Sight {
  enum class Run { none, queued, running };
  enum class Result { no, done, failed };
  struct Use {
    Run run = Run::none;
    Result result = Result::no; ///< counts only while running
  };
  GroupId group{};
  ProviderId provider{};
  std::set<Reason> reasons;
  std::set<TriggerId> fired;
  std::optional<dsl::Data> data;
  std::map<GroupId, Use> uses;
};

/// Section 3: the results of a run.
struct Asked {
  EdgeId edge{};
  std::uint32_t level = 0;
  std::optional<dsl::Data> data;
  bool keep = false;
};
struct Commit {
  enum class Kind { pack, done, failed, keep, fault };
  Kind kind = Kind::keep;
  std::vector<Asked> pack;
  Settings set;
  std::optional<Microseconds> wait;
};

class Bodies {
public:
  virtual Commit run(const Sight& sight) = 0;
  virtual Settings start(GroupId group, const std::optional<dsl::Data>& data) = 0;
  virtual Settings stop(GroupId group, const std::optional<dsl::Data>& data) = 0;

protected:
  ~Bodies() = default;
};

/// Section 3, Inputs.
struct Input {
  enum class Kind { request, cancel, set, trigger, enable, disable, expire, wait, promise, every };
  Kind kind = Kind::set;
  std::vector<Asked> request; ///< root edges
  EdgeId edge{};              ///< cancel
  Settings set;               ///< set
  TriggerId trigger{};        ///< trigger
  ProviderId provider{};      ///< enable, disable, promise
  StateId state{};            ///< expire
  GroupId group{};            ///< wait, every
  std::size_t causing = 0;    ///< promise: place in the provider's `causing`
};

class Behaviour {
public:
  Behaviour(const Model& model, Bodies& bodies);

  void preset(StateId state, std::int64_t value) { facts_.value[state] = value; } ///< before the first step
  void post(Input input) { inbox_.push_back(std::move(input)); }

  /// Takes the inputs that were posted, then due timers, each time to rest. An earlier `now` counts as the last one.
  void begin_step(Time now);
  /// Takes one micro-step. False: at rest.
  bool micro_step();
  std::optional<Time> next_due() const;

  const Parts& parts() const { return parts_; }
  const Facts& facts() const { return facts_; }
  const Assignment& assignment() const { return now_; }
  const std::deque<GroupId>& run_queue() const { return queue_; }
  const std::vector<std::string>& trace() const { return trace_; }
  const Notes& notes() const { return notes_; }
  Time now() const { return time_; }

private:
  // micro_steps.cpp: section 3
  bool take(const Input& input);
  bool request(const std::vector<Asked>& asked);
  void request(const Asked& asked);
  bool set(const Settings& settings);
  bool fire(TriggerId trigger);
  bool trigger_is_heard(GroupId group, TriggerId trigger) const;
  void run(GroupId group);
  void commit(GroupId group, ProviderId provider, const Commit& commit);
  void answer(GroupId group, bool failed);
  void end_micro_step();

  // timers.cpp: section 3, Time, and section 7
  void queue_what_is_due(Time due);
  bool take_timer(const Input& input);
  void begin_promises(GroupId group, ProviderId provider);
  void end_promises();

  // acting.cpp: section 5
  void act(const Assignment& before);
  void stop(GroupId group, std::map<StateId, std::int64_t>& handlers_set);
  std::set<Reason> news(const Assignment& before, GroupId group) const;

  Sight sight(GroupId group, ProviderId provider, const std::set<Reason>& reasons) const; // sight.cpp: section 6

  Parts parts_;
  Bodies& bodies_;
  Facts facts_;
  Assignment now_;
  Notes notes_;
  std::vector<std::string> trace_;

  enum class Done { no, done, failed };
  IdTable<GroupId, Done> done_;
  IdTable<GroupId, std::set<TriggerId>> fired_;
  IdTable<GroupId, std::optional<dsl::Data>> data_; ///< of the request for which the group was last granted
  std::deque<Input> inbox_, inputs_;
  std::optional<Settings> handlers_set_; ///< the one input that is taken before every other
  std::deque<GroupId> queue_;
  std::uint64_t count_ = 0; ///< micro-steps
  bool unsettled_ = false;  ///< the last arbitration changed something
  int settling_ = 0;        ///< micro-steps in a row that only arbitrated once more
  bool begun_ = false;

  Time time_ = 0, until_ = 0;
  IdTable<StateId, std::optional<Time>> expiry_;
  IdTable<GroupId, std::optional<Time>> wait_, every_;
  struct Promised {
    Push push;
    std::map<std::size_t, Time> due; ///< by the place in `causing`
  };
  std::map<GroupId, Promised> promised_;
};

} // namespace director::oracle
