// Header: compiler/cli/system/console.hpp. Test: tests/compiler/cli/system/console_test.cpp.
// SPDX-License-Identifier: MIT
//
// A child process with a pipe to it and one or two from it. All are served by poll, so that the two sides cannot block
// each other with full pipes.
#include "compiler/cli/system/console.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>

extern char** environ;

namespace director::compiler::cli {

namespace {

class Descriptor {
public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }

private:
  int number_;
};

void send_some(Descriptor& to, const std::string& input, std::size_t& sent) {
  const ssize_t count = sent < input.size() ? ::write(to.number(), input.data() + sent, input.size() - sent) : 0;
  if (count > 0) sent += static_cast<std::size_t>(count);
  const bool later = count < 0 && (errno == EAGAIN || errno == EINTR);
  if ((count < 0 && !later) || sent == input.size()) to.close();
}

void receive_some(Descriptor& from, std::string& output) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
  if (count > 0) output.append(buffer.data(), static_cast<std::size_t>(count));
  if (count == 0 || (count < 0 && errno != EINTR)) from.close();
}

/// Closes its ends.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  bool made = ::pipe2(ends.data(), O_CLOEXEC) == 0;
  Descriptor reading{ends[0]}, writing{ends[1]};
};

/// `errors`: null if they are not captured.
void talk(Descriptor& to, Descriptor& from, Pipe* errors, const std::string& input, Answer& answer) {
  std::size_t sent = 0;
  const auto err = [&] { return errors != nullptr && errors->reading.open() ? errors->reading.number() : -1; };
  while (from.open() || err() >= 0) {
    std::array<pollfd, 3> wanted{{{from.number(), POLLIN, 0}, {to.number(), POLLOUT, 0}, {err(), POLLIN, 0}}};
    if (::poll(wanted.data(), wanted.size(), -1) < 0) {
      if (errno == EINTR) continue;
      break;
    }
    if (wanted[1].revents != 0) send_some(to, input, sent);
    if (wanted[0].revents != 0) receive_some(from, answer.output);
    if (wanted[2].revents != 0) receive_some(errors->reading, answer.errors);
  }
}

Answer run_child(const std::vector<std::string>& command, const std::string& input, bool apart) {
  Pipe in, out;
  std::optional<Pipe> errors;
  if (apart) errors.emplace();
  if (!in.made || !out.made || (errors && !errors->made)) return {};
  ::fcntl(in.writing.number(), F_SETFL, O_NONBLOCK);

  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.reading.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.writing.number(), STDOUT_FILENO);
  if (errors) posix_spawn_file_actions_adddup2(&actions, errors->writing.number(), STDERR_FILENO);
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return {};

  in.reading.close();
  out.writing.close();
  if (errors) errors->writing.close();
  Answer answer{.started = true};
  auto* const before = std::signal(SIGPIPE, SIG_IGN); // a child that does not read its input must not end this process
  talk(in.writing, out.reading, errors ? &*errors : nullptr, input, answer);
  std::signal(SIGPIPE, before);
  in.writing.close();
  int status = 0;
  ::waitpid(child, &status, 0);
  answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  return answer;
}

} // namespace

Answer ChildPrograms::run(const std::vector<std::string>& command, const std::string& input) {
  return run_child(command, input, false);
}

Answer ChildPrograms::run_apart(const std::vector<std::string>& command, const std::string& input) {
  return run_child(command, input, true);
}

} // namespace director::compiler::cli
