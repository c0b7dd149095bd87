// Header: compiler/trace/level_map.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/level_map.hpp"

#include <string_view>

namespace director::compiler {

namespace {

bool is_same_pack(const director::Names& from, const LevelUse& was, const director::Names& to, const LevelUse& is) {
  if (was.provider == nil || is.provider == nil) return was.provider == is.provider;
  return std::string_view(from.provider(from.self, was.provider)) == to.provider(to.self, is.provider) &&
         std::string_view(was.pack_name) == is.pack_name;
}

Index find_level(const director::Names& from, const LevelUse& was, const director::Names& to, Index edge) {
  const director::Level& old = from.tables->levels[was.level];
  const auto means_the_same = [&](Index level) {
    const director::Level& row = to.tables->levels[level];
    return row.priority == old.priority && row.optional == old.optional && row.apart == old.apart;
  };
  Index first = nil, same = nil; // of the same pack
  for (const LevelUse& is : to.level_uses) {
    if (is.edge != edge || !is_same_pack(from, was, to, is)) continue;
    if (std::string_view(is.name) == was.name) return is.level;
    if (first == nil) first = is.level;
    if (means_the_same(is.level)) same = is.level;
  }
  if (first != nil) return *was.name == '\0' ? first : same;
  for (const Index level : to.tables->edges[edge].levels.rows()) {
    if (means_the_same(level)) return level;
  }
  return nil;
}

} // namespace

Index same_level(const director::Names& from, const Event& request, const Event& answer, const director::Names& to,
                 Index edge) {
  Index out = nil;
  for (const LevelUse& was : from.level_uses) {
    if (was.level != request.level) continue;
    if (was.provider != nil && (was.provider != answer.provider || was.pack != answer.pack)) continue;
    const Index found = find_level(from, was, to, edge);
    if (found == nil || (out != nil && out != found)) return nil;
    out = found;
  }
  return out;
}

} // namespace director::compiler
