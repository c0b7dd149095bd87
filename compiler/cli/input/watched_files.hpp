#pragma once
// SPDX-License-Identifier: MIT
// Records the files that a run has read, and finds those that have changed.

#include "compiler/cli/system/console.hpp"

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// The metadata of a file. Equal stamps mean that it was not written.
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
  /// Whether it may be between two steps of an editor that saves: gone, or empty.
  bool may_be_half_done() const { return !now.exists || now.size == 0; }
};

/// Reads files, and records those that were read or not found.
class WatchedFiles final : public dsl::FileAccess {
public:
  explicit WatchedFiles(dsl::FileAccess& files) : files_(files) {}
  std::string identity(const std::string& path) override { return files_.identity(path); }
  std::string beside(const std::string& file, const std::string& relative) override {
    return files_.beside(file, relative);
  }

  /// By path.
  std::vector<FileChange> changes() const;
  std::vector<std::string> paths() const;

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override;

  struct Seen {
    FileStamp stamp;
    /// Timestamps are coarse: two writes at one time look the same, so recent files are also compared by a hash of
    /// their text.
    std::optional<std::size_t> sum;
  };
  dsl::FileAccess& files_;
  std::map<std::string, Seen> seen_;
};

/// Lists scenarios, and records which there were. Writes are passed on.
class WatchedFolders final : public Outputs {
public:
  explicit WatchedFolders(Outputs& outputs) : outputs_(outputs) {}
  std::optional<std::string> write(const std::vector<Output>& outputs) override { return outputs_.write(outputs); }
  std::optional<std::string> change(const std::vector<Change>& changes) override { return outputs_.change(changes); }
  std::vector<std::string> list(const std::string& folder) override;

  /// New scenarios: changes of others are in WatchedFiles.
  std::vector<FileChange> changes() const;
  std::vector<std::string> paths() const;

private:
  Outputs& outputs_;
  std::map<std::string, std::vector<std::string>> seen_;
};

} // namespace director::compiler::cli
