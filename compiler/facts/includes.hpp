#pragma once
// SPDX-License-Identifier: MIT
// Whether a file may include another, by the text alone: much faster than to ask Clang, who takes a second for a file
// that has nothing to do with the behaviour. What stands under conditions counts, and a file that includes a macro may
// include anything.

#include "dsl/file_access.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace director::compiler {

class Includes {
public:
  explicit Includes(dsl::FileAccess& files) : files_(files) {}
  /// `header`: a path as a folder of `folders` and a name make it.
  bool may_include(const std::string& file, const std::vector<std::string>& folders, const std::string& header);

private:
  struct Line {
    std::string name; ///< empty: a macro
    bool quoted = false;
  };
  struct File {
    bool exists = false;
    std::vector<Line> lines;
  };
  const File& file(const std::string& path);
  bool look(const std::string& path, const std::vector<std::string>& folders, const std::string& header,
            std::set<std::string>& seen);

  dsl::FileAccess& files_;
  std::map<std::string, File> known_;
};

} // namespace director::compiler
