// SPDX-License-Identifier: MIT
// A state whose values are an enum's, read as the program compiles it.
#include "tests/compiler/clang/workshop.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace {

using namespace director::tests;

void write_game(const Workshop& work) {
  work.write("game.yaml", "behaviour: game\nlanguage: 1\ncpp: {headers: [phase.hpp]}\n"
                          "states:\n  Phase: {type: game::Phase, initial: initial, external: true}\n"
                          "roots: [Play]\ngroups:\n  Play:\n    providers:\n"
                          "      - {name: late, when: [Phase == overtime]}\n      - {name: early}\n");
  work.write("include/phase.hpp",
             "#pragma once\n#include <cstdint>\nnamespace game {\nenum class Phase : std::int8_t {\n  initial,\n"
             "#ifdef WITH_OVERTIME\n  overtime,\n#endif\n};\n}\n");
}

TEST_CASE("a state's values are those that the flags of the program make") {
  const Workshop work("types");
  write_game(work);
  const auto generate = [&](const std::string& flags) {
    work.write("flags", flags);
    return work.directorc({"generate", work.path("game.yaml"), "-o", work.path("out"), "--flags", work.path("flags"),
                           "--depfile", work.path("out.d")});
  };
  const std::string common = "-std=c++20\n-I" + work.path("include") + "\n";
  const Worked with = generate("g++\n" + common + "-DWITH_OVERTIME\n");
  CHECK(with.err == "");
  CHECK(with.status == 0);
  CHECK(read_file(work.path("out.d")).find(work.path("include/phase.hpp")) != std::string::npos);
  const Worked without = generate("g++\n" + common);
  CHECK(without.status == 1);
  CHECK(
      without.err.find("`overtime` is no value of the state `Phase`: its values are initial [value_outside_domain]") !=
      std::string::npos);
  const std::string named = read_file(work.path("game.yaml"));
  work.write("game.yaml", std::string(named).replace(named.find("phase.hpp"), 9, "<phase.hpp>, <array>"));
  const Worked angled = generate("g++\n" + common + "-DWITH_OVERTIME\n");
  CHECK(angled.err == "");
  CHECK(angled.status == 0);
  work.write("game.yaml", named);
  if (std::system("arm-none-eabi-g++ --version >/dev/null 2>&1") != 0) return;
  const Worked arm =
      generate("arm-none-eabi-g++\n-mcpu=cortex-m3\n-mthumb\n-ffreestanding\n" + common + "-DWITH_OVERTIME\n");
  CHECK(arm.err == "");
  CHECK(arm.status == 0);
}

TEST_CASE("what the generated code includes by itself counts for types too, and headers are not needed to check them") {
  const Workshop work("types-std");
  work.write("flags", "g++\n-std=c++20\n-I" + source_folder() + "\n");
  const auto checked = [&](const std::string& data) {
    work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n  Drive: {data: '" + data + "'}\n");
    return work.directorc({"check", work.path("cart.yaml"), "--flags", work.path("flags")});
  };
  CHECK(checked("std::array<int, 3>").out == "");
  work.write("flags", "g++\r\n-std=c++20\r\n-I" + source_folder() + "\r\n");
  CHECK(checked("std::array<int, 3>").out == "");
  CHECK(checked("nowhere::Way").out.find("there is no type `nowhere::Way` in the C++") != std::string::npos);
}

