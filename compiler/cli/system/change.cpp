// Header: compiler/cli/system/change.hpp. Test: tests/compiler/cli/system/change_test.cpp, write_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/change.hpp"

#include "compiler/emit/artefact/notice.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;
using Fault = std::optional<std::string>;

std::string at(const std::string& path, const std::string& why) { return "`" + path + "`: " + why; }

std::optional<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// A change, and the kind of its file: the user's, which must not have changed meanwhile, or a generated one.
struct Step {
  Change change;
  bool generated = false;
};

/// A file that is written beside its final place. Removed unless it is moved there.
struct Written {
  const Step* step;
  fs::path target; ///< after symbolic links
  std::string temporary;
  mode_t mode = 0;
  bool placed = false;
};

const char* fault_of_kind(mode_t mode) {
  if (S_ISREG(mode)) return nullptr;
  return S_ISDIR(mode) ? "a folder is in the way" : "it is no ordinary file";
}

/// Why this file must not be changed, or is not as it was.
Fault refusal(const Step& step, const fs::path& target, struct stat& status) {
  const Change& change = step.change;
  const bool exists = ::lstat(target.c_str(), &status) == 0;
  if (!change.before) return exists && !step.generated ? Fault{"it exists already"} : Fault{};
  if (!exists) return std::strerror(errno);
  if (const char* const fault = fault_of_kind(status.st_mode)) return fault;
  if ((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(target.c_str(), W_OK) != 0)
    return "it is read-only";
  if (!step.generated && text_of(target) != change.before) return "it has changed meanwhile; run this again";
  return {};
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// What the user wrote is on the disk before it replaces the old file; what is generated can be made again.
bool keep(int file, const Step& step) {
  return step.generated || ::fsync(file) == 0 || errno == EINVAL || errno == EROFS; // not every file system supports it
}

Fault write_beside(Written& out, std::string_view text) {
  constexpr std::size_t longest = 200; // of the file's own name: with the suffix within the limit of file systems
  const std::string own = out.target.filename().string().substr(0, longest);
  std::string name = (out.target.parent_path() / ("." + own + ".XXXXXX")).string();
  const int file = ::mkstemp(name.data());
  if (file < 0) return std::strerror(errno);
  out.temporary = name;
  int fault = write_all(file, text) && keep(file, *out.step) ? 0 : errno;
  if (fault == 0 && ::fchmod(file, out.mode) != 0) fault = errno;
  if (::close(file) != 0 && fault == 0) fault = errno;
  return fault == 0 ? Fault{} : std::strerror(fault);
}

/// The new file keeps the owner of the old one, if that is permitted.
void keep_owner(const Written& out, const struct stat& status) {
  if (out.step->change.before) std::ignore = ::lchown(out.temporary.c_str(), status.st_uid, status.st_gid);
}

mode_t mode_of_new_files() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// Creates the missing folders, and adds them to `made`, the outermost first.
std::error_code make_folder(const fs::path& folder, std::vector<fs::path>& made) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path each = folder; !each.empty() && !fs::exists(each, error); each = each.parent_path())
    missing.push_back(each);
  made.insert(made.end(), missing.rbegin(), missing.rend());
  fs::create_directories(folder, error);
  return error;
}

Fault prepare(const Step& step, std::vector<Written>& all, std::vector<fs::path>& made) {
  const Change& change = step.change;
  std::error_code error;
  fs::path target = change.path;
  if (change.before) target = fs::canonical(target, error);
  if (error) return error.message();
  struct stat status {};
  if (Fault fault = refusal(step, target, status)) return fault;
  if (!change.before && target.has_parent_path()) error = make_folder(target.parent_path(), made);
  if (error) return error.message();
  all.push_back({&step, target, {}, change.before ? status.st_mode & 07777U : mode_of_new_files(), false});
  Fault fault = write_beside(all.back(), change.after);
  if (!fault) keep_owner(all.back(), status);
  return fault;
}

/// A new file never replaces an existing one.
Fault place(Written& each) {
  struct stat status {};
  if (Fault fault = refusal(*each.step, each.target, status)) return fault;
  // Another process may be generating the same.
  const unsigned only_new = each.step->change.before || each.step->generated ? 0 : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, each.temporary.c_str(), AT_FDCWD, each.target.c_str(), only_new) != 0) {
    // Not every file system supports the flag; a link never replaces a file either.
    if (only_new == 0 || (errno != EINVAL && errno != ENOSYS)) return std::strerror(errno);
    if (::link(each.temporary.c_str(), each.target.c_str()) != 0) return std::strerror(errno);
    ::unlink(each.temporary.c_str());
  }
  each.placed = true;
  return {};
}

