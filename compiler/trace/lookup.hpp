#pragma once
// SPDX-License-Identifier: MIT
// Maps the names in a line of a trace to the rows of a behaviour, which may be another version than the recorded one.

#include "compiler/base/json.hpp"
#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler {

class Lookup {
public:
  /// `names` must have tables, and outlive this.
  explicit Lookup(const director::Names& names);

  struct Found {
    Event event;
    std::string problem; ///< why the line is no event of this behaviour; empty: it is one
  };
  Found event(const Json& line) const;
  /// The same, but the event has no level: another version's names and places of levels say nothing about this one.
  Found event_without_level(const Json& line) const;

private:
  using Rows = std::map<std::string, Index, std::less<>>;
  Rows rows(const char* (*name)(const void*, Index), std::size_t count) const;

  director::Names names_;
  const Tables& tables_;
  Rows groups_, edges_, states_, triggers_, conditions_;
  std::vector<Rows> providers_; ///< by group
  friend class EventReading;
};

} // namespace director::compiler