TEST_CASE("what was read of types is kept until the next call, also if one of them is no enum") {
  const Workshop work("types-kept");
  work.write("flags", "g++\n-std=c++20\n-I" + source_folder() + "\n-I" + work.path() + "\n");
  work.write("way.hpp", "#pragma once\nnamespace way {\nenum class Mode { calm, wild };\nstruct Goal { int x; };\n}\n");
  const auto kept_with = [&](const std::string& data) {
    std::filesystem::remove_all(work.path(".director"));
    work.write("cart.yaml", "behaviour: cart\nlanguage: 1\ncpp: {headers: [way.hpp]}\nstates:\n"
                            "  Mode: {type: way::Mode, initial: calm, external: true}\nroots: [Drive]\ngroups:\n"
                            "  Drive: {when: [Mode == calm], data: " +
                                data + "}\n");
    const Worked checked = work.directorc({"check", work.path("cart.yaml"), "--flags", work.path("flags")});
    CAPTURE(checked.out, checked.err);
    CHECK(checked.status == (data == "way::Nobody" ? 1 : 0));
    std::size_t answers = 0;
    if (std::filesystem::exists(work.path(".director"))) {
      for (const auto& file : std::filesystem::directory_iterator(work.path(".director")))
        answers += file.path().extension() == ".json" ? 1 : 0;
    }
    return answers;
  };
  CHECK(kept_with("way::Mode") == 1);
  CHECK(kept_with("way::Goal") == 1);
  CHECK(kept_with("int") == 1);
  CHECK(kept_with("way::Nobody") == 0);
}

TEST_CASE("a type whose template is only defined for some arguments is a type") {
  const Workshop work("types-some");
  work.write("flags", "g++\n-std=c++20\n-I" + source_folder() + "\n-I" + work.path() + "\n");
  work.write("way.hpp", "#pragma once\n#include <functional>\nnamespace way {\ntemplate <class> class Call;\n"
                        "template <class R, class... A> class Call<R(A...)> {};\ntemplate <> class Call<int>;\n"
                        "template <class T> struct Action { struct Goal { T t; }; struct Later; };\n"
                        "using Goal = Action<int>::Goal;\n}\n");
  const auto checked = [&](const std::string& data) {
    work.write("cart.yaml", "behaviour: cart\nlanguage: 1\ncpp: {headers: [way.hpp]}\nroots: [Drive]\ngroups:\n"
                            "  Drive: {data: '" +
                                data + "'}\n");
    return work.directorc({"check", work.path("cart.yaml"), "--flags", work.path("flags")}).out;
  };
  CHECK(checked("std::function<void(int)>") == "");
  CHECK(checked("way::Call<void(int)>") == "");
  CHECK(checked("way::Action<int>::Goal") == "");
  CHECK(checked("way::Goal") == "");
  CHECK(checked("way::Action<int>::Later").find("`way::Action<int>::Later` is declared and not defined") !=
        std::string::npos);
  CHECK(checked("way::Call<int>").find("`way::Call<int>` is declared and not defined") != std::string::npos);
}

TEST_CASE("a type that cannot be stored by value is no type of data, whatever it is called") {
  const Workshop work("types-forms");
  work.write("flags", "g++\n-std=c++20\n-I" + source_folder() + "\n-I" + work.path() + "\n");
  work.write("way.hpp", "#pragma once\nnamespace way {\nusing Ref = int&; using Moved = int&&; using Array = int[3]; "
                        "using Call = int(int); using None = void; using Fixed = const int; using Port = volatile int; "
                        "struct Base { virtual void act() = 0; }; using Pointer = Base*; using Entry = int (*)(int);\n"
                        "template <class T> struct Some { virtual void act() = 0; }; using Open = Some<int>;\n}\n");
  const auto checked = [&](const std::string& data) {
    work.write("cart.yaml", "behaviour: cart\nlanguage: 1\ncpp: {headers: [way.hpp]}\nroots: [Drive]\ngroups:\n"
                            "  Drive: {data: 'way::" +
                                data + "'}\n");
    const std::string out = work.directorc({"check", work.path("cart.yaml"), "--flags", work.path("flags")}).out;
    const std::size_t begin = out.find("` is "), end = out.find(", which no task can carry");
    return begin == std::string::npos || end == std::string::npos ? out : out.substr(begin + 5, end - begin - 5);
  };
  CHECK(checked("Ref") == "a reference");
  CHECK(checked("Moved") == "a reference");
  CHECK(checked("Array") == "an array");
  CHECK(checked("Call") == "a function type");
  CHECK(checked("None") == "`void`");
  CHECK(checked("Fixed") == "`const`");
  CHECK(checked("Port") == "`volatile`");
  CHECK(checked("Base") == "an abstract class");
  CHECK(checked("Pointer") == "");
  CHECK(checked("Entry") == "");
  CHECK(checked("Open") == ""); // not instantiated
}

