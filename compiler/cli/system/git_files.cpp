// Header: compiler/cli/system/git_files.hpp. Test: tests/docs/diff_git_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/git_files.hpp"

#include "compiler/base/absolute_path.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// ` (git: …)`, git's error message; empty if there is none.
std::string words_of_git(const Answer& answer) {
  std::string line = first_line(answer.errors);
  for (const std::string_view severity : {"fatal: ", "error: "}) {
    if (line.starts_with(severity)) line.erase(0, severity.size());
  }
  return line.empty() ? line : fmt::format(" (git: {})", line);
}

/// The folder of the file; if that is gone too, the nearest existing one above it.
fs::path folder_of(const std::string& file) {
  std::error_code error;
  fs::path folder = absolute_path(file).lexically_normal().parent_path();
  while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

/// The text of a git object: COMMIT:PATH, or :PATH for what is staged. `where`: its description for messages.
dsl::Result<std::string, dsl::FileError> read_object(Programs& programs, const std::string& folder,
                                                     const std::string& name, const std::string& where,
                                                     std::size_t most) {
  using Kind = dsl::FileError::Kind;
  if (name.find('\n') != std::string::npos) return dsl::FileError{Kind::not_readable, "a line break in its name"};
  // A header line: `OID blob SIZE`, or that there is no such object.
  const Answer answer =
      programs.run_apart({"git", "-C", folder, "cat-file", "--batch", "--follow-symlinks"}, name + "\n");
  if (!answer.started || answer.status != 0)
    return dsl::FileError{Kind::not_readable, "git cannot read it" + words_of_git(answer)};
  const std::string head = first_line(answer.output);
  const std::size_t blob = head.find(" blob ");
  if (head.ends_with(" missing") || head.starts_with("dangling "))
    return dsl::FileError{Kind::not_found, "no such file " + where};
  if (head.starts_with("symlink "))
    return dsl::FileError{Kind::not_readable, "it is a link to outside of the repository"};
  if (blob == std::string::npos) return dsl::FileError{Kind::not_readable, "it is no file there"};
  if (answer.output.size() < head.size() + 2) return dsl::FileError{Kind::not_readable, "git cannot read it"};
  std::string text = answer.output.substr(head.size() + 1);
  text.pop_back(); // the line break that git adds
  if (text.size() > most) return dsl::FileError{Kind::too_large, "it is too large"};
  return text;
}

/// The path from the top of the repository; begins with `..` if it is outside.
std::string inside(const Repository& repository, const std::string& file) {
  const fs::path from_folder = absolute_path(file).lexically_normal().lexically_relative(repository.folder);
  return (fs::path(repository.prefix) / from_folder).lexically_normal().string();
}

/// Of a path from the top of the repository.
bool is_outside(const std::string& name) { return name == ".." || name.starts_with("../"); }

/// The text of the file to which a path leads. `commit` is empty for what is staged.
dsl::Result<std::string, dsl::FileError> read_from(GitTree& tree, Programs& programs, const std::string& folder,
                                                   const std::string& commit, const std::string& name,
                                                   const std::string& where, std::size_t most) {
  const GitTree::Place place = tree.find(name);
  if (place.leaves)
    return dsl::FileError{dsl::FileError::Kind::not_readable, "it is a link to outside of the repository"};
  return read_object(programs, folder, commit + ":" + place.path, where, most);
}

} // namespace

dsl::Result<Repository, std::string> find_repository(Programs& programs, const std::string& file) {
  Repository out{folder_of(file).string(), {}};
  const Answer prefix = programs.run_apart({"git", "-C", out.folder, "rev-parse", "--show-prefix"}, "");
  if (!prefix.started) return std::string("there is no program `git`");
  if (prefix.status != 0)
    return fmt::format("`{}` is in no git repository that can be read{}", file, words_of_git(prefix));
  out.prefix = first_line(prefix.output);
  return out;
}

std::optional<std::string> GitFiles::open(const std::string& file, Newer newer) {
  const auto found = find_repository(programs_, file);
  if (!found) return found.error();
  folder_ = found.value().folder;
  const auto parsed = [&](const std::string& name) {
    return programs_.run_apart({"git", "-C", folder_, "rev-parse", "--verify", "--quiet", "--end-of-options", name},
                               "");
  };
  const Answer commit = parsed(revision_ + "^{commit}");
  if (commit.status != 0) {
    if (const Answer other = parsed(revision_); other.status != 0)
      return fmt::format("git knows no revision `{}`{}", revision_, words_of_git(other));
    return fmt::format("`{}` is no commit: name one, a branch or a tag", revision_);
  }
  commit_ = first_line(commit.output);
  tree_.emplace(programs_, folder_, commit_);
  path_ = top() + name_before(inside(found.value(), file), newer);
  return {};
}

