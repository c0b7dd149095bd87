// Header: tests/support/running_program.hpp. Test: tests/compiler/cli/commands/watch_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/support/running_program.hpp"

#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <pty.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>

namespace director::tests {

namespace {

/// For whatever a machine that is busy does; a test that holds never waits for it.
constexpr int longest_silence = 60'000;

/// The system call fails from now on, as on a system that does not have it.
void forbid_notices() {
  std::array<sock_filter, 4> program{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_inotify_init1, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  }};
  const sock_fprog filter{program.size(), program.data()};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) ::_exit(126);
}

[[noreturn]] void become(const std::vector<std::string>& words, const std::filesystem::path& folder,
                         RunningProgram::Without without) {
  if (without == RunningProgram::Without::notices) forbid_notices();
  const std::string program = (binary_dir() / "bin" / words.front()).string();
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::setenv("TERM", "xterm", 1);
  ::unsetenv("NO_COLOR");
  ::signal(SIGINT, SIG_DFL); // who runs tests in the background may have it ignored
  if (::chdir(folder.c_str()) == 0) ::execv(program.c_str(), arguments.data());
  ::_exit(127);
}

} // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& words, const std::filesystem::path& folder, To to,
                               Without without) {
  if (to == To::terminal) {
    const winsize size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
    child_ = ::forkpty(&output_, nullptr, nullptr, &size);
    if (child_ == 0) become(words, folder, without);
  } else {
    std::array<int, 2> ends{};
    REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
    child_ = ::fork();
    if (child_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::dup2(ends[1], STDERR_FILENO);
      become(words, folder, without);
    }
    ::close(ends[1]);
    output_ = ends[0];
  }
  REQUIRE(child_ > 0);
}

RunningProgram::~RunningProgram() {
  if (output_ >= 0) ::close(output_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

bool RunningProgram::read_some() {
  pollfd ready{output_, POLLIN, 0};
  if (::poll(&ready, 1, longest_silence) <= 0) FAIL("nothing is printed any more; so far: " << unread_);
  std::array<char, 4096> part;
  const ssize_t count = ::read(output_, part.data(), part.size());
  if (count > 0) unread_.append(part.data(), static_cast<std::size_t>(count));
  return count > 0; // a terminal whose program has ended gives an error
}

std::string RunningProgram::read_until(const std::string& text) {
  std::size_t at;
  while ((at = unread_.find(text)) == std::string::npos) {
    if (!read_some()) FAIL("it has ended without `" << text << "`; it printed: " << unread_);
  }
  std::string out = unread_.substr(0, at + text.size());
  unread_.erase(0, at + text.size());
  return out;
}

void RunningProgram::send(int signal) const { ::kill(child_, signal); }

void RunningProgram::type(const std::string& keys) const {
  REQUIRE(::write(output_, keys.data(), keys.size()) == static_cast<ssize_t>(keys.size()));
}

std::string RunningProgram::rest() {
  while (read_some()) {}
  return std::move(unread_);
}

int RunningProgram::wait() {
  unread_ = rest(); // or it would wait for somebody to read
  int status = 0;
  ::waitpid(child_, &status, 0);
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace director::tests
