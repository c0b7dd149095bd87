// Header: tests/runtime/dds/process.hpp. Test: tests/runtime/dds/team_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/runtime/dds/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace director::tests {

Process::Process(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  const int failed = posix_spawn(&id_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) {
    close(ends[0]);
    throw std::runtime_error("cannot start " + words[0]);
  }
  reader_ = std::thread(&Process::read, this, ends[0]);
}

Process::~Process() {
  if (id_ != 0) {
    signal(SIGKILL);
    wait();
  }
}

void Process::signal(int number) { kill(id_, number); }

int Process::wait() {
  if (id_ != 0) waitpid(id_, &status_, 0);
  id_ = 0;
  if (reader_.joinable()) reader_.join();
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

std::vector<std::string> Process::lines() {
  const std::lock_guard lock(mutex_);
  return lines_;
}

void Process::read(int from) {
  std::FILE* const file = fdopen(from, "r");
  char line[1024];
  while (std::fgets(line, sizeof line, file) != nullptr) {
    const std::lock_guard lock(mutex_);
    lines_.emplace_back(line);
    if (lines_.back().ends_with('\n')) lines_.back().pop_back();
  }
  std::fclose(file);
}

} // namespace director::tests