/// The name of the file in the revision, if git can find it; otherwise the same name.
std::string GitFiles::name_before(const std::string& name, Newer newer) {
  const auto there = read_object(programs_, folder_, commit_ + ":" + name, "", dsl::largest_file);
  if (there || there.error().kind != dsl::FileError::Kind::not_found) return name;
  std::vector<std::string> command{
      "git", "-C", folder_, "diff", "--find-renames", "--diff-filter=R", "--no-relative", "--name-status", "-z"};
  if (newer == Newer::staged) command.emplace_back("--cached");
  command.insert(command.end(), {commit_, "--"});
  const Answer answer = programs_.run_apart(command, "");
  if (answer.status != 0) return name;
  // R100, the old name and the new one, each terminated by a zero.
  std::vector<std::string> words;
  for (std::size_t at = 0, end = 0; (end = answer.output.find('\0', at)) != std::string::npos; at = end + 1)
    words.push_back(answer.output.substr(at, end - at));
  for (std::size_t i = 0; i + 2 < words.size(); i += 3) {
    if (words[i + 2] == name) return words[i + 1];
  }
  return name;
}

dsl::Result<std::string, dsl::FileError> GitFiles::fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) {
  if (path.starts_with('/')) return disk_.read(path, most, kinds);
  const std::string name = path.substr(std::min(path.size(), top().size()));
  if (!path.starts_with(top()) || is_outside(name))
    return dsl::FileError{dsl::FileError::Kind::not_found, "it is outside of the repository"};
  return read_from(*tree_, programs_, folder_, commit_, name, fmt::format("in the revision `{}`", revision_), most);
}

std::optional<std::string> StagedFiles::open(const std::string& file) {
  const auto found = find_repository(programs_, file);
  if (!found) return found.error();
  repository_ = found.value();
  tree_.emplace(programs_, repository_.folder, "");
  return {};
}

dsl::Result<std::string, dsl::FileError> StagedFiles::fetch(const std::string& path, std::size_t most,
                                                            dsl::Kinds kinds) {
  const std::string name = inside(repository_, path);
  if (is_outside(name)) return disk_.read(path, most, kinds);
  return read_from(*tree_, programs_, repository_.folder, "", name, "is staged", most);
}

std::string StagedFiles::identity(const std::string& path) {
  const std::string name = inside(repository_, path);
  return is_outside(name) ? disk_.identity(path) : ":" + tree_->find(name).path;
}

std::string GitFiles::identity(const std::string& path) {
  if (!path.starts_with(top())) return disk_.identity(path);
  return top() + tree_->find(path.substr(top().size())).path;
}

std::string GitFiles::beside(const std::string& file, const std::string& relative) {
  if (!file.starts_with(top()) || fs::path(relative).is_absolute()) return disk_.beside(file, relative);
  return top() + FileAccess::beside(file.substr(top().size()), relative); // the revision is no folder
}

FilesBeside::FilesBeside(dsl::FileAccess& files, const std::string& first, const std::string& second)
    : files_(files),
      first_(fs::path(first).lexically_normal().parent_path().string()),
      second_(fs::path(second).lexically_normal().parent_path().string()) {}

std::string FilesBeside::beside(const std::string& file, const std::string& relative) {
  const auto moved = moved_.find(file);
  std::string wanted = files_.beside(moved == moved_.end() ? file : moved->second, relative);
  const fs::path inside = fs::path(wanted).lexically_normal().lexically_relative(first_.empty() ? "." : first_);
  if (inside.empty() || first_ == second_ || is_there(wanted)) return wanted;
  std::string other = (fs::path(second_) / inside).lexically_normal().string();
  if (!is_there(other)) return wanted;
  moved_.emplace(other, std::move(wanted));
  return other;
}

bool FilesBeside::is_there(const std::string& path) {
  const auto read = files_.read(path, 0, dsl::Kinds::ordinary);
  return read || read.error().kind != dsl::FileError::Kind::not_found;
}

} // namespace director::compiler::cli