TEST_CASE("an enum without values, or one that two states name, is no type of a state") {
  const Workshop work("types-odd");
  work.write("flags", "g++\n-std=c++20\n-I" + work.path("include") + "\n");
  const auto checked = [&](const std::string& states) {
    work.write("odd.yaml", "behaviour: odd\nlanguage: 1\ncpp: {headers: [odd.hpp]}\nstates:\n" + states +
                               "roots: [Play]\ngroups:\n  Play: {}\n");
    return work.directorc({"check", work.path("odd.yaml"), "--flags", work.path("flags")}).out;
  };
  work.write("include/odd.hpp", "#pragma once\nnamespace odd_types {\nenum class Empty {};\nenum class Later : int;\n"
                                "enum class Phase { one, two };\nusing Other = Phase;\n}\n");
  CHECK(checked("  S: {type: odd_types::Empty, external: true}\n")
            .find("`odd_types::Empty` is an enum without values "
                  "[unknown_type]") != std::string::npos);
  CHECK(checked("  S: {type: odd_types::Later, external: true}\n")
            .find("`odd_types::Later` is declared and not defined, so its values are not known [unknown_type]") !=
        std::string::npos);
  CHECK(checked("  S: {type: odd_types::Phase, external: true}\n  T: {type: odd_types::Other, external: true}\n")
            .find("the states `S` and `T` have one type, `odd_types::Other`, which `odd_types::Phase` names too "
                  "[redefined_name]") != std::string::npos);
  work.write("include/odd.hpp", "#pragma once\n#include \"enum.hpp\"\n");
  const std::string lacking = checked("  S: {type: odd_types::Phase, external: true}\n");
  CHECK(lacking.find("the values of `odd_types::Phase` are not known here: Clang does not understand the headers: ") !=
        std::string::npos);
  CHECK(lacking.find("include/odd.hpp:2:10: 'enum.hpp' file not found") != std::string::npos);
}

/// Detects whether a file is opened during its lifetime.
class Guarded {
public:
  explicit Guarded(const std::string& path) {
    REQUIRE(events_ >= 0);
    REQUIRE(::inotify_add_watch(events_, path.c_str(), IN_OPEN) >= 0);
  }
  ~Guarded() { ::close(events_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;
  bool was_opened() const {
    inotify_event event{};
    return ::read(events_, &event, sizeof event) > 0;
  }

private:
  int events_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
};

TEST_CASE("a header that is a pipe is reported and not opened, also if another header includes it") {
  const Workshop work("types-pipe");
  write_game(work);
  std::filesystem::remove(work.path("include/phase.hpp"));
  REQUIRE(::mkfifo(work.path("include/phase.hpp").c_str(), 0600) == 0);
  work.write_commands({work.path("main.cpp")}, {"-std=c++20", "-I" + work.path("include")});
  const Guarded pipe(work.path("include/phase.hpp"));
  const Worked direct = work.directorc({"check", "--format=json", "-p", work.path(), work.path("game.yaml")});
  CHECK(direct.status == 1);
  CHECK(direct.out.find("\"message\": \"`phase.hpp` cannot be read: it is a pipe, and no ordinary file\"") !=
        std::string::npos);
  CHECK(
      direct.out.find("\"message\": \"the values of `game::Phase` are not known here: the header `phase.hpp` cannot be "
                      "read: it is a pipe, and no ordinary file\"") != std::string::npos);
  std::filesystem::rename(work.path("include/phase.hpp"), work.path("include/inner.hpp"));
  work.write("include/phase.hpp",
             "#include \"inner.hpp\"\nnamespace game { enum class Phase { initial, overtime }; }\n");
  const Worked within = work.directorc({"check", "-p", work.path(), work.path("game.yaml")});
  CHECK(within.status == 0); // the header's own content is known
  CHECK_FALSE(pipe.was_opened());
}

/// As C and C++ have it, in two headers with blanks in their path; the second one is included by the first.
constexpr const char* enums = "#pragma once\n#include \"deep/base.hpp\"\n"
                              R"(namespace game {
typedef enum { fresh, stale } OfC;
enum Gap { left, middle = 5, right };
enum class Tiny : unsigned char { low = 200, high };
enum class Wide : unsigned long long { small = 0, same = 0x100000000, huge = 0xFFFFFFFFFF };
enum class Signed : int { minus = -3, zero, plus = 3 };
using Renamed = Tiny;
struct Outer {
  enum class Inner { in, out };
  using Alias = Inner;
};
template <class T>
struct Holder {
  enum class Kind { one, two };
};
using Held = Holder<long>;
using HeldKind = Held::Kind;
inline namespace v2 { enum class Versioned { older, newer }; }
namespace { enum class Hidden { seen, unseen }; }
enum class Twice { first, second, again = first };
}
using Short = game::Outer::Inner;
extern "C" { enum c_enum { C_ONE, C_TWO }; }
)";

