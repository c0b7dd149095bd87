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

/// Where a path from the top of the repository is on the disk.
fs::path on_disk(const Repository& repository, const std::string& name) {
  const fs::path prefix = fs::path(repository.prefix).parent_path(); // without the last slash
  return (repository.folder / fs::path(name).lexically_relative(prefix.empty() ? "." : prefix)).lexically_normal();
}

/// Whether git does not keep the file: it is outside of the repository, or not in the tree and ignored.
bool is_elsewhere(GitTree& tree, Programs& programs, const Repository& repository, const std::string& name) {
  if (is_outside(name)) return true;
  const GitTree::Place place = tree.find(name);
  if (place.is_there || place.leaves) return false;
  const std::string path = on_disk(repository, place.path).string();
  const Answer answer = programs.run_apart({"git", "-C", repository.folder, "check-ignore", "--quiet", "--", path}, "");
  return answer.started && answer.status == 0;
}

dsl::Result<std::string, dsl::FileError> read_submodule(Programs& programs, const Repository& repository,
                                                        const GitTree::Place& place, std::size_t most) {
  constexpr std::size_t shown = 12; // characters of a commit
  const std::string folder = on_disk(repository, place.submodule).string(), commit = place.commit.substr(0, shown);
  const Answer known = programs.run_apart({"git", "-C", folder, "cat-file", "-e", place.commit + "^{commit}"}, "");
  if (!known.started || known.status != 0)
    return dsl::FileError{dsl::FileError::Kind::not_readable,
                          fmt::format("it is in the submodule `{}`, whose commit {} is not on this computer: `git "
                                      "submodule update --init` fetches it",
                                      place.submodule, commit)};
  const std::string name = fs::path(place.path).lexically_relative(place.submodule).string();
  return read_object(programs, folder, place.commit + ":" + name,
                     fmt::format("in the commit {} of the submodule `{}`", commit, place.submodule), most);
}

/// The text of the file to which a path leads. `commit` is empty for what is staged.
dsl::Result<std::string, dsl::FileError> read_from(GitTree& tree, Programs& programs, const Repository& repository,
                                                   const std::string& commit, const std::string& name,
                                                   const std::string& where, std::size_t most) {
  const GitTree::Place place = tree.find(name);
  if (place.leaves)
    return dsl::FileError{dsl::FileError::Kind::not_readable, "it is a link to outside of the repository"};
  if (!place.submodule.empty()) return read_submodule(programs, repository, place, most);
  return read_object(programs, repository.folder, commit + ":" + place.path, where, most);
}

/// An import that is not on the disk either, or that git cannot read. Of a path that is only tried, `most` is 0.
void note_lost(const dsl::Result<std::string, dsl::FileError>& read, const std::string& path, std::size_t most,
               const std::set<std::string>& elsewhere, LostFile& lost) {
  if (read || most == 0 || !lost.empty()) return;
  const dsl::FileError& error = read.error();
  if (elsewhere.contains(path))
    lost = {path, error.message + "; git does not keep it"};
  else if (error.kind == dsl::FileError::Kind::not_readable)
    lost = {path, error.message};
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
  repository_ = found.value();
  is_absolute_ = fs::path(file).is_absolute();
  const auto parsed = [&](const std::string& name) {
    return programs_.run_apart(
        {"git", "-C", repository_.folder, "rev-parse", "--verify", "--quiet", "--end-of-options", name}, "");
  };
  const Answer commit = parsed(revision_ + "^{commit}");
  if (commit.status != 0) {
    if (const Answer other = parsed(revision_); other.status != 0)
      return fmt::format("git knows no revision `{}`{}", revision_, words_of_git(other));
    return fmt::format("`{}` is no commit: name one, a branch or a tag", revision_);
  }
  commit_ = first_line(commit.output);
  tree_.emplace(programs_, repository_.folder, commit_);
  path_ = top() + name_before(inside(found.value(), file), newer);
  return {};
}

/// The name of the file in the revision, if git can find it; otherwise the same name.
std::string GitFiles::name_before(const std::string& name, Newer newer) {
  const auto there = read_object(programs_, repository_.folder, commit_ + ":" + name, "", dsl::largest_file);
  if (there || there.error().kind != dsl::FileError::Kind::not_found) return name;
  std::vector<std::string> command{
      "git",           "-C", repository_.folder, "diff", "--find-renames", "--diff-filter=R", "--no-relative",
      "--name-status", "-z"};
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
  if (!path.starts_with(top()) && !elsewhere_.contains(path)) return disk_.read(path, most, kinds); // of a build
  auto read = elsewhere_.contains(path) ? disk_.read(path, most, kinds)
                                        : read_from(*tree_, programs_, repository_, commit_, path.substr(top().size()),
                                                    fmt::format("in the revision `{}`", revision_), most);
  note_lost(read, path, most, elsewhere_, lost_);
  return read;
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
  const bool is_kept = !is_elsewhere(*tree_, programs_, repository_, name);
  auto read =
      is_kept ? read_from(*tree_, programs_, repository_, "", name, "is staged", most) : disk_.read(path, most, kinds);
  note_lost(read, path, most, elsewhere_, lost_);
  return read;
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
  if (fs::path(relative).is_absolute()) return disk_.beside(file, relative);
  const bool is_kept = file.starts_with(top()); // the revision is no folder
  const std::string name = is_kept ? FileAccess::beside(file.substr(top().size()), relative)
                                   : inside(repository_, disk_.beside(file, relative));
  if (!is_elsewhere(*tree_, programs_, repository_, name)) return top() + name;
  fs::path path = is_kept ? on_disk(repository_, name) : fs::path(disk_.beside(file, relative));
  if (is_kept && !is_absolute_) path = path.lexically_relative(absolute_path("."));
  return *elsewhere_.insert(path.string()).first;
}

std::string StagedFiles::beside(const std::string& file, const std::string& relative) {
  std::string path = disk_.beside(file, relative);
  if (is_elsewhere(*tree_, programs_, repository_, inside(repository_, path))) elsewhere_.insert(path);
  return path;
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
