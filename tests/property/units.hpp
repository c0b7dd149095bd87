#pragma once
// SPDX-License-Identifier: MIT
// Units (semantics.md 4.4) at rest: what was requested together and is granted together. The oracle's pass derives them
// from its candidates; this is for tests that examine an engine.

#include "runtime/core/inspect/why.hpp"
#include "tests/property/snapshot.hpp"

namespace director::property {

class Units {
public:
  Units(const compiler::Model& model, const View& view, const Snapshot& now) : model_(model), view_(view), now_(now) {}

  /// Whether the edge is requested by a group, neither optional nor apart: it is granted together with all such edges,
  /// or not at all.
  bool is_member(oracle::EdgeId edge) const;
  /// The unit, by declaration; the edge alone if it is not a member.
  std::vector<oracle::EdgeId> of(oracle::EdgeId edge) const;
  std::vector<oracle::EdgeId> mates(oracle::EdgeId member) const; ///< the others of its unit
  /// Compares two edges of one requester, neither of them optional: rules 4 and 5 of semantics.md 4.1.
  bool stands_before(oracle::EdgeId a, oracle::EdgeId b) const;
  /// The member whose rank the unit has.
  oracle::EdgeId first_of(oracle::EdgeId edge) const;

  /// The level at which it is requested. An edge that holds without a request is mandatory, with the priority of its
  /// first level.
  compiler::Level level(oracle::EdgeId edge) const;

private:
  const compiler::Model& model_;
  const View& view_;
  const Snapshot& now_;
};

} // namespace director::property