struct Named {
  const char *type, *value;
};
constexpr Named types[] = {
    {"game::OfC", "stale"},       {"game::Gap", "right"},        {"game::Tiny", "high"},
    {"game::Wide", "same"},       {"game::Signed", "minus"},     {"game::Renamed", "low"},
    {"game::Outer::Inner", "in"}, {"game::Outer::Alias", "out"}, {"game::Holder<int>::Kind", "two"},
    {"game::HeldKind", "one"},    {"game::Versioned", "newer"},  {"game::v2::Versioned", "older"},
    {"game::Hidden", "seen"},     {"game::Beside", "near"},      {"Short", "in"},
    {"::game::Tiny", "low"},      {"c_enum", "C_TWO"},
};

/// The findings of a behaviour that waits for this value of this type.
std::string said_of(const Workshop& work, const Named& named) {
  work.write("game.yaml",
             std::string("behaviour: play\nlanguage: 1\ncpp: {headers: [enums.hpp]}\nstates:\n  S: {type: \"") +
                 named.type + "\", external: true}\nroots: [P]\ngroups:\n  P: {when: [S == " + named.value +
                 "]}\nallow: [uncovered_state]\nbecause: it is about types\n");
  const Worked checked = work.directorc({"check", work.path("game.yaml"), "-p", work.path()});
  const std::string all = checked.out + checked.err;
  const std::size_t at = all.find("error: ");
  return at == std::string::npos ? std::to_string(checked.status) : all.substr(at + 7, all.find('\n', at) - at - 7);
}

TEST_CASE("an enum is found however it is named, with flags that only g++ knows and in one of several commands") {
  const Workshop work("types of all kinds");
  work.write("inc dir/enums.hpp", enums);
  work.write("inc dir/deep/base.hpp",
             "#pragma once\nnamespace game { enum class Beside { near [[maybe_unused]], far }; }\n");
  work.write("flags.rsp", "-DFROM_A_FILE -fanalyzer");
  work.write("main.cpp", "");
  const std::string entry = "{\"directory\": \"" + work.path() + "\", \"file\": \"main.cpp\", ";
  work.write("compile_commands.json",
             "[" + entry + "\"command\": \"g++ -std=c++20 -fno-such -Iother -c main.cpp\"},\n" + entry +
                 R"("arguments": ["g++", "-std=c++20", "-fmax-errors=3", "-Winvalid-imported-macros", "-fno-ipa-icf",)"
                 R"( "-I", "inc dir", "@flags.rsp", "-c", "main.cpp", "-o", "main.o"]}])");
  for (const Named& named : types) {
    CAPTURE(named.type);
    CHECK(said_of(work, named) == "0");
  }
  CHECK(said_of(work, {"game::Nobody", "low"}) ==
        "there is no type `game::Nobody` in the C++: no type named 'Nobody' in namespace 'game' [unknown_type]");
  CHECK(said_of(work, {"game::Outer", "low"}) == "`game::Outer` is no enum [unknown_type]");
  CHECK(said_of(work, {"game::Tiny", "lower"}) ==
        "`lower` is no value of the state `S`: its values are low, high [value_outside_domain]");
  CHECK(said_of(work, {"game::Twice", "first"}) ==
        "`first` and `again` of `game::Twice` are one value, so they cannot be two values of `S` [redefined_name]");
}

} // namespace
