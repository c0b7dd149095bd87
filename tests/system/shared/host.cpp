// Header: this program. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// shared_host <library> <runs>...: loads each library and counts the runs of its behaviour.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

int main(int count, char** words) {
  for (int i = 1; i + 1 < count; i += 2) {
    void* const library = dlopen(words[i], RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) {
      std::fprintf(stderr, "%s\n", dlerror());
      return 1;
    }
    const auto count_runs = reinterpret_cast<int (*)()>(dlsym(library, "count_runs"));
    const int runs = count_runs();
    std::printf("%s: %d runs\n", words[i], runs);
    if (runs != std::atoi(words[i + 1])) return 1;
  }
  return 0;
}
