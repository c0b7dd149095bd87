#pragma once
// SPDX-License-Identifier: MIT
// Promises that are never kept although somebody waits for them and nothing else serves: who is to blame. A provider
// that never runs is blamed on what it lacks, and that on what keeps it away, down to where nothing else is to blame.

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/input.hpp"
#include "dsl/diagnostic.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

struct NeverKept {
  ProviderId causer{};
  ConditionUse promise{};
  bool pushable = true;  ///< false: it could run, but is neither chosen nor pushed
  bool at_first = false; ///< what waits for it holds at the start, and never again once it is lost

  struct Waiting {
    ProviderId provider{};
    ConditionUse condition{};
  };
  std::vector<Waiting> waiting; ///< those that wait for this promise, then those that wait for them, each once
};

struct Promises {
  std::vector<NeverKept> never_kept; ///< the lowest ones only, by causer
  IdSet<ProviderId> explained;       ///< providers that never run because of one of them, the lowest included
  std::vector<ProviderId> never_run; ///< the lowest of the others that never can, while another one of their group can
};

/// `chains`: over the providers that may be active.
Promises find_promises(const Model& model, const Graph& graph, const Facts& facts, const Chains& chains);

/// Two members of one unit.
struct Deadlock {
  const Task *waits = nullptr, *kept = nullptr; ///< one can never run, and the other one waits with it
};

/// `to_push`: what waits has to push the other one.
std::string apart_help(const Model& model, const Deadlock& deadlock, bool to_push = false);

/// Why something never runs.
struct Idleness {
  std::vector<dsl::Note> notes; ///< to the bottom: each reason at its own place
  std::optional<Deadlock>
      deadlock; ///< where all of that goes round: what is kept could bring about what the other lacks
};

Idleness explain_idle(const Input& input, ProviderId provider);
/// `reported`: an entry of which it is told already who requests it.
Idleness explain_idle(const Model& model, const Facts& facts, const std::vector<ProviderId>& providers,
                      const Task* reported = nullptr);

} // namespace director::analysis
