#pragma once
// SPDX-License-Identifier: MIT
// Finds promises that are never kept although a condition waits for them and nothing else serves it, and what is to
// blame. An edge of the blame graph leads from a provider that never runs to each provider that could remove the
// reason; the end of such a chain is a cause that blames nothing else.

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

struct NeverKept {
  ProviderId causer{};
  ConditionUse promise{};
  bool pushable = true;  ///< false: it could run, but is neither chosen nor pushed
  bool at_first = false; ///< the condition that waits for it holds at the start, and never again once it is lost

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

/// Members of one unit that wait for each other.
struct Deadlock {
  const Task *waits = nullptr, *kept = nullptr; ///< one can never run, and the other one waits with it
  std::vector<const Task*> also = {};           ///< other members of the unit that can never run
};

/// `to_push`: the group that the waiting task has to push.
std::string apart_help(const Model& model, const Deadlock& deadlock, bool to_push = false);

/// Why something never runs.
struct Idleness {
  std::vector<dsl::Note> notes;     ///< down to the cause, each reason at its own place
  std::optional<Deadlock> deadlock; ///< if the reasons form a cycle: the kept task could cause what the other one lacks
};

Idleness explain_idle(const Input& input, ProviderId provider);
/// `reported`: an entry whose requester the finding names already.
Idleness explain_idle(const Model& model, const Facts& facts, const std::vector<ProviderId>& providers,
                      const Task* reported = nullptr);

} // namespace director::analysis
