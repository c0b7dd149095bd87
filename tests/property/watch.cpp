// Header: tests/property/watch.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/watch.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

namespace director::property {

namespace {

constexpr unsigned most_seconds = 60;

std::atomic<std::uint64_t> seed_in_hand{0};

/// Only what a signal handler may do.
void write_text(const char* text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

void die(int signal) {
  char digits[24];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  for (std::uint64_t left = seed_in_hand; left != 0; left /= 10) *--at = static_cast<char>('0' + left % 10);
  write_text(signal == SIGALRM ? "\nno answer within a minute: DIRECTOR_SEED="
                               : "\nin hand when it died: DIRECTOR_SEED=");
  write_text(at);
  write_text("\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

} // namespace

void watch(std::uint64_t seed) {
  seed_in_hand = seed;
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, die);
  ::alarm(most_seconds);
}

void stop_watching() {
  ::alarm(0);
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, SIG_DFL);
}

} // namespace director::property
