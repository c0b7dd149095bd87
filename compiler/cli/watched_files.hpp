#pragma once
// SPDX-License-Identifier: MIT
// What a run has read, as it was then, and what of it is otherwise now.

#include "compiler/cli/console.hpp"

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// A file as the file system describes it. Equal ones mean that nobody has written it.
struct FileStamp {
  bool exists = false;
  dev_t device = 0;
  ino_t node = 0;
  off_t size = 0;
  std::int64_t modified = 0, changed = 0; ///< nanoseconds
  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::string& path);

struct FileChange {
  enum class Kind { created, written, removed };
  std::string path;
  Kind kind = Kind::written;
  FileStamp now;
  bool operator==(const FileChange&) const = default;
  /// As it may be between two steps of an editor that saves: gone, or empty.
  bool may_be_half_done() const { return !now.exists || now.size == 0; }
};

/// Reads, and remembers what was read or looked for in vain.
class WatchedFiles final : public dsl::FileAccess {
public:
  explicit WatchedFiles(dsl::FileAccess& files) : files_(files) {}
  std::string identity(const std::string& path) override { return files_.identity(path); }

  /// By path.
  std::vector<FileChange> changes() const;
  std::vector<std::string> paths() const;

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override;

  struct Seen {
    FileStamp stamp;
    /// A clock of files is coarse: what is written twice at one time looks the same, so what was new is compared by a
    /// sum of its text.
    std::optional<std::size_t> sum;
  };
  dsl::FileAccess& files_;
  std::map<std::string, Seen> seen_;
};

/// Lists scenarios, and remembers which there were. What is written goes through.
class WatchedFolders final : public Outputs {
public:
  explicit WatchedFolders(Outputs& outputs) : outputs_(outputs) {}
  std::optional<std::string> write(const std::vector<Output>& outputs) override { return outputs_.write(outputs); }
  std::optional<std::string> change(const std::vector<Change>& changes) override { return outputs_.change(changes); }
  std::vector<std::string> list(const std::string& folder) override;

  /// Scenarios that are new: one that was there has been read, and is told of there.
  std::vector<FileChange> changes() const;
  std::vector<std::string> paths() const;

private:
  Outputs& outputs_;
  std::map<std::string, std::vector<std::string>> seen_;
};

} // namespace director::compiler::cli
