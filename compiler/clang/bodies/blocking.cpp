// Header: compiler/clang/bodies/blocking.hpp. Test: tests/compiler/clang.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/blocking.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace director::scanning {

namespace {

using Text = std::string_view; // names, with blanks between them

constexpr Text sleeps = R"(
std::this_thread::sleep_for std::this_thread::sleep_until clock_nanosleep nanosleep sleep thrd_sleep usleep
)";

constexpr Text waits = R"(
accept accept4 aio_suspend cnd_timedwait cnd_wait connect epoll_pwait epoll_pwait2 epoll_wait flock getaddrinfo
gethostbyname getnameinfo lockf lockf64 mq_receive mq_send mq_timedreceive mq_timedsend msgrcv msgsnd mtx_timedlock
pause pclose poll popen posix_spawn posix_spawnp ppoll pselect pthread_barrier_wait pthread_cond_clockwait
pthread_cond_timedwait pthread_cond_wait pthread_join pthread_clockjoin_np pthread_mutex_clocklock
pthread_mutex_timedlock pthread_rwlock_clockrdlock pthread_rwlock_clockwrlock pthread_rwlock_timedrdlock
pthread_rwlock_timedwrlock pthread_timedjoin_np recv recvfrom recvmmsg recvmsg select sem_clockwait sem_timedwait
sem_wait semop semtimedop send sendmmsg sendmsg sendto sigsuspend sigtimedwait sigwait sigwaitinfo
std::__atomic_base::wait std::__atomic_futex_unsigned_base::_M_futex_wait_until
std::__atomic_futex_unsigned_base::_M_futex_wait_until_steady std::__atomic_wait_address
std::__atomic_wait_address_bare std::__atomic_wait_address_until std::__atomic_wait_address_v
std::__basic_future::wait std::__basic_future::wait_for std::__basic_future::wait_until
std::__detail::__platform_wait std::__detail::__platform_wait_until std::__detail::__waiter::_M_do_wait
std::__detail::__waiter::_M_do_wait_v std::atomic::wait std::atomic_flag::wait std::barrier::arrive_and_wait
std::barrier::wait std::condition_variable::__wait_until_impl std::condition_variable::wait
std::condition_variable::wait_for std::condition_variable::wait_until std::condition_variable_any::wait
std::condition_variable_any::wait_for std::condition_variable_any::wait_until std::counting_semaphore::acquire
std::counting_semaphore::try_acquire_for std::counting_semaphore::try_acquire_until std::future::get
std::jthread::join std::latch::arrive_and_wait std::latch::wait std::recursive_timed_mutex::try_lock_for
std::recursive_timed_mutex::try_lock_until std::shared_future::get std::shared_timed_mutex::try_lock_for
std::shared_timed_mutex::try_lock_shared_for std::shared_timed_mutex::try_lock_shared_until
std::shared_timed_mutex::try_lock_until std::thread::join std::timed_mutex::try_lock_for
std::timed_mutex::try_lock_until system thrd_join vfork wait wait3 wait4 waitid waitpid
)";

constexpr Text locks = R"(
mtx_lock call_once pthread_mutex_lock pthread_once pthread_rwlock_rdlock pthread_rwlock_wrlock pthread_spin_lock
std::call_once std::lock std::mutex::lock std::recursive_mutex::lock std::recursive_timed_mutex::lock
std::shared_mutex::lock std::shared_mutex::lock_shared std::shared_timed_mutex::lock
std::shared_timed_mutex::lock_shared std::timed_mutex::lock
)";

constexpr Text talks = R"(
access chdir chmod chown close closedir copy_file_range creat creat64 dlclose dlopen dprintf execv execve execvp
faccessat fallocate fchmod fchmodat fchown fclose fcntl fcntl64 fdatasync fdopen fflush fgetc fgetpos fgets fgetwc
fgetws fopen fopen64 fork fprintf fputc fputs fputwc fputws fread fread_unlocked freopen freopen64 fscanf fseek
fseeko fsetpos fstat fstat64 fstatat fstatat64 fstatvfs fsync ftell ftruncate ftruncate64 ftw fwprintf fwrite
fwrite_unlocked getc getchar getcwd getdelim getgrnam getline getpwnam getpwuid getrandom gets getentropy getw getwc
glob ioctl lchown link linkat localtime localtime_r lseek lseek64 lstat lstat64 mkdir mkdirat mkdtemp mkfifo mknod
mkstemp mktime mlock mlockall mmap mmap64 mount mq_open msync munmap nftw open open64 openat openat64 opendir
openlog perror posix_fallocate pread pread64 preadv printf psignal putc putchar puts putw pwrite pwrite64 pwritev
read readdir readdir_r readlink readlinkat readv realpath remove rename renameat renameat2 rewind rewinddir rmdir
scandir scanf sendfile shm_open shm_unlink socket socketpair splice stat stat64 statfs statvfs statx symlink
symlinkat sync sync_file_range syncfs syslog tcdrain tcflush tcgetattr tcsetattr tempnam tmpfile tmpnam truncate
truncate64 tzset umount ungetc unlink unlinkat utime utimensat utimes vdprintf vfprintf vfscanf vprintf vscanf
vsyslog wprintf write writev std::endl std::flush std::getline std::print std::println std::random_device::_M_getval
std::random_device::_M_init std::random_device::operator() std::random_device::random_device std::vprint_nonunicode
std::vprint_unicode
)";
/// All functions of these.
constexpr Text streams = R"(
std::basic_filebuf:: std::basic_fstream:: std::basic_ifstream:: std::basic_istream:: std::basic_ofstream::
std::basic_ostream:: std::basic_iostream:: std::filesystem::
)";
/// For these it depends on what they call.
constexpr Text no_streams = R"(
std::filesystem::path:: std::filesystem::file_status:: std::filesystem::operator std::filesystem::swap
std::filesystem::hash_value std::filesystem::__detail::
)";

