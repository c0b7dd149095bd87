#pragma once
// SPDX-License-Identifier: MIT
// Units (semantics.md 4.4) as things are at rest: what was requested together and is granted together. The oracle's
// pass knows them by its own candidates; this is for tests that ask of an engine what follows from them.

#include "runtime/core/inspect/why.hpp"
#include "tests/property/snapshot.hpp"

namespace director::property {

class Units {
public:
  Units(const compiler::Model& model, const View& view, const Snapshot& now) : model_(model), view_(view), now_(now) {}

  /// Requested by a group, neither optional nor apart: it is granted with the others of which this is so, or not at
  /// all.
  bool is_member(oracle::EdgeId edge) const;
  /// By declaration. The edge alone where it is not a member.
  std::vector<oracle::EdgeId> of(oracle::EdgeId edge) const;
  std::vector<oracle::EdgeId> mates(oracle::EdgeId member) const; ///< the others of its unit
  /// Of two edges of one requester, neither of them optional: rules 4 and 5 of semantics.md 4.1.
  bool stands_before(oracle::EdgeId a, oracle::EdgeId b) const;
  /// With whose rank the unit stands.
  oracle::EdgeId first_of(oracle::EdgeId edge) const;

  /// At which it is requested. What is held without a request is mandatory, with the priority of its first level.
  compiler::Level level(oracle::EdgeId edge) const;

private:
  const compiler::Model& model_;
  const View& view_;
  const Snapshot& now_;
};

} // namespace director::property
