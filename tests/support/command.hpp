#pragma once
// SPDX-License-Identifier: MIT
// Commands as a reader of the pages types them.

#include <filesystem>
#include <string>

namespace director::tests {

struct Ran {
  int status = 0;
  std::string output; ///< what it printed, and its errors, as they come
};

/// Runs a shell command in a folder. The programs of this build are found first.
Ran run_command(const std::string& command, const std::filesystem::path& folder);

/// A new, empty folder that is removed at the end.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace director::tests
