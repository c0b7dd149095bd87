#pragma once
// SPDX-License-Identifier: MIT
// A behaviour from its text to its Model, for tests of later stages.

#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/source/render.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace director::tests {

struct Compiled {
  dsl::Sources sources;
  compiler::Model model;

  compiler::GroupId group(const std::string& name) const { return *model.find_group(name); }
  /// `Walk.halting`, `Kick`.
  compiler::ProviderId provider(const std::string& name) const {
    for (const compiler::ProviderId id : model.providers.ids()) {
      if (model.full_name(id) == name) return id;
    }
    FAIL("no provider " << name);
    return {};
  }
  /// `root>Kick`.
  compiler::EdgeId edge(const std::string& name) const {
    for (const compiler::EdgeId id : model.edges.ids()) {
      if (model.edge_name(id) == name) return id;
    }
    FAIL("no edge " << name);
    return {};
  }
};

/// `text` is the content of `test.yaml`; a finding of level error fails the test.
inline Compiled compile(const std::string& text) {
  dsl::MemoryFiles files;
  files.add("test.yaml", text);
  Compiled out;
  const dsl::ReadResult read = dsl::read_behaviour("test.yaml", files, out.sources);
  INFO(dsl::render(read.diagnostics, out.sources));
  REQUIRE(!dsl::has_errors(read.diagnostics));
  compiler::Resolved resolved = compiler::resolve(read.spec, out.sources);
  INFO(dsl::render(resolved.findings, out.sources));
  REQUIRE(!dsl::has_errors(resolved.findings));
  out.model = std::move(resolved.model);
  return out;
}

} // namespace director::tests
