#pragma once
// SPDX-License-Identifier: MIT
// The environment of a subcommand: two streams, files to read, files to write. In main the terminal and the disk, in
// tests strings and maps.

#include "compiler/cli/system/change.hpp"
#include "compiler/facts/programs.hpp"
#include "dsl/source/file_access.hpp"

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

class Outputs {
public:
  /// Writes generated files: all of them, or none and returns the reason. Makes missing folders; a file that has its
  /// text already is not touched.
  virtual std::optional<std::string> write(const std::vector<Output>& outputs) = 0;
  /// Changes files of the user: all of them, or none and returns the reason.
  virtual std::optional<std::string> change(const std::vector<Change>& changes) = 0;
  /// The files below a folder, by their whole paths, sorted; without hidden ones and build trees. It includes dangling
  /// links, and folders without permission, with a `/` at the end: their content is unknown.
  virtual std::vector<std::string> list(const std::string& folder) = 0;

protected:
  ~Outputs() = default;
};

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool out_colours = false; ///< it is a terminal, and colours are not disabled
  bool err_colours = false;
  dsl::FileAccess& files;
  Outputs& outputs;
  Programs& programs;
  std::string scanner = "director-clang"; ///< the program that reads C++, or where it should be
  std::string headers = {};               ///< the folder of the runtime's headers as installed; empty: unknown
  std::size_t out_width = 0;              ///< columns of the terminal; 0: it is none, so text is not wrapped
  std::size_t err_width = 0;
  bool out_clears = false; ///< it is a terminal that can be cleared
};

/// Prints whole lines to `err`. Quoted user input is escaped and shortened.
void print_message(Console& console, std::string_view lines);

/// False, and prints why, if they cannot be written. `consequence`: of that, as "nothing is written; ".
bool write(const std::vector<Output>& outputs, Console& console, std::string_view consequence = {});

/// The same console with other files.
Console with_files(const Console& console, dsl::FileAccess& files, Outputs& outputs);

/// The files below a folder of the disk, by whole paths, without hidden ones and build trees.
struct Below {
  std::vector<std::string> files; ///< sorted; as Outputs::list returns them
  std::vector<std::string> folders;
};
Below all_below(const std::string& folder);

class DiskOutputs final : public Outputs {
public:
  std::optional<std::string> write(const std::vector<Output>& outputs) override;
  std::optional<std::string> change(const std::vector<Change>& changes) override;
  std::vector<std::string> list(const std::string& folder) override;
};

class MemoryOutputs final : public Outputs {
public:
  std::optional<std::string> write(const std::vector<Output>& outputs) override;
  std::optional<std::string> change(const std::vector<Change>& changes) override;
  std::vector<std::string> list(const std::string& folder) override;
  std::map<std::string, std::string> files;
  std::vector<std::string> written; ///< paths in order, each time that a file changed

private:
  void put(const std::string& path, const std::string& text);
};

class ChildPrograms final : public Programs {
public:
  Answer run(const std::vector<std::string>& command, const std::string& input) override;
  Answer run_apart(const std::vector<std::string>& command, const std::string& input) override;
};

} // namespace director::compiler::cli
