#pragma once
// SPDX-License-Identifier: MIT
// What the JSON of a behaviour says of a group or a state at other places than its own: who asks for it, who needs it,
// who sets it.

#include "compiler/base/json.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler::page {

/// Something that somebody says of it, and who.
struct Mention {
  std::string by;    ///< `Striker.playing, pack attack`; empty: the program
  std::string group; ///< whose that is; empty: the program
  std::string how;   ///< of a request `priority 20, optional`, of a state the condition
};

struct GroupRelations {
  std::vector<Mention> requests, needs; ///< of it
  std::vector<Mention> pushes;          ///< who may push it: for what, `how`
};

struct StateRelations {
  std::vector<Mention> sets, causes, waits;
};

struct Relations {
  std::map<std::string, GroupRelations> groups;
  std::map<std::string, StateRelations> states;
};

Relations find_relations(const Json& data);

/// `priority 20`, `priority normal 10, urgent 80`, `priority 10, optional`
std::string manner_of(const Json& task);

/// `Walk.halting`, `Kick`
std::string provider_name(const Json& group, const Json& provider);

/// `2 s`
std::string time_text(const Json& microseconds);

} // namespace director::compiler::page
