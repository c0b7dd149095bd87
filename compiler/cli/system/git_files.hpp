#pragma once
// SPDX-License-Identifier: MIT
// Files as they were in a revision of git. Their paths are REVISION:PATH, from the top of the repository, like git's;
// what git does not keep is read from the disk, under its path there: files outside of the repository, those that git
// ignores, and absolute paths, as the files of a build have no revision. Of a submodule the recorded commit is read.

#include "compiler/cli/system/git_tree.hpp"
#include "compiler/facts/programs.hpp"
#include "dsl/source/file_access.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace director::compiler::cli {

/// The place of a repository, according to git.
struct Repository {
  std::string folder; ///< in the repository, that of the file that was named
  std::string prefix; ///< of that folder, from the top: `robot/`, or empty
};
/// The repository of a file, which need not exist any more; or the error.
dsl::Result<Repository, std::string> find_repository(Programs& programs, const std::string& file);

/// A file whose content of that time cannot be read. Empty: there is none.
struct LostFile {
  std::string path, why;
  bool empty() const { return path.empty(); }
};

/// What is compared with a revision.
enum class Newer { lying_there, staged };

class GitFiles final : public dsl::FileAccess {
public:
  GitFiles(Programs& programs, dsl::FileAccess& disk, std::string revision)
      : programs_(programs),
        disk_(disk),
        revision_(std::move(revision)) {}

  /// Finds the repository around `file`, which need not exist any more, and the revision. Returns an error, or nothing.
  /// `newer`: where git searches for an earlier name of the file.
  std::optional<std::string> open(const std::string& file, Newer newer);
  /// The path of the file that it was opened with, with its name in the revision.
  const std::string& path() const { return path_; }
  /// The first file that could not be read although it may have been there: git does not keep it, or has it elsewhere.
  const LostFile& lost() const { return lost_; }

  std::string identity(const std::string& path) override;
  std::string beside(const std::string& file, const std::string& relative) override;

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override;
  std::string name_before(const std::string& name, Newer newer);
  std::string top() const { return revision_ + ":"; }

  Programs& programs_;
  dsl::FileAccess& disk_;
  std::string revision_; ///< as it was given
  Repository repository_;
  bool is_absolute_ = false; ///< the path that it was opened with
  std::string commit_;
  std::string path_;
  std::optional<GitTree> tree_;     ///< since open()
  std::set<std::string> elsewhere_; ///< imports that git does not keep
  LostFile lost_;
};

/// Files as they are staged for the next commit. Their paths are those of the disk; what git does not keep is read from
/// there.
class StagedFiles final : public dsl::FileAccess {
public:
  StagedFiles(Programs& programs, dsl::FileAccess& disk) : programs_(programs), disk_(disk) {}

  /// Finds the repository around `file`. Returns an error, or nothing.
  std::optional<std::string> open(const std::string& file);
  /// As in GitFiles.
  const LostFile& lost() const { return lost_; }

  std::string identity(const std::string& path) override;
  std::string beside(const std::string& file, const std::string& relative) override;

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override;

  Programs& programs_;
  dsl::FileAccess& disk_;
  Repository repository_;
  std::optional<GitTree> tree_;     ///< since open()
  std::set<std::string> elsewhere_; ///< imports that git does not keep
  LostFile lost_;
};

/// Files beside one file, or otherwise beside another: git's difftool copies the old one alone into a folder of its
/// own, and its imports are beside the new one. Each has the path of the file that is read.
class FilesBeside final : public dsl::FileAccess {
public:
  FilesBeside(dsl::FileAccess& files, const std::string& first, const std::string& second);
  std::string identity(const std::string& path) override { return files_.identity(path); }
  std::string beside(const std::string& file, const std::string& relative) override;

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override {
    return files_.read(path, most, kinds);
  }
  bool is_there(const std::string& path);

  dsl::FileAccess& files_;
  std::string first_, second_;               ///< folders
  std::map<std::string, std::string> moved_; ///< files beside the other one: the path that each would have beside this
};

} // namespace director::compiler::cli
