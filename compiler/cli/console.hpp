#pragma once
// SPDX-License-Identifier: MIT
// The world as a subcommand sees it: two streams, files to read, files to write. Behind it the terminal and the disk
// for main, strings and maps for tests.

#include "compiler/cli/change.hpp"
#include "compiler/facts/programs.hpp"
#include "dsl/file_access.hpp"

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

class Outputs {
public:
  /// What is generated: all of it, or nothing and what is wrong. Makes the folders that are missing; a file that has
  /// its text already is not touched.
  virtual std::optional<std::string> write(const std::vector<Output>& outputs) = 0;
  /// Files of the user: all of the changes, or none and what is wrong.
  virtual std::optional<std::string> change(const std::vector<Change>& changes) = 0;
  /// The files below a folder, by their whole paths, sorted; without hidden ones and what lies in build trees. Links
  /// that lead nowhere are among them, and folders that nobody may read, with a `/` behind: what lies there is not
  /// known.
  virtual std::vector<std::string> list(const std::string& folder) = 0;

protected:
  ~Outputs() = default;
};

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool out_colours = false; ///< it is a terminal, and nobody asked for no colours
  bool err_colours = false;
  dsl::FileAccess& files;
  Outputs& outputs;
  Programs& programs;
  std::string scanner = "director-clang"; ///< the program that reads C++, or where it should be
  std::string headers = {};               ///< the folder of the runtime's, as they are installed; empty: unknown
  std::size_t out_width = 0;              ///< columns of the terminal; 0: it is none, so text stays as it is written
  std::size_t err_width = 0;
  bool out_clears = false; ///< it is a terminal that can be cleared
};

/// Whole lines to `err`. What they repeat of a user's input commands no terminal, and is no longer than somebody reads.
void print_message(Console& console, std::string_view lines);

/// False, and says why, where they cannot be written. `consequence`: of that, as "nothing is written; ".
bool write(const std::vector<Output>& outputs, Console& console, std::string_view consequence = {});

/// The same world with other files behind it.
Console with_files(const Console& console, dsl::FileAccess& files, Outputs& outputs);

/// What lies below a folder of the disk, by whole paths, without hidden ones and what lies in build trees.
struct Below {
  std::vector<std::string> files; ///< sorted; as Outputs::list gives them
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
