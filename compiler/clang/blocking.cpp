// Door: compiler/clang/blocking.hpp. Test: tests/clang.
#include "compiler/clang/blocking.hpp"

#include <algorithm>
#include <array>

namespace director::scanning {

namespace {

using Names = std::string_view;

constexpr std::array sleeps{Names{"std::this_thread::sleep_for"},
                            Names{"std::this_thread::sleep_until"},
                            Names{"sleep"},
                            Names{"usleep"},
                            Names{"nanosleep"},
                            Names{"clock_nanosleep"}};

constexpr std::array waits{Names{"std::condition_variable::wait"},
                           Names{"std::condition_variable::wait_for"},
                           Names{"std::condition_variable::wait_until"},
                           Names{"std::condition_variable_any::wait"},
                           Names{"std::condition_variable_any::wait_for"},
                           Names{"std::condition_variable_any::wait_until"},
                           Names{"std::thread::join"},
                           Names{"std::jthread::join"},
                           Names{"std::future::get"},
                           Names{"std::future::wait"},
                           Names{"std::future::wait_for"},
                           Names{"std::future::wait_until"},
                           Names{"std::shared_future::get"},
                           Names{"std::shared_future::wait"},
                           Names{"std::__basic_future::wait"},
                           Names{"std::__basic_future::wait_for"},
                           Names{"std::latch::wait"},
                           Names{"std::latch::arrive_and_wait"},
                           Names{"std::barrier::arrive_and_wait"},
                           Names{"std::counting_semaphore::acquire"},
                           Names{"std::__atomic_base::wait"},
                           Names{"std::atomic::wait"},
                           Names{"pthread_join"},
                           Names{"pthread_cond_wait"},
                           Names{"pthread_cond_timedwait"},
                           Names{"sem_wait"},
                           Names{"sem_timedwait"},
                           Names{"poll"},
                           Names{"ppoll"},
                           Names{"select"},
                           Names{"pselect"},
                           Names{"epoll_wait"},
                           Names{"epoll_pwait"},
                           Names{"wait"},
                           Names{"waitpid"},
                           Names{"accept"},
                           Names{"connect"},
                           Names{"recv"},
                           Names{"recvfrom"},
                           Names{"recvmsg"},
                           Names{"send"},
                           Names{"sendto"},
                           Names{"sendmsg"},
                           Names{"system"},
                           Names{"popen"},
                           Names{"getaddrinfo"},
                           Names{"pause"},
                           Names{"sigwait"},
                           Names{"sigsuspend"},
                           Names{"flock"},
                           Names{"lockf"},
                           Names{"mq_receive"},
                           Names{"msgrcv"},
                           Names{"semop"},
                           Names{"pthread_barrier_wait"},
                           Names{"std::atomic_flag::wait"},
                           Names{"std::timed_mutex::try_lock_for"},
                           Names{"std::timed_mutex::try_lock_until"},
                           Names{"std::counting_semaphore::try_acquire_for"},
                           Names{"std::counting_semaphore::try_acquire_until"}};

constexpr std::array locks{Names{"std::mutex::lock"},
                           Names{"std::recursive_mutex::lock"},
                           Names{"std::timed_mutex::lock"},
                           Names{"std::recursive_timed_mutex::lock"},
                           Names{"std::shared_mutex::lock"},
                           Names{"std::shared_mutex::lock_shared"},
                           Names{"std::shared_timed_mutex::lock"},
                           Names{"std::shared_timed_mutex::lock_shared"},
                           Names{"std::lock"},
                           Names{"std::call_once"},
                           Names{"std::unique_lock::lock"},
                           Names{"std::shared_lock::lock"},
                           Names{"pthread_mutex_lock"},
                           Names{"pthread_rwlock_rdlock"},
                           Names{"pthread_rwlock_wrlock"},
                           Names{"pthread_spin_lock"}};
constexpr std::array locking_constructors{Names{"std::lock_guard::lock_guard"}, Names{"std::scoped_lock::scoped_lock"},
                                          Names{"std::unique_lock::unique_lock"},
                                          Names{"std::shared_lock::shared_lock"}};

constexpr std::array talks{
    Names{"open"},         Names{"openat"},     Names{"read"},     Names{"write"},        Names{"pread"},
    Names{"pwrite"},       Names{"fsync"},      Names{"ioctl"},    Names{"fopen"},        Names{"fclose"},
    Names{"fread"},        Names{"fwrite"},     Names{"fflush"},   Names{"fgets"},        Names{"fputs"},
    Names{"fgetc"},        Names{"fputc"},      Names{"getc"},     Names{"putc"},         Names{"getchar"},
    Names{"putchar"},      Names{"gets"},       Names{"puts"},     Names{"printf"},       Names{"fprintf"},
    Names{"vprintf"},      Names{"vfprintf"},   Names{"scanf"},    Names{"fscanf"},       Names{"perror"},
    Names{"syslog"},       Names{"vsyslog"},    Names{"close"},    Names{"creat"},        Names{"unlink"},
    Names{"mkdir"},        Names{"opendir"},    Names{"readdir"},  Names{"ftruncate"},    Names{"fdatasync"},
    Names{"sync"},         Names{"mmap"},       Names{"munmap"},   Names{"msync"},        Names{"fcntl"},
    Names{"tcdrain"},      Names{"socket"},     Names{"fork"},     Names{"std::getline"}, Names{"std::print"},
    Names{"std::println"}, Names{"std::flush"}, Names{"std::endl"}};
constexpr std::array streams{Names{"std::basic_ifstream::"}, Names{"std::basic_ofstream::"},
                             Names{"std::basic_fstream::"},  Names{"std::basic_filebuf::"},
                             Names{"std::basic_ostream::"},  Names{"std::basic_istream::"},
                             Names{"std::filesystem::"}};

constexpr std::array allocates{Names{"malloc"},
                               Names{"calloc"},
                               Names{"realloc"},
                               Names{"aligned_alloc"},
                               Names{"strdup"},
                               Names{"free"},
                               Names{"std::make_unique"},
                               Names{"std::make_shared"},
                               Names{"std::to_string"},
                               Names{"std::allocator::allocate"},
                               Names{"std::async"},
                               Names{"posix_memalign"},
                               Names{"std::stable_sort"},
                               Names{"std::stable_partition"},
                               Names{"std::inplace_merge"},
                               Names{"std::allocate_shared"},
                               Names{"std::unique_ptr::reset"},
                               Names{"std::shared_ptr::reset"},
                               Names{"std::regex_match"},
                               Names{"std::regex_search"},
                               Names{"std::regex_replace"},
                               Names{"operator new"},
                               Names{"operator new[]"},
                               Names{"operator delete"},
                               Names{"operator delete[]"}};
constexpr std::array containers{Names{"vector"},
                                Names{"deque"},
                                Names{"list"},
                                Names{"forward_list"},
                                Names{"map"},
                                Names{"multimap"},
                                Names{"set"},
                                Names{"multiset"},
                                Names{"unordered_map"},
                                Names{"unordered_set"},
                                Names{"basic_string"},
                                Names{"unordered_multimap"},
                                Names{"unordered_multiset"},
                                Names{"queue"},
                                Names{"stack"},
                                Names{"priority_queue"}};
constexpr std::array grows{Names{"push_back"},   Names{"emplace_back"}, Names{"push_front"},  Names{"emplace_front"},
                           Names{"insert"},      Names{"emplace"},      Names{"try_emplace"}, Names{"insert_or_assign"},
                           Names{"resize"},      Names{"reserve"},      Names{"assign"},      Names{"append"},
                           Names{"operator+="},  Names{"operator="},    Names{"push"},        Names{"replace"},
                           Names{"append_range"}};
constexpr std::array with_memory{Names{"std::basic_stringstream::basic_stringstream"},
                                 Names{"std::basic_ostringstream::basic_ostringstream"},
                                 Names{"std::basic_istringstream::basic_istringstream"},
                                 Names{"std::thread::thread"},
                                 Names{"std::jthread::jthread"},
                                 Names{"std::promise::promise"},
                                 Names{"std::basic_regex::basic_regex"}};
/// Only if it is given something that does not fit.
constexpr std::array keeps_memory{Names{"std::shared_ptr::shared_ptr"}, Names{"std::function::function"}};
constexpr std::array lock_tags{Names{"std::defer_lock_t"}, Names{"std::try_to_lock_t"}, Names{"std::adopt_lock_t"}};

bool among(const auto& list, std::string_view name) { return std::find(list.begin(), list.end(), name) != list.end(); }

/// The system's functions have names of their own in C++ too.
std::string_view plain(std::string_view name) {
  const std::string_view rest = name.starts_with("std::") ? name.substr(5) : name;
  return rest.find("::") == std::string_view::npos ? rest : name;
}

/// `std::vector::push_back`, and its constructors from something.
bool grows_container(std::string_view name, bool with_arguments) {
  if (!name.starts_with("std::")) return false;
  name.remove_prefix(5);
  const std::size_t colon = name.find("::");
  if (colon == std::string_view::npos || !among(containers, name.substr(0, colon))) return false;
  const std::string_view method = name.substr(colon + 2);
  const bool is_map = name.find("map") < colon;
  if (method == "operator=" && !with_arguments) return false;
  return among(grows, method) || (is_map && method == "operator[]") ||
         (with_arguments && method == name.substr(0, colon));
}

} // namespace

bool is_container(std::string_view name) { return name.starts_with("std::") && among(containers, name.substr(5)); }

bool only_takes_lock(std::string_view name) { return among(lock_tags, name); }

std::string_view why_it_blocks(std::string_view name, bool with_arguments) {
  if (among(sleeps, name)) return "sleeps";
  if (among(locks, name) || (with_arguments && among(locking_constructors, name))) return "locks";
  if (among(waits, name)) return "waits";
  if (among(talks, name) || among(talks, plain(name)) || name == "std::operator<<" || name == "std::operator>>")
    return "does input or output";
  for (const std::string_view stream : streams) {
    if (name.starts_with(stream)) return "does input or output";
  }
  if (among(allocates, name) || among(allocates, plain(name)) || grows_container(name, with_arguments))
    return "uses the heap";
  if (among(with_memory, name) || (with_arguments && among(keeps_memory, name))) return "uses the heap";
  return {};
}

} // namespace director::scanning
