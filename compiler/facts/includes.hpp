#pragma once
// SPDX-License-Identifier: MIT
// Decides whether a file may include another, by the text alone: much faster than Clang, which takes a second for a
// file unrelated to the behaviour. Conditional includes count, and a file that includes a macro may include anything.

#include "dsl/source/file_access.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace director::compiler {

class Includes {
public:
  explicit Includes(dsl::FileAccess& files) : files_(files) {}
  /// `header`: a path made of one of `folders` and a name.
  bool may_include(const std::string& file, const std::vector<std::string>& folders, const std::string& header);

  using Accept = std::function<bool(const std::string& path)>;
  /// The first accepted file of this name that it may include; empty: there is none. It may be beside the file that
  /// includes it, or have a longer name there: `"gen/walker.hpp"`.
  std::string find_named(const std::string& file, const std::vector<std::string>& folders, const std::string& name,
                         const Accept& accept);

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
  std::string find(const std::string& from, const std::vector<std::string>& folders, const Line& line);
  /// Visits what it may include, directly or not; an empty path: a macro. True: one was accepted.
  bool search(const std::string& path, const std::vector<std::string>& folders, const Accept& accept);

  dsl::FileAccess& files_;
  std::map<std::string, File> known_;
};

} // namespace director::compiler
