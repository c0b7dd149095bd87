#pragma once
// SPDX-License-Identifier: MIT
// A store of facts in memory, for tests. System files have the stamp `of yesterday` by default.

#include "compiler/facts/cache.hpp"

#include <map>
#include <optional>
#include <string>

namespace director::tests {

class MemoryFacts final : public compiler::FactStore {
public:
  std::optional<std::string> load(const std::string& name) override {
    const auto at = entries.find(name);
    if (at == entries.end()) return {};
    return at->second;
  }
  void save(const std::string& name, const std::string& text) override { entries[name] = text; }
  std::string stamp(const std::string& path) override { return path == absent ? std::string{} : path + " " + system; }
  std::map<std::string, std::string> entries;
  std::string system = "of yesterday";
  std::string absent = "/u/first/types.hpp";
};

} // namespace director::tests
