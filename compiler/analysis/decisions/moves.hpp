#pragma once
// SPDX-License-Identifier: MIT
// Computes what may happen next (semantics.md, sections 3, 5 and 6): all moments that may follow one.

#include "compiler/analysis/decisions/pass.hpp"
#include "compiler/analysis/decisions/seen.hpp"

#include <functional>

namespace director::analysis {

class Moves {
public:
  Moves(const Component& part, Gathered& gathered, std::int64_t& steps_left)
      : part_(part),
        gathered_(gathered),
        left_(steps_left),
        pass_(part, picks_, gathered) {}

  Moment first() const;
  /// Visits all moments that may follow, without those that another one has led to in the same way. `run`: providers
  /// that may run then. False: it took more steps than were left.
  bool from(const Moment& moment, const std::function<void(const Moment& next)>& visit);

private:
  /// The input of a decision, after an input or a run.
  struct Change {
    Moment moment; ///< for which nothing is decided yet
    Rows anew = 0; ///< edges that were requested anew
  };

  void decide(Change change);
  void decide(const Moment& from, Rows anew, const std::function<void(const Moment& next)>& visit);
  Rows that_matter(const Change& change) const;
  void act(const Moment& before, Moment& now);
  void set_some(const std::vector<Component::Setting>& settings, Moment& next);
  void change_in_all_ways(const std::function<bool(Change&)>& change);
  bool is_at_rest(const Moment& moment);
  void run(Change& change, Row group);
  bool request(Change& change);
  bool set(Change& change);

  const Component& part_;
  Gathered& gathered_;
  std::int64_t& left_;
  ChoiceSequence picks_, ways_;
  Pass pass_;
  Seen<Change> decided_;
  Seen<Moment> outcomes_; ///< of the current decision
  const std::function<void(const Moment&)>* visit_ = nullptr;
};

} // namespace director::analysis
