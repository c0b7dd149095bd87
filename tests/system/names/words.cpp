// Header: tests/system/names/words.hpp. Test: tests/system/names/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/system/names/words.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace director::tests {

namespace fs = std::filesystem;

namespace {

constexpr const char* headers = R"(
algorithm any array atomic barrier bit bitset cassert ccomplex cctype cerrno cfenv cfloat charconv chrono cinttypes ciso646
climits clocale cmath codecvt compare complex concepts condition_variable coroutine csetjmp csignal cstdalign cstdarg
cstdbool cstddef cstdint cstdio cstdlib cstring ctgmath ctime cuchar cwchar cwctype deque exception execution filesystem
format forward_list fstream functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list
locale map memory memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex
scoped_allocator semaphore set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string
string_view strstream syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility
valarray variant vector version assert.h complex.h ctype.h errno.h fenv.h float.h inttypes.h iso646.h limits.h locale.h
math.h setjmp.h signal.h stdalign.h stdarg.h stdatomic.h stdbool.h stddef.h stdint.h stdio.h stdlib.h string.h tgmath.h
time.h uchar.h wchar.h wctype.h
)";

/// Their macros are no words: they are not refused.
constexpr const char* headers_of_posix = R"(
arpa/inet.h dirent.h dlfcn.h fcntl.h netinet/in.h poll.h pthread.h sched.h semaphore.h strings.h sys/ioctl.h sys/mman.h
sys/select.h sys/socket.h sys/stat.h sys/time.h sys/types.h sys/wait.h termios.h unistd.h
)";

std::string include_lines(const char* list) {
  std::string out;
  std::istringstream names(list);
  for (std::string name; names >> name;) out += "#if __has_include(<" + name + ">)\n#include <" + name + ">\n#endif\n";
  return out;
}

/// Beside what is read from files.
constexpr const char* others = R"(
_ __ ___ _0 _1 _a a_ a__b _A _Complex _Bool _Generic __asm__ __attribute__ __int128 __null __LINE__ __FILE__ __func__ __cplusplus
stat open poll read write select socket connect bind listen accept send recv kill link sleep pause sync tee pipe nice dup fork
access DIR dirent sockaddr termios winsize iovec flock fcntl ioctl mmap truncate shutdown linger sem_t pthread_t
std director detail names main abs exit abort int32_t size_t time clock signal raise log exp sin index remove rename div round
FILE tm div_t max_align_t nullptr_t string vector array function chrono placeholders posix literals
alignas auto bool char class const default delete do double else enum export extern false float for friend goto if inline int long
namespace new noexcept not nullptr operator or private protected public register return short signed sizeof static struct switch
template this throw true try typedef typeid typename typeof union unsigned using virtual void volatile while xor final override import
module requires concept co_await consteval char8_t start Start stop Stop Default root limbo Behaviour behaviour observer
Observer observer_module Class class_module thrown modules modules_ module_0 module_1 pack_0 pack_names core_ data_ eOF nULL
iNFINITY i I linux unix i386 errno Errno assert Assert stdin offsetof request done fail keep task tasks reasons set try_set wait
uses triggered provide ask run Speed Course Phase Row Table types t0 t1
)";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_word_char(char c) {
  return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

void add_words(const std::string& text, std::set<std::string>& words) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_word_char(text[end])) ++end;
    if (end > at && !(text[at] >= '0' && text[at] <= '9')) words.insert(text.substr(at, end - at));
    at = end > at ? end : at + 1;
  }
}

void add_macros(const std::string& compiler, const fs::path& folder, std::set<std::string>& words) {
  const fs::path source = folder / "headers.cpp", macros = folder / "macros.txt";
  std::ofstream(source) << include_lines(headers);
  const std::string command =
      compiler + " -std=gnu++20 -w -dM -E '" + source.string() + "' -o '" + macros.string() + "'";
  if (std::system(command.c_str()) != 0) return;
  std::istringstream lines(read(macros));
  std::string define, name;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream(line) >> define >> name;
    words.insert(name.substr(0, name.find('(')));
  }
}

} // namespace

std::string all_headers() { return include_lines(headers) + include_lines(headers_of_posix); }

std::vector<std::string> colliding_words(const std::string& compiler, const std::string& folder) {
  std::set<std::string> words;
  add_macros(compiler, folder, words);
  const fs::path root = DIRECTOR_SOURCE_DIR;
  for (const char* place : {"runtime/core", "generated/soccer"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / place)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".hpp" || extension == ".cpp") add_words(read(entry.path()), words);
    }
  }
  add_words(others, words);
  return {words.begin(), words.end()};
}

} // namespace director::tests
