// Header: compiler/cli/system/git_tree.hpp. Test: tests/docs/diff_git_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/git_tree.hpp"

#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

constexpr int most_links = 40; // as Linux

} // namespace

void GitTree::read() {
  entries_.emplace();
  const std::vector<std::string> git{"git", "-C", folder_};
  std::vector<std::string> command = git;
  if (commit_.empty())
    command.insert(command.end(), {"ls-files", "--stage", "-z", "--full-name", "--", ":(top)"});
  else
    command.insert(command.end(), {"ls-tree", "-r", "-z", "--full-tree", commit_});
  const Answer answer = programs_.run_apart(command, "");
  if (!answer.started || answer.status != 0) return; // reading a file then reports why
  const std::string_view all = answer.output;
  for (std::size_t at = 0, end = 0; (end = all.find('\0', at)) != std::string_view::npos; at = end + 1)
    add(all.substr(at, end - at));
}

/// `MODE blob OBJECT TAB PATH` in a commit, `MODE OBJECT STAGE TAB PATH` of what is staged.
void GitTree::add(std::string_view line) {
  const std::size_t tab = line.find('\t'), first = line.find(' '), second = line.find(' ', first + 1);
  if (tab == std::string_view::npos || second > tab) return;
  const std::string_view mode = line.substr(0, first);
  const std::string_view object =
      commit_.empty() ? line.substr(first + 1, second - first - 1) : line.substr(second + 1, tab - second - 1);
  const Entry::Kind kind = mode == "120000"   ? Entry::Kind::link
                           : mode == "160000" ? Entry::Kind::submodule
                                              : Entry::Kind::file;
  entries_->insert_or_assign(std::string(line.substr(tab + 1)), Entry{kind, std::string(object)});
}

std::string GitTree::target_of(const Entry& link) {
  const auto [at, is_new] = targets_.try_emplace(link.object);
  if (is_new) at->second = programs_.run_apart({"git", "-C", folder_, "cat-file", "blob", link.object}, "").output;
  return at->second;
}

GitTree::Place GitTree::find(const std::string& path) {
  if (!entries_) read();
  const fs::path all(path);
  std::deque<fs::path> rest(all.begin(), all.end());
  fs::path out;
  int links = 0;
  while (!rest.empty()) {
    const fs::path part = std::move(rest.front());
    rest.pop_front();
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      if (out.empty()) return {path, true};
      out = out.parent_path();
      continue;
    }
    out /= part;
    const auto entry = entries_->find(out.string());
    if (entry == entries_->end()) continue; // a folder, or nothing
    if (entry->second.kind == Entry::Kind::link && links++ < most_links) {
      const fs::path target = target_of(entry->second);
      if (target.is_absolute()) return {path, true};
      rest.insert(rest.begin(), target.begin(), target.end());
      out = out.parent_path();
    } else if (entry->second.kind == Entry::Kind::submodule) {
      Place there{out.string(), false, true, out.string(), entry->second.object};
      for (const fs::path& inside : rest) there.path = (fs::path(there.path) / inside).string();
      return there;
    }
  }
  const auto entry = entries_->find(out.string());
  return {out.string(), false, entry != entries_->end() && entry->second.kind == Entry::Kind::file};
}

} // namespace director::compiler::cli
