#pragma once
// SPDX-License-Identifier: MIT
// A folder on the disk with a behaviour and its C++, and directorc working in it.

#include <map>
#include <string>
#include <vector>

namespace director::tests {

struct Worked {
  int status = 0;
  std::string out, err;
};

class Workshop {
public:
  /// Made empty. `name`: of the folder, below the build tree.
  explicit Workshop(const std::string& name);
  void write(const std::string& path, const std::string& text) const;
  std::string path(const std::string& file = {}) const;
  /// Compile commands for all files: a g++ with these flags.
  void write_commands(const std::vector<std::string>& files, const std::vector<std::string>& flags) const;
  Worked directorc(const std::vector<std::string>& words) const;

private:
  std::string folder_;
};

/// The root of the project.
std::string source_folder();

} // namespace director::tests
