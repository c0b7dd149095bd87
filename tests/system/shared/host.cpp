// Header: this program. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// shared_host <library> <runs>...: loads each library, counts the runs of its behaviour and unloads it; then the same
// again with all of them loaded, and each one's symbols visible to the others.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace {

/// The library, or null if it cannot be loaded or its behaviour runs otherwise.
void* play(const char* file, int mode, int expected) {
  void* const library = dlopen(file, RTLD_NOW | mode);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return nullptr;
  }
  const auto count_runs = reinterpret_cast<int (*)()>(dlsym(library, "count_runs"));
  const int runs = count_runs();
  std::printf("%s: %d runs\n", file, runs);
  return runs == expected ? library : nullptr;
}

} // namespace

int main(int count, char** words) {
  for (int i = 1; i + 1 < count; i += 2) {
    void* const library = play(words[i], RTLD_LOCAL, std::atoi(words[i + 1]));
    if (library == nullptr) return 1;
    dlclose(library);
    if (dlopen(words[i], RTLD_NOW | RTLD_NOLOAD) == nullptr) continue;
    std::fprintf(stderr, "%s is not unloaded\n", words[i]);
    return 1;
  }
  for (int i = 1; i + 1 < count; i += 2) {
    if (play(words[i], RTLD_GLOBAL, std::atoi(words[i + 1])) == nullptr) return 1;
  }
  return 0;
}
