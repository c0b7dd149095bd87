#pragma once
// SPDX-License-Identifier: MIT
// What the JSON of a behaviour has about a group or a state in other places than its own: its requests, its needs, what
// sets it.

#include "compiler/base/json.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler::page {

/// A reference to it, and its source.
struct Mention {
  std::string by;    ///< `Striker.playing, pack attack`; empty: the program
  std::string group; ///< of which group; empty: the program
  std::string how;   ///< of a request `priority 20, optional`, of a state the condition
};

struct GroupRelations {
  std::vector<Mention> requests, needs; ///< of it
  std::vector<Mention> pushes;          ///< what may push it: for what, and to which of several providers, `how`
};

struct StateRelations {
  std::vector<Mention> sets, causes, waits;
  std::vector<Mention> stays; ///< providers that go on while it has such values
};

struct Relations {
  std::map<std::string, GroupRelations> groups;
  std::map<std::string, StateRelations> states;
  std::vector<std::string> unreached; ///< groups to which no request of the program leads; empty if it requests nothing
};

Relations find_relations(const Json& data);

/// Nor needed by any group.
bool requested_by_nobody(const Relations& relations, const std::string& group);

/// `priority 20`, `priority 10, optional`, `priority normal 10, urgent 80 optional`, and its `doc`:
/// `priority 20: At times.`
std::string manner_of(const Json& task);

/// Not the only provider of a group that has its keys directly: that is called like the group.
bool has_own_name(const Json& group, const Json& provider);

/// `Walk.halting`, `Kick`; `Kick.default` if `extend` adds others.
std::string provider_name(const Json& group, const Json& provider);

/// `2 s`
std::string time_text(const Json& microseconds);

} // namespace director::compiler::page
