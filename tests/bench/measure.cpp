// Header: this program, started by ./bench. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// measure TIMES COMMAND...: runs the command this number of times and prints the median of its processor time in
// seconds, and its most memory in MB. Its output is discarded; if it fails, so does this.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

int main(int count, char** arguments) {
  const int times = count > 2 ? std::atoi(arguments[1]) : 0;
  if (times < 1) {
    std::fputs("measure TIMES COMMAND...\n", stderr);
    return 2;
  }
  std::vector<double> all;
  long most = 0;
  for (int i = 0; i < times; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      execvp(arguments[2], arguments + 2);
      _exit(127);
    }
    int status = 0;
    rusage used{};
    if (child < 0 || wait4(child, &status, 0, &used) < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      std::fprintf(stderr, "measure: %s fails\n", arguments[2]);
      return 1;
    }
    all.push_back(seconds(used.ru_utime) + seconds(used.ru_stime));
    most = std::max(most, used.ru_maxrss);
  }
  std::nth_element(all.begin(), all.begin() + times / 2, all.end());
  std::printf("%.3f %ld\n", all[static_cast<std::size_t>(times) / 2], most / 1024);
  return 0;
}
