#pragma once
// SPDX-License-Identifier: MIT
// How the language reaches files: an interface, the disk behind it for the command line, a map behind it for tests.

#include "dsl/source/result.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace director::dsl {

struct FileError {
  enum class Kind { not_found, not_readable, too_large, folder, pipe }; ///< `pipe`: where none was wanted
  Kind kind = Kind::not_found;
  std::string message; ///< what the system says: "no such file", "is a directory"
};

/// Which kinds of files may be opened.
enum class Kinds {
  any,     ///< also to a pipe, and who writes to it is waited for
  ordinary ///< to nothing that has to be waited for: a pipe is not even opened
};

class FileAccess {
public:
  /// Reads the whole content. If it has more than `most` bytes: too_large, and no more than that is read.
  Result<std::string, FileError> read(const std::string& path, std::size_t most, Kinds kinds = Kinds::any) {
    return fetch(path, most, kinds);
  }
  /// A path that is equal for all spellings of the path of one file, whether or not it exists.
  virtual std::string identity(const std::string& path) = 0;
  /// The path of a file that `file` names relative to itself.
  virtual std::string beside(const std::string& file, const std::string& relative);

protected:
  ~FileAccess() = default;

private:
  virtual Result<std::string, FileError> fetch(const std::string& path, std::size_t most, Kinds kinds) = 0;
};

class DiskFiles final : public FileAccess {
public:
  /// Called with the file that a read waits for, and the longest time that it will wait.
  using Waiting = std::function<void(const std::string& path, std::chrono::milliseconds longest)>;
  /// A read from a pipe waits up to `patience` for a writer. After a moment in which a program at its other end may
  /// start, `waiting` is called, once for each file.
  explicit DiskFiles(std::chrono::milliseconds patience = std::chrono::seconds(10), Waiting waiting = {})
      : patience_(patience),
        waiting_(std::move(waiting)) {}
  std::string identity(const std::string& path) override;
  /// Follows links before `..`, as the system does.
  std::string beside(const std::string& file, const std::string& relative) override;

private:
  Result<std::string, FileError> fetch(const std::string& path, std::size_t most, Kinds kinds) override;

  std::chrono::milliseconds patience_;
  Waiting waiting_;
};

/// Files in memory, by path.
class MemoryFiles final : public FileAccess {
public:
  void add(const std::string& path, std::string text);
  std::string identity(const std::string& path) override;

private:
  Result<std::string, FileError> fetch(const std::string& path, std::size_t most, Kinds kinds) override;

  std::map<std::string, std::string> files_;
};

} // namespace director::dsl