constexpr Text allocates = R"(
__builtin_operator_new aligned_alloc asprintf calloc malloc memalign open_memstream
posix_memalign pthread_create pvalloc realloc reallocarray regcomp regexec setenv putenv setlocale strdup strndup
thrd_create unsetenv valloc vasprintf wcsdup std::async std::basic_istringstream::basic_istringstream
std::basic_ostringstream::basic_ostringstream std::basic_regex::basic_regex
std::basic_stringstream::basic_stringstream std::filesystem::path::_M_append std::filesystem::path::_M_concat
std::filesystem::path::operator/= std::jthread::jthread std::make_exception_ptr std::promise::promise
std::regex_match std::regex_replace std::regex_search std::thread::thread std::to_string std::to_wstring
)";

constexpr Text frees = R"(
__builtin_operator_delete free
)";

/// Functions of the operating system that only wake others, and what the C++ library does while a program ends or
/// throws.
constexpr Text harmless = R"(
std::__atomic_notify_address std::__atomic_notify_address_bitwise std::__detail::__platform_notify
std::__detail::__waiter::_M_notify std::atomic_flag::notify_all std::atomic_flag::notify_one std::atomic::notify_all
std::atomic::notify_one std::condition_variable::notify_all std::condition_variable::notify_one std::terminate
)";

constexpr Text containers = R"(
basic_string deque forward_list list map multimap multiset priority_queue queue set stack unordered_map
unordered_multimap unordered_multiset unordered_set vector
)";
constexpr Text grows = R"(
append append_range assign emplace emplace_back emplace_front insert insert_or_assign operator+= operator= push
push_back push_front replace reserve resize shrink_to_fit try_emplace
)";

using Names = std::set<std::string_view>;

Names names_in(Text text) {
  Names out;
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \n");
    if (begin == Text::npos) return out;
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    out.insert(text.substr(0, end));
    text.remove_prefix(end);
  }
}

bool begins(std::string_view name, const Names& list) {
  return std::any_of(list.begin(), list.end(), [&](std::string_view each) { return name.starts_with(each); });
}

using Whys = std::map<std::string_view, std::string_view>;

Whys all_names() {
  Whys out;
  const auto add = [&](Text names, std::string_view why) {
    for (const std::string_view name : names_in(names)) out.emplace(name, why);
  };
  add(sleeps, "sleeps");
  add(waits, "waits");
  add(locks, "locks");
  add(talks, "does input or output");
  add(allocates, "uses the heap");
  add(frees, "frees");
  for (const std::string_view name : {"operator new", "operator new[]"}) out.emplace(name, "uses the heap");
  for (const std::string_view name : {"operator delete", "operator delete[]"}) out.emplace(name, "frees");
  return out;
}

} // namespace

bool is_container(std::string_view name) {
  static const Names known = names_in(containers);
  return name.starts_with("std::") && known.count(name.substr(5)) > 0;
}

bool is_known_harmless(std::string_view name) {
  static const Names known = names_in(harmless);
  return known.count(name) > 0;
}

std::string_view worst_of(std::string_view one, std::string_view other) {
  for (const std::string_view each : {"sleeps", "waits", "locks", "does input or output", "uses the heap", "frees"}) {
    if (one == each || other == each) return each;
  }
  return {};
}

std::string_view why_it_blocks(std::string_view name) {
  static const Whys known = all_names();
  static const Names all_of = names_in(streams), but = names_in(no_streams);
  const auto at = known.find(name);
  if (at != known.end()) return at->second;
  if (begins(name, all_of) && !begins(name, but)) return "does input or output";
  return {};
}

bool grows_container(std::string_view name, bool with_arguments) {
  static const Names growing = names_in(grows);
  if (!name.starts_with("std::")) return false;
  const std::size_t colon = name.find("::", 5);
  if (colon == std::string_view::npos || !is_container(name.substr(0, colon))) return false;
  name.remove_prefix(5);
  const std::string_view container = name.substr(0, colon - 5), method = name.substr(colon - 3);
  const bool is_map = container.find("map") != std::string_view::npos;
  if (method == "operator=" && !with_arguments) return false;
  return growing.count(method) > 0 || (is_map && method == "operator[]") || (with_arguments && method == container);
}

} // namespace director::scanning
