#pragma once
// Needs that are still to be met while plans are gone through: a list for each provider that was picked, the latest
// first. They lie on the stack of who meets them, so that a branch that fails leaves nothing to clean up.

#include "compiler/model/model.hpp"

#include <vector>

namespace director::checks {

using namespace director::compiler;

struct Agenda {
  const std::vector<Use<GroupId>>* needs = nullptr;
  std::size_t next = 0;
  const Agenda* then = nullptr;

  GroupId group() const { return (*needs)[next].id; }
  Agenda rest() const { return {needs, next + 1, then}; }
};

/// Where the next need stands; null: all are met.
inline const Agenda* next_need(const Agenda* agenda) {
  while (agenda != nullptr && agenda->next == agenda->needs->size()) agenda = agenda->then;
  return agenda;
}

} // namespace director::checks
