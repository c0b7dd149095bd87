#pragma once
// SPDX-License-Identifier: MIT
// The names in a commit, or in what is staged, with their links followed: as a file system would, but without a disk.

#include "compiler/facts/programs.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace director::compiler::cli {

class GitTree {
public:
  /// `folder`: in the repository. `commit`: of which; empty: what is staged. Nothing is read before it is needed.
  GitTree(Programs& programs, std::string folder, std::string commit)
      : programs_(programs),
        folder_(std::move(folder)),
        commit_(std::move(commit)) {}

  /// Where a path leads. All paths are from the top of the repository.
  struct Place {
    std::string path;           ///< without links
    bool leaves = false;        ///< a link leads out of the repository
    bool is_there = false;      ///< a file, or something in a submodule
    std::string submodule = {}; ///< the one that it is in; or empty
    std::string commit = {};    ///< of the submodule
  };
  Place find(const std::string& path);

private:
  struct Entry {
    enum class Kind { file, link, submodule };
    Kind kind = Kind::file;
    std::string object;
  };
  void read();
  void add(std::string_view line);
  std::string target_of(const Entry& link);

  Programs& programs_;
  std::string folder_, commit_;
  std::optional<std::map<std::string, Entry>> entries_;
  std::map<std::string, std::string> targets_; ///< by object
};

} // namespace director::compiler::cli
