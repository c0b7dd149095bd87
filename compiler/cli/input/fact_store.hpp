#pragma once
// SPDX-License-Identifier: MIT
// The cache of facts on the disk.

#include "compiler/facts/cache.hpp"

#include <string>

namespace director::compiler::cli {

class DiskFacts final : public FactStore {
public:
  /// `folder`: made when something is saved in it.
  explicit DiskFacts(std::string folder) : folder_(std::move(folder)) {}
  std::optional<std::string> load(const std::string& name) override;
  void save(const std::string& name, const std::string& text) override;
  std::string stamp(const std::string& path) override;

private:
  std::string folder_;
};

/// Below the build's folder; without one $XDG_CACHE_HOME/director or ~/.cache/director.
std::string facts_folder(const std::string& build);

} // namespace director::compiler::cli
