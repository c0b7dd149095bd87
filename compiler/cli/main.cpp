// Header: the command line. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/parse.hpp"
#include "compiler/cli/system/wrapping.hpp"
#include "compiler/facts/scanner.hpp"
#include "dsl/source/harmless.hpp"

#include <fcntl.h>
#include <sys/auxv.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <tuple>
#include <type_traits>

namespace {

using namespace director;
using namespace director::compiler;
using namespace director::compiler::cli;

/// Whether it is a terminal that supports more than text.
bool is_screen(int stream) {
  const char* const terminal = std::getenv("TERM");
  return ::isatty(stream) == 1 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

bool wants_colours(int stream) {
  const char* const no_colour = std::getenv("NO_COLOR");
  return (no_colour == nullptr || *no_colour == '\0') && is_screen(stream);
}

/// Columns of a terminal, with a minimum; 0: it is none.
std::size_t width_of(int stream) {
  constexpr std::size_t least = 20, usual = 80;
  if (::isatty(stream) != 1) return 0;
  winsize size{};
  if (::ioctl(stream, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return std::max<std::size_t>(size.ws_col, least);
}

/// The path of this program; in a root without /proc, as it was called.
std::string own_path() {
  std::error_code unknown;
  const std::string path = std::filesystem::read_symlink("/proc/self/exe", unknown).string();
  if (!path.empty()) return path;
  const auto* const called = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  return called == nullptr ? "" : called;
}

std::string scanner() {
  const char* const chosen = std::getenv("DIRECTOR_CLANG");
  return find_scanner(own_path(), chosen ? chosen : "");
}

/// Whether it prints sentences, and no file or code.
template <class Command>
bool prints_prose(const Command& command) {
  if constexpr (requires { command.format; }) return command.format == Format::text;
  return std::is_same_v<Command, Explore>;
}

/// Wraps long lines between words during its lifetime; not with `width` 0.
class Wrapped {
public:
  Wrapped(std::ostream& stream, std::size_t width)
      : stream_(stream),
        terminal_(*stream.rdbuf()),
        buffer_(terminal_, width) {
    if (width != 0) stream_.rdbuf(&buffer_);
  }
  ~Wrapped() {
    stream_.flush();
    stream_.rdbuf(&terminal_);
  }
  Wrapped(const Wrapped&) = delete;
  Wrapped& operator=(const Wrapped&) = delete;

private:
  std::ostream& stream_;
  std::streambuf& terminal_;
  WrappingBuffer buffer_;
};

/// A file that is opened must not become a missing standard stream: printing must fail then.
void fill_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1) std::ignore = ::open("/dev/null", O_RDONLY);
}

/// Only on a terminal, so that the program does not seem to hang.
void print_waiting(const std::string& path, std::chrono::milliseconds longest) {
  if (::isatty(STDERR_FILENO) != 1) return;
  std::cerr << "directorc: nothing comes from `" << dsl::harmless(path) << "` yet: waiting for it, "
            << std::chrono::ceil<std::chrono::seconds>(longest).count() << " s at most\n"
            << std::flush;
}

} // namespace

int main(int count, char** words) {
  fill_streams();
  std::signal(SIGXFSZ, SIG_IGN); // writing beyond a limit of file sizes fails then, and is reported
  try {
    dsl::DiskFiles files(std::chrono::seconds(10), print_waiting);
    DiskOutputs outputs;
    ChildPrograms programs;
    const Request request = parse({words + (count > 0 ? 1 : 0), words + count}, find_schemas(own_path()));
    const std::size_t out_width = width_of(STDOUT_FILENO), err_width = width_of(STDERR_FILENO);
    const bool is_prose = std::visit([](const auto& command) { return prints_prose(command); }, request);
    const Wrapped out(std::cout, is_prose ? out_width : 0), err(std::cerr, err_width);
    Console console{std::cout,
                    std::cerr,
                    wants_colours(STDOUT_FILENO),
                    wants_colours(STDERR_FILENO),
                    files,
                    outputs,
                    programs,
                    scanner(),
                    find_headers(own_path()),
                    out_width,
                    err_width,
                    is_screen(STDOUT_FILENO)};
    const int status = std::visit([&](const auto& command) { return run(command, console); }, request);
    std::cout.flush();
    if (!std::cout) std::cerr << "directorc: the output cannot be written\n";
    std::cerr.flush();
    // Output that could not be printed counts as not done.
    return std::cout && std::cerr ? status : misused;
  } catch (const std::bad_alloc&) {
    std::cerr << "directorc: the memory is used up\n";
    return misused;
  } catch (const std::exception& error) {
    std::cerr << "directorc: internal error: " << error.what() << "\n";
    return 70;
  }
}
