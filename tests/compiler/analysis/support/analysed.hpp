#pragma once
// SPDX-License-Identifier: MIT
// A small behaviour with the input of every analysis, for tests.

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/graph/graph.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <string>

namespace director::tests {

/// `text` follows the two lines that every file has.
struct Analysed {
  Compiled compiled;
  const compiler::Model& model = compiled.model;
  compiler::Graph graph;
  analysis::Facts facts;
  analysis::Chains chains; ///< over the providers that may be active

  explicit Analysed(const std::string& text)
      : compiled(compile("behaviour: test\nlanguage: 1\n" + text)),
        graph(compiler::make_graph(model)),
        facts(analysis::find_facts(model, graph)),
        chains(model, [this](compiler::ProviderId id) { return facts.active.contains(id); }) {}
  Analysed(const Analysed&) = delete;
  Analysed& operator=(const Analysed&) = delete;

  compiler::GroupId group(const std::string& name) const { return compiled.group(name); }
  compiler::ProviderId provider(const std::string& name) const { return compiled.provider(name); }
  compiler::StateId state(const std::string& name) const { return *model.find_state(name); }

  /// `Walk.halting Kick `, in order of declaration.
  std::string names(const compiler::IdSet<compiler::ProviderId>& set) const {
    std::string out;
    for (const compiler::ProviderId id : model.providers.ids()) {
      if (set.contains(id)) out += model.full_name(id) + " ";
    }
    return out;
  }
};

} // namespace director::tests