/// `made`: the folders that are new.
void take_back(std::vector<Written>& all, const std::vector<fs::path>& made) {
  for (Written& each : all) {
    if (!each.placed) {
      if (!each.temporary.empty()) ::unlink(each.temporary.c_str());
    } else if (!each.step->change.before) {
      ::unlink(each.target.c_str());
    } else if (!write_beside(each, *each.step->change.before)) {
      ::rename(each.temporary.c_str(), each.target.c_str());
    }
  }
  // This fails if something else uses the folder.
  for (auto each = made.rbegin(); each != made.rend(); ++each) ::rmdir(each->c_str());
}

/// Blocks the signals that end the program during its lifetime.
class Undisturbed {
public:
  Undisturbed() {
    sigset_t polite;
    ::sigemptyset(&polite);
    for (const int each : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE}) ::sigaddset(&polite, each);
    ::sigprocmask(SIG_BLOCK, &polite, &before_);
  }
  ~Undisturbed() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

private:
  sigset_t before_{};
};

Fault carry_out(const std::vector<Step>& steps, const Watch& watch) {
  const Undisturbed undisturbed;
  std::vector<Written> all;
  std::vector<fs::path> made;
  all.reserve(steps.size());
  Fault fault;
  const Step* last = nullptr;
  for (const Step& step : steps) {
    last = &step;
    if (fault = prepare(step, all, made); fault) break;
    if (watch) watch();
  }
  for (std::size_t i = 0; !fault && i < all.size(); ++i) {
    last = all[i].step;
    fault = place(all[i]);
    if (!fault && watch) watch();
  }
  if (!fault) return {};
  take_back(all, made);
  return at(last->change.path, *fault);
}

/// Adds the step that writes this output, if there is anything to do.
Fault plan(const Output& output, std::vector<Step>& steps) {
  if (output.path.ends_with('/')) return "it is called as a folder is; name a file";
  struct stat status {};
  if (::stat(output.path.c_str(), &status) != 0) {
    if (::lstat(output.path.c_str(), &status) == 0) return "it is a link that leads nowhere";
    if (errno != ENOENT) return std::strerror(errno);
    steps.push_back({{output.path, {}, output.text}, true});
    return {};
  }
  // Only a regular file is read: opening a pipe would wait for the other side.
  if (const char* const fault = fault_of_kind(status.st_mode)) return fault;
  const std::optional<std::string> text = text_of(output.path);
  if (!text) return std::strerror(errno);
  if (*text == output.text && !output.newest) return {};
  if (output.is_own != nullptr && !text->empty() && !output.is_own(*text)) return why_not_replaced(*text);
  steps.push_back({{output.path, text, output.text}, true});
  return {};
}

} // namespace

const char* why_not_replaced(std::string_view text) {
  const bool own = has_notice(text) || is_depfile(text) || is_trace(text);
  return own ? "what is there is an output of directorc of another kind; move it away, or name another place"
             : "what is there was not written by directorc; move it away, or name another place";
}

bool is_depfile(std::string_view text) {
  const std::size_t targets = text.find(": ");
  if (targets == text.npos || !text.substr(targets).starts_with(": \\\n") || !text.ends_with('\n')) return false;
  for (std::size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1))
    if (text[at - 1] != '\\' || !text.substr(at + 1).starts_with("  ")) return false;
  return true;
}

std::optional<std::string> apply_on_disk(const std::vector<Change>& changes, const Watch& watch) {
  std::vector<Step> steps;
  for (const Change& change : changes) steps.push_back({change});
  return carry_out(steps, watch);
}

std::optional<std::string> write_on_disk(const std::vector<Output>& outputs, const Watch& watch) {
  std::vector<Step> steps;
  std::map<fs::path, std::string_view> texts;
  for (const Output& output : outputs) {
    const auto [same, is_new] = texts.try_emplace(fs::path(output.path).lexically_normal(), output.text);
    if (!is_new && same->second != output.text) return at(output.path, "two different texts would go there");
    if (!is_new) continue;
    if (const Fault fault = plan(output, steps)) return at(output.path, *fault);
  }
  return carry_out(steps, watch);
}

} // namespace director::compiler::cli
