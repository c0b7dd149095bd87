// SPDX-License-Identifier: MIT
// `directorc stubs` on realistic programs, with director-clang and the real generated header.
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace director::tests;
namespace fs = std::filesystem;

namespace {

const std::string yaml = R"(behaviour: cart
language: 1
states:
  Motion: {values: [still, moving], initial: still}
roots: [Drive]
groups:
  Drive:
    module: wheels
    stop: true
    providers:
      - {name: rolling, sets: [Motion == moving]}
      - name: braking
        doc: Until it stands.
        causing: [Motion == still within 2 s]
)";

/// A folder with a behaviour and a program. Tests run side by side, each in a process of its own.
class Workshop {
public:
  Workshop() : folder_(fs::canonical(binary_dir()) / ("tests/stubs-command-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("cart.yaml", yaml);
    write(".clang-format", "DisableFormat: true\n"); // not the project's own
    write("compile_commands.json", "[]");            // nor that of the build around it
  }
  ~Workshop() { fs::remove_all(folder_); }
  std::string folder() const { return folder_.string(); }

  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path, std::ios::binary) << text;
  }
  std::string text(const std::string& path) const { return read_file(folder_ / path); }

  /// Both streams, and the status in the last line if it is not 0. `runtime`: how its headers are found.
  std::string stubs(const std::string& options = "",
                    const std::string& runtime = "-I '" + source_dir().string() + "'") const {
    const std::string line = "{ cd '" + folder_.string() + "' && '" + (binary_dir() / "bin/directorc").string() +
                             "' stubs cart.yaml -o src " + runtime + " " + options + "; } 2>&1";
    std::FILE* pipe = ::popen(line.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), count);
    const int status = ::pclose(pipe);
    if (WEXITSTATUS(status) != 0) out += "status " + std::to_string(WEXITSTATUS(status)) + "\n";
    return out;
  }

private:
  fs::path folder_;
};

const std::string decl_stop = "void stop(cart::Drive::Stop& run) override;";
const std::string decl_rolling = "director::Outcome provide(cart::Drive::Rolling& run) override;";
const std::string decl_braking = "director::Outcome provide(cart::Drive::Braking& run) override;";

/// The definition that is missing in most programs of these tests.
std::string braking(const std::string& head, const std::string& indent = "", const std::string& end = "\n") {
  return indent + "/// Until it stands. (cart.yaml:12)" + end + indent + "/// - causing: Motion == still within 2 s" +
         end + indent + head + " {" + end + indent + (indent.find('\t') != std::string::npos ? "\t" : "  ") +
         "return run.keep(); // does nothing yet" + end + indent + "}";
}

} // namespace

TEST_CASE("the headers of the runtime are found relative to directorc, in a build tree too") {
  const Workshop work;
  CHECK(work.stubs("", "") == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  CHECK(work.stubs("--check", "") == "");
}

TEST_CASE("a source that the build does not list takes no flags from a file of C beside it") {
  const Workshop shop;
  CHECK(shop.stubs() == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  shop.write("compile_commands.json", R"([{"directory": ")" + shop.folder() +
                                          R"(", "file": "src/hal.c", "command": "gcc -c src/hal.c"},)" +
                                          R"({"directory": ")" + shop.folder() +
                                          R"(", "file": "main.cpp", "command": "g++ -std=c++20 -c main.cpp"}])");
  CHECK(shop.stubs("--check") == "");
}

TEST_CASE("what is generated, read as C++17, is reported as not understood") {
  const Workshop shop;
  CHECK(shop.stubs() == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  const std::string generate = "cd '" + shop.folder() + "' && '" + (binary_dir() / "bin/directorc").string() +
                               "' generate cart.yaml -o src/generated > /dev/null 2>&1";
  REQUIRE(std::system(generate.c_str()) == 0);
  shop.write("compile_commands.json", R"([{"directory": ")" + shop.folder() +
                                          R"(", "file": "main.cpp", "command": "g++ -std=c++17 -c main.cpp"}])");
  CHECK(shop.stubs("--check").ends_with("directorc: nothing is written: this C++ cannot be read\nstatus 1\n"));
}

TEST_CASE("what was generated beside the sources may be of an earlier version of the behaviour") {
  const Workshop shop;
  CHECK(shop.stubs() == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  const std::string generate = "cd '" + shop.folder() + "' && '" + (binary_dir() / "bin/directorc").string() +
                               "' generate cart.yaml -o src > /dev/null 2>&1";
  REQUIRE(std::system(generate.c_str()) == 0);
  shop.write("cart.yaml", yaml + "      - {name: coasting}\n");
  CHECK(shop.stubs() == "added to: src/wheels.cpp\nadded to: src/wheels.hpp\n");
  CHECK(shop.text("src/wheels.cpp").find("Drive::Coasting& run)") != std::string::npos);
  CHECK(shop.stubs("--check") == "");
}

TEST_CASE("what is there is left alone, however often stubs are requested") {
  const Workshop shop;
  CHECK(shop.stubs() == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  CHECK(shop.stubs("--check") == "");
  CHECK(shop.stubs("--main") == "new: src/main.cpp\n");
}

TEST_CASE("a new provider is declared and defined behind the one before it") {
  const Workshop shop;
  const std::string header = "#pragma once\n#include \"cart.hpp\"\n\nnamespace robot {\nusing director::Outcome;\n\n"
                             "/* two classes in one file */\nclass Other { public: void stop(int) {} };\n\n"
                             "class Wheels final : public cart::Wheels {\npublic:\n    " +
                             decl_stop +
                             "\n    Outcome provide(cart::Drive::Rolling& run) override; // rolls\n\n"
                             "private:\n    int speed_ = 0;\n};\n\n} // namespace robot\n";
  const std::string source =
      "#include \"wheels.hpp\"\n\nvoid robot::Wheels::stop(cart::Drive::Stop&) { speed_ = 0; }\n\n"
      "namespace robot {\n\nOutcome Wheels::provide(cart::Drive::Rolling& run) {\n  return run.keep();\n} // "
      "rolling\n\n}\n";
  shop.write("src/wheels.hpp", header);
  shop.write("src/deep/wheels.cpp", source);
  shop.write("src/deep/wheels.hpp", "#include \"../wheels.hpp\"\n");
  CHECK(shop.stubs() == "added to: src/deep/wheels.cpp\nadded to: src/wheels.hpp\n");
  std::string expected = header;
  expected.insert(expected.find("// rolls") + 8, "\n    Outcome provide(cart::Drive::Braking& run) override;");
  CHECK(shop.text("src/wheels.hpp") == expected);
  expected = source;
  expected.insert(expected.find("// rolling") + 10,
                  "\n\n" + braking("Outcome Wheels::provide(cart::Drive::Braking& run)"));
  CHECK(shop.text("src/deep/wheels.cpp") == expected);
  CHECK(shop.stubs() == "");
}

TEST_CASE("carriage returns, tabs, a byte order mark, other encodings and a missing last line break stay") {
  const Workshop shop;
  const std::string header = "\xEF\xBB\xBF#pragma once\r\n#include \"cart.hpp\"\r\n// gr\xFC\xDF dich\r\nstruct Wheels "
                             ": cart::Wheels {\r\n\t" +
                             decl_stop + "\r\n\t" + decl_rolling + "\r\n};";
  const std::string source = "#include \"wheels.hpp\"\n\tvoid Wheels::stop(cart::Drive::Stop&) {}\n\t"
                             "director::Outcome Wheels::provide(cart::Drive::Rolling& r) { return r.keep(); } // \xFC";
  shop.write("src/wheels.hpp", header);
  shop.write("src/wheels.cpp", source);
  CHECK(shop.stubs() == "added to: src/wheels.cpp\nadded to: src/wheels.hpp\n");
  std::string expected = header;
  expected.insert(expected.find(decl_rolling) + decl_rolling.size(), "\r\n\t" + decl_braking);
  CHECK(shop.text("src/wheels.hpp") == expected);
  CHECK(shop.text("src/wheels.cpp") ==
        source + "\n\n" + braking("director::Outcome Wheels::provide(cart::Drive::Braking& run)", "\t"));
}

TEST_CASE("a class whose functions are all within it, or that is a template, gets the next one there too") {
  for (const std::string opening : {"", "template <class Robot>\n"}) {
    const Workshop shop;
    const std::string header = "#pragma once\n#include \"cart.hpp\"\nnamespace {\n" + opening +
                               "class Wheels : public cart::Wheels {\n  void stop(cart::Drive::Stop&) override {}\n"
                               "#if 0\n  void start(cart::Drive::Start&) { {\n#endif\n};\n}\n";
    shop.write("src/wheels.hpp", header);
    CHECK(shop.stubs() == "added to: src/wheels.hpp\n");
    std::string expected = header;
    const std::string rolling =
        "\n  /// (cart.yaml:11)\n  /// - sets: Motion == moving\n  director::Outcome "
        "provide(cart::Drive::Rolling& run) override {\n    return run.keep(); // does nothing yet\n  }";
    expected.insert(expected.find("override {}") + 11,
                    rolling + "\n" +
                        "  /// Until it stands. (cart.yaml:12)\n  /// - causing: Motion == still within 2 s\n  "
                        "director::Outcome provide(cart::Drive::Braking& run) override {\n    return run.keep(); // "
                        "does nothing yet\n  }");
    CHECK(shop.text("src/wheels.hpp") == expected);
  }
}

TEST_CASE("an empty class gets its functions at its end") {
  const Workshop shop;
  shop.write("src/wheels.cpp", "#include \"cart.hpp\"\nclass Wheels : public cart::Wheels {};\n");
  CHECK(shop.stubs() == "added to: src/wheels.cpp\n");
  const std::string text = shop.text("src/wheels.cpp");
  CHECK(
      text.starts_with("#include \"cart.hpp\"\nclass Wheels : public cart::Wheels {\npublic:\n  /// (cart.yaml:9)\n"));
  CHECK(text.ends_with("\n  }\n};\n"));
  CHECK(shop.stubs() == "");
}

TEST_CASE("the files of CUDA, and those with the endings that the C++ library has for templates, are the user's") {
  for (const std::string name : {"src/wheels.cu", "src/wheels.cuh", "src/wheels.tcc", "src/wheels.txx"}) {
    CAPTURE(name);
    const Workshop shop;
    shop.write(name, "#include \"cart.hpp\"\nclass Wheels : public cart::Wheels {};\n");
    CHECK(shop.stubs() == "added to: " + name + "\n");
    CHECK(shop.stubs() == "");
  }
}

TEST_CASE("what is only declared is defined in the source beside it, which may be new") {
  const Workshop shop;
  shop.write("src/parts.hpp",
             "#pragma once\n#include \"cart.hpp\"\nnamespace my { struct Wheels final : cart::Wheels {\n  " +
                 decl_stop + "\n  " + decl_rolling + "\n  " + decl_braking + "\n}; }\n");
  CHECK(shop.stubs() == "new: src/parts.cpp\n");
  CHECK(shop.text("src/parts.cpp").starts_with("#include \"parts.hpp\"\n\n/// (cart.yaml:9)\nvoid my::Wheels::stop("));
  CHECK(shop.stubs() == "");
}

TEST_CASE("classes made by macros are found, and what cannot be added is reported") {
  const Workshop shop;
  shop.write("src/wheels.hpp",
             "#pragma once\n#include \"cart.hpp\"\n#define STOP void stop(cart::Drive::Stop&) override {}\n"
             "#define WHEELS class Wheels final : public cart::Wheels { public: STOP };\nWHEELS\n");
  CHECK(shop.stubs() == "src/wheels.hpp:5:1: error: `Outcome provide(cart::Drive::Braking& run)` of `Wheels` is "
                        "missing and cannot be added: the class ends in a macro\n"
                        "src/wheels.hpp:5:1: error: `Outcome provide(cart::Drive::Rolling& run)` of `Wheels` is "
                        "missing and cannot be added: the class ends in a macro\n"
                        "status 1\n");
}

TEST_CASE("a base class of the user's counts, and only the last class gets what is missing") {
  const Workshop shop;
  const std::string header = "#pragma once\n#include \"cart.hpp\"\nstruct Some : cart::Wheels {\n  void "
                             "stop(cart::Drive::Stop&) override {}\n};\n"
                             "struct Rest final : Some {\n  director::Outcome provide(cart::Drive::Rolling& run) "
                             "override { return run.keep(); }\n};\n";
  shop.write("src/wheels.hpp", header);
  CHECK(shop.stubs() == "added to: src/wheels.hpp\n");
  std::string expected = header;
  expected.insert(expected.rfind("\n};"),
                  "\n" + braking("director::Outcome provide(cart::Drive::Braking& run) override", "  "));
  CHECK(shop.text("src/wheels.hpp") == expected);
}

TEST_CASE("what two mixins of one module have together, the class that joins them has, wherever it is") {
  const Workshop shop;
  shop.write("src/parts.hpp",
             "#pragma once\n#include \"cart.hpp\"\nstruct Rolls : virtual cart::Wheels {\n"
             "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n};\n"
             "struct Brakes : virtual cart::Wheels {\n"
             "  director::Outcome provide(cart::Drive::Braking& run) override { return run.keep(); }\n};\n");
  const std::string both = "#pragma once\n#include \"parts.hpp\"\nstruct Both final : Rolls, Brakes {\n};\n";
  shop.write("src/both.hpp", both);
  shop.write("src/main.cpp", "#include \"both.hpp\"\nint main() {}\n");
  CHECK(shop.stubs() == "added to: src/both.hpp\n");
  std::string expected = both;
  expected.insert(expected.rfind("};"), "  /// (cart.yaml:9)\n  void stop(cart::Drive::Stop& run) override {\n"
                                        "    static_cast<void>(run); // does nothing yet\n  }\n");
  CHECK(shop.text("src/both.hpp") == expected);
  CHECK(shop.stubs("--check").empty());
}

TEST_CASE("a template whose base is a parameter has bodies of every module that it is derived from") {
  const Workshop shop;
  shop.write("src/wheels.hpp",
             "#pragma once\n#include \"cart.hpp\"\ntemplate <class I> struct WithBrakes : I {\n"
             "  director::Outcome provide(cart::Drive::Braking& run) override { return run.keep(); }\n"
             "  void stop(cart::Drive::Stop&) override {}\n};\n"
             "struct Mine final : WithBrakes<cart::Wheels> {\n"
             "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n};\n");
  CHECK(shop.stubs("--check").empty());
}

TEST_CASE("a class with the name of the behaviour's namespace around it gets names from outside of all namespaces") {
  const Workshop shop;
  const std::string head = "#include \"cart.hpp\"\nnamespace robot::cart { struct Part {}; }\nnamespace robot {\n"
                           "extern \"C++\" {\nstruct Wheels : ::cart::Wheels {\n"
                           "  void stop(::cart::Drive::Stop&) override {}\n"
                           "  director::Outcome provide(::cart::Drive::Rolling& run) override { return run.keep(); }\n",
                    tail = "};\n}\n}\n";
  shop.write("src/wheels.cpp", head + tail);
  CHECK(shop.stubs() == "added to: src/wheels.cpp\n");
  CHECK(shop.text("src/wheels.cpp") ==
        head + braking("director::Outcome provide(::cart::Drive::Braking& run) override", "  ") + "\n" + tail);
  CHECK(shop.stubs("--check") == "");
}

TEST_CASE("base classes of one name are told apart") {
  const Workshop shop;
  const std::string all = "  void stop(cart::Drive::Stop&) override {}\n"
                          "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n"
                          "  director::Outcome provide(cart::Drive::Braking& run) override { return run.keep(); }\n",
                    some = all.substr(0, all.rfind("  director")), open = "#include \"cart.hpp\"\nnamespace {\n",
                    base = "struct Base : cart::Wheels {\n", last = "};\nstruct ", close = " final : Base {\n};\n}\n";
  shop.write("src/fake.cpp", open + base + all + last + "Fake" + close);
  shop.write("src/wheels.cpp", open + base + some + last + "Wheels" + close);
  CHECK(shop.stubs() == "added to: src/wheels.cpp\n");
  std::string expected = open + base + some + last + "Wheels" + close;
  expected.insert(expected.rfind("};"),
                  braking("director::Outcome provide(cart::Drive::Braking& run) override", "  ") + "\n");
  CHECK(shop.text("src/wheels.cpp") == expected);
}

TEST_CASE("classes of one name under an #if and its #else have the same definitions") {
  const Workshop shop;
  const std::string declared =
      "class Wheels : public cart::Wheels {\npublic:\n  " + decl_stop + "\n  " + decl_rolling + "\n";
  const std::string header = "#pragma once\n#include \"cart.hpp\"\n#ifdef SIM\n" + declared +
                             "  int sim;\n};\n#else\n" + declared + "  int real;\n};\n#endif\n";
  const std::string source = "#include \"wheels.hpp\"\nvoid Wheels::stop(cart::Drive::Stop&) {}\n"
                             "director::Outcome Wheels::provide(cart::Drive::Rolling& run) { return run.keep(); }\n";
  shop.write("src/wheels.hpp", header);
  shop.write("src/wheels.cpp", source);
  shop.write("src/main.cpp", "#define SIM\n#include \"wheels.hpp\"\nint main() { cart::Behaviour* run; }\n");
  CHECK(shop.stubs() == "added to: src/wheels.cpp\nadded to: src/wheels.hpp\n");
  CHECK(shop.text("src/wheels.cpp") ==
        source + "\n" + braking("director::Outcome Wheels::provide(cart::Drive::Braking& run)") + "\n");
  std::string expected = header;
  for (const char* const member : {"\n  int sim", "\n  int real"})
    expected.insert(expected.find(member), "\n  " + decl_braking);
  CHECK(shop.text("src/wheels.hpp") == expected);
  CHECK(shop.stubs("--check") == "");
}

TEST_CASE("a class that another one of its name is derived from elsewhere gets what is missing") {
  const Workshop shop;
  const std::string wheels = "#include \"cart.hpp\"\nnamespace {\nstruct Wheels : cart::Wheels {\n"
                             "  void stop(cart::Drive::Stop&) override {}\n"
                             "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n";
  const std::string body = braking("director::Outcome provide(cart::Drive::Braking& run) override", "  ") + "\n";
  shop.write("src/fake.cpp", wheels + body + "};\nstruct Fake final : Wheels {};\n}\n");
  shop.write("src/wheels.cpp", wheels + "};\n}\n");
  CHECK(shop.stubs() == "added to: src/wheels.cpp\n");
  CHECK(shop.text("src/wheels.cpp") == wheels + body + "};\n}\n");
}

TEST_CASE("a template that is instantiated explicitly gets what is missing where its text is") {
  const std::string head = "#include \"cart.hpp\"\ntemplate <int N> class WheelsT : public cart::Wheels {\npublic:\n"
                           "  void stop(cart::Drive::Stop& run) override;\n"
                           "  director::Outcome provide(cart::Drive::Rolling& run) override;\n",
                    tail = "  int x[N];\n};\n",
                    bodies = "template <int N> void WheelsT<N>::stop(cart::Drive::Stop&) {}\n"
                             "template <int N> director::Outcome WheelsT<N>::provide(cart::Drive::Rolling& run) {\n"
                             "  return run.keep();\n}\n";
  const std::string added = braking("director::Outcome provide(cart::Drive::Braking& run) override", "  ") + "\n";
  for (const std::string instance : {"template class WheelsT<3>;\n", "extern template class WheelsT<3>;\n"}) {
    for (const bool is_first : {false, true}) {
      const Workshop shop;
      const std::string rest = is_first ? instance + bodies : bodies + instance;
      shop.write("src/wheels.cpp", head + tail + rest);
      CHECK(shop.stubs("--check") == "to be added to: src/wheels.cpp\nstatus 1\n");
      CHECK(shop.stubs() == "added to: src/wheels.cpp\n");
      CHECK(shop.text("src/wheels.cpp") == head + added + tail + rest);
    }
  }
}

TEST_CASE("a template whose base is a parameter and that is instantiated explicitly gets what is missing") {
  const Workshop shop;
  const std::string head = "#pragma once\n#include \"cart.hpp\"\ntemplate <class I> struct WheelsT : I {\n"
                           "  void stop(cart::Drive::Stop&) override {}\n"
                           "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n",
                    tail = "};\ntemplate struct WheelsT<cart::Wheels>;\n";
  shop.write("src/wheels.hpp", head + tail);
  CHECK(shop.stubs() == "added to: src/wheels.hpp\n");
  CHECK(shop.text("src/wheels.hpp") ==
        head + braking("director::Outcome provide(cart::Drive::Braking& run) override", "  ") + "\n" + tail);
  CHECK(shop.stubs("--check") == "");
}

TEST_CASE("what cannot be read with what is missing is named at the places that the files have") {
  const Workshop shop;
  const std::string wheels = "#include \"cart.hpp\"\nstruct Wheels : cart::Wheels {\n  " + decl_stop + "\n  " +
                             decl_rolling +
                             "\n#define run 3\n  int speed = 0;\n};\nvoid Wheels::stop(cart::Drive::Stop&) {}\n";
  shop.write("src/wheels.cpp", wheels);
  const std::string fault = "src/wheels.cpp:8:41: error: in what would be added here: expected ')'\n";
  CHECK(shop.stubs() ==
        fault + fault + "directorc: nothing is written: with the insertions this C++ cannot be read\nstatus 1\n");
  CHECK(shop.text("src/wheels.cpp") == wheels);
}

TEST_CASE("a template with a body whose provider is gone is still a base of classes derived from it") {
  const Workshop shop;
  shop.write("src/wheels.hpp",
             "#pragma once\n#include \"cart.hpp\"\ntemplate <class I> struct WithBrakes : I {\n"
             "  director::Outcome provide(cart::Drive::Braking& run) override { return run.keep(); }\n"
             "  director::Outcome provide(cart::Drive::Skidding& run) override { return run.keep(); }\n"
             "  void stop(cart::Drive::Stop&) override {}\n};\n"
             "struct Mine final : WithBrakes<cart::Wheels> {\n"
             "  director::Outcome provide(cart::Drive::Rolling& run) override { return run.keep(); }\n};\n");
  CHECK(shop.stubs("--check") == "src/wheels.hpp:5:21: warning: `provide(cart::Drive::Skidding&)` of `WithBrakes` is "
                                 "left over: cart has no such provider or handler\n");
}

TEST_CASE("a body that a template gives for any context is a body") {
  const Workshop work;
  work.write("src/wheels.cpp",
             "#include \"cart.hpp\"\n"
             "template <class Run, class Base> struct Each : Base {\n"
             "  director::Outcome provide(Run& run) override { return run.done(); }\n};\n"
             "class Wheels final : public Each<cart::Drive::Rolling, Each<cart::Drive::Braking, cart::Wheels>> {\n"
             "  void stop(cart::Drive::Stop&) override {}\n};\n");
  CHECK(work.stubs("--check") == "");
}

TEST_CASE("what overrides nothing, or has no body, is no body") {
  const Workshop work;
  work.write("src/wheels.cpp", "#include \"cart.hpp\"\n"
                               "class Wheels : public cart::Wheels {\npublic:\n"
                               "  director::Outcome provide(cart::Drive::Rolling& run) const { return run.done(); }\n"
                               "  director::Outcome provide(cart::Drive::Braking& run) override = 0;\n"
                               "  void stop(const cart::Drive::Stop&);\n};\n"
                               "class Last final : public Wheels {\npublic:\n};\n");
  const std::string before = work.text("src/wheels.cpp");
  CHECK(work.stubs() == "added to: src/wheels.cpp\n");
  CHECK(work.text("src/wheels.cpp") == before.substr(0, before.size() - 3) +
                                           "  /// (cart.yaml:9)\n"
                                           "  void stop(cart::Drive::Stop& run) override {\n"
                                           "    static_cast<void>(run); // does nothing yet\n  }\n"
                                           "  /// (cart.yaml:11)\n  /// - sets: Motion == moving\n"
                                           "  director::Outcome provide(cart::Drive::Rolling& run) override {\n"
                                           "    return run.keep(); // does nothing yet\n  }\n"
                                           "  /// Until it stands. (cart.yaml:12)\n"
                                           "  /// - causing: Motion == still within 2 s\n"
                                           "  director::Outcome provide(cart::Drive::Braking& run) override {\n"
                                           "    return run.keep(); // does nothing yet\n  }\n};\n");
  CHECK(work.stubs("--check") == "");
}

TEST_CASE("an outdated comment is reported by --check, and not changed") {
  const Workshop shop;
  shop.stubs();
  const std::string source = shop.text("src/wheels.cpp");
  std::string changed = yaml;
  changed.replace(changed.find("within 2 s"), 10, "within 3 s");
  shop.write("cart.yaml", changed);
  CHECK(shop.stubs("--check") ==
        "src/wheels.cpp:18:27: warning: the comment above `provide(cart::Drive::Braking&)` is not true any more: "
        "`- causing: Motion == still within 2 s` is `- causing: Motion == still within 3 s` now\n");
  CHECK(shop.stubs().empty());
  shop.write("cart.yaml", "# One line more.\n" + yaml);
  CHECK(shop.stubs("--check") == "src/wheels.cpp:6:14: warning: the places in 3 comments of this file have moved, here "
                                 "first: cart.yaml:9 is cart.yaml:10 now\n");
  CHECK(shop.text("src/wheels.cpp") == source);
}

TEST_CASE("what nothing requests is reported with its place and stays") {
  const Workshop shop;
  shop.stubs();
  const std::string header = shop.text("src/wheels.hpp"), source = shop.text("src/wheels.cpp");
  std::string less = yaml;
  less.erase(less.find("      - name: braking"));
  shop.write("cart.yaml", less);
  CHECK(shop.stubs() == "src/wheels.cpp:18:27: warning: `provide(cart::Drive::Braking&)` of `Wheels` is left over: "
                        "cart has no such provider or handler\n"
                        "src/wheels.hpp:10:21: warning: `provide(cart::Drive::Braking&)` of `Wheels` is left over: "
                        "cart has no such provider or handler\n");
  std::string moved = yaml;
  moved.replace(moved.find("wheels"), 6, "motors");
  shop.write("cart.yaml", moved);
  CHECK(shop.stubs("--check").find(
            "src/wheels.hpp:8:8: warning: `stop(cart::Drive::Stop&)` of `Wheels` is left over: it belongs to the "
            "module motors, `cart::Motors`\n") != std::string::npos);
  CHECK(shop.text("src/wheels.hpp") == header);
  CHECK(shop.text("src/wheels.cpp") == source);
}

TEST_CASE("C++ that cannot be read is reported, and nothing is written") {
  const Workshop shop;
  const std::string broken =
      "#include \"cart.hpp\"\nstruct Wheels : cart::Wheels {\n  void stop(cart::Drive::Stop&) override {\n};\n";
  shop.write("src/wheels.cpp", broken);
  const std::string said = shop.stubs();
  CAPTURE(said);
  CHECK(said.starts_with("src/wheels.cpp:"));
  CHECK(said.ends_with("directorc: nothing is written: this C++ cannot be read\nstatus 1\n"));
  CHECK(shop.text("src/wheels.cpp") == broken);
  shop.write("src/wheels.cpp", "#include \"cart.hpp\"\n#include \"absent.hpp\"\n");
  const std::string help = "  help: name the folder from which it is included with `-I`, or with `-p` the folder of "
                           "compile_commands.json\n"
                           "directorc: nothing is written: this C++ cannot be read\nstatus 1\n";
  CHECK(shop.stubs() == "src/wheels.cpp:2:10: error: 'absent.hpp' file not found\n" + help);
  // A header that the behaviour lists is included by the generated one, which need not be on the disk.
  shop.write("cart.yaml", std::string(yaml) + "cpp: {headers: [parts/axle.hpp]}\n");
  shop.write("inc/parts/axle.hpp", "#pragma once\n");
  shop.write("src/wheels.cpp", "#include \"cart.hpp\"\n");
  CHECK(shop.stubs() == "cart.yaml:15:17: error: 'parts/axle.hpp' file not found\n" + help);
  CHECK(shop.stubs("-I inc").find("not found") == std::string::npos);
}

TEST_CASE("a missing #include is reported, and what is there is not added again") {
  const Workshop shop;
  shop.stubs();
  const std::string header = shop.text("src/wheels.hpp"), source = shop.text("src/wheels.cpp");
  const std::string refusal = "directorc: nothing is written: this C++ cannot be read\nstatus 1\n";

  // Of the class, whatever the name of the file.
  for (const std::string file : {"src/wheels.cpp", "src/bodies.cpp"}) {
    fs::remove(shop.folder() + "/src/wheels.cpp");
    shop.write(file, source.substr(source.find('\n') + 1));
    CHECK(shop.stubs() == file + ":5:6: error: `Wheels` is not declared here: an `#include` is missing\n" + file +
                              ":5:19: error: `cart` is not declared here: an `#include` is missing\n" + refusal);
    fs::remove(shop.folder() + "/" + file);
  }
  // Nor is anything written where a body's class may be the interface or the user's.
  const std::string include = "#include \"wheels.hpp\"\n";
  shop.write("src/wheels.cpp", include + "using namespace cart;\n" + source.substr(include.size()));
  CHECK(shop.stubs() ==
        "src/wheels.cpp:7:6: error: `Wheels` is ambiguous here: write its namespace, as in `::Wheels`\n" + refusal);
  fs::remove(shop.folder() + "/src/wheels.cpp");
  // Of the behaviour, if the class has another name than its first files would have.
  std::string other = header;
  other.erase(other.find("#include \"cart.hpp\"\n"), 20);
  fs::remove(shop.folder() + "/src/wheels.hpp");
  shop.write("src/robot.hpp", other);
  CHECK(shop.stubs() == "src/robot.hpp:5:29: error: `cart` is not declared here: an `#include` is missing\n" + refusal);
  CHECK(!fs::exists(shop.folder() + "/src/wheels.hpp"));

  // A name in a known namespace, and one of a changed behaviour: only the first is a fault.
  shop.write("src/robot.hpp", "#pragma once\n#include \"cart.hpp\"\nnamespace my { struct Wheels : cart::Wheels {\n  " +
                                  decl_stop + "\n  " + decl_rolling + "\n  " + decl_braking +
                                  "\n  void start(cart::Steer::Start&);\n}; }\n");
  shop.write("src/robot.cpp", "#include \"cart.hpp\"\nnamespace my { struct Map; }\nvoid my::Wheels::stop("
                              "cart::Drive::Stop&) {}\n");
  CHECK(shop.stubs() ==
        "src/robot.cpp:3:10: error: `Wheels` is not declared here: an `#include` is missing\n" + refusal);
}

TEST_CASE(
    "flags that Clang does not know are left out, and a build's folder without compile_commands.json is reported") {
  const Workshop shop;
  shop.write("src/wheels.cpp", "#include \"cart.hpp\"\nstruct Wheels : cart::Wheels {\n  " + decl_stop + "\n};\n");
  const std::string entry = R"("directory": ")" + shop.folder() + R"(", "file": "src/wheels.cpp", "command": )";
  const std::string flags = "g++ -std=c++20 -fno-such-thing --what-is-this -march=nothing -I" + source_dir().string();
  shop.write("build/compile_commands.json", "[{" + entry + "\"" + flags + " -c src/wheels.cpp\"}]");
  CHECK(shop.stubs("--check -p build") == "to be added to: src/wheels.cpp\nstatus 1\n");
  CHECK(shop.stubs("--check -p bulid") ==
        "directorc: cannot read `bulid/compile_commands.json`: No such file or directory; CMake writes it with "
        "-D CMAKE_EXPORT_COMPILE_COMMANDS=ON\nstatus 2\n");
}

TEST_CASE("the content of bodies is ignored, and a file at the place of a new one is not changed") {
  const Workshop shop;
  shop.write("src/wheels.hpp", "#pragma once\n");
  shop.write("src/x.cpp", "#include \"cart.hpp\"\nvoid f() { cart::Gone{1}( ; }\n");
  CHECK(shop.stubs() ==
        "src/wheels.hpp:1:1: error: this file is in the way: it has no class that implements `cart::Wheels`, which "
        "would be written here\n  help: put the class into it, or give the module another name\nstatus 1\n");
  CHECK(shop.text("src/wheels.hpp") == "#pragma once\n");
}

TEST_CASE("nothing is written if a file is in the way of one of the new classes") {
  const Workshop shop;
  std::filesystem::create_directories(std::filesystem::path(shop.folder()) / "src/wheels.cpp");
  const std::string said = "src/wheels.cpp:1:1: error: this file cannot be read: Is a directory; a class that "
                           "implements `cart::Wheels` would be written here, unless it has one already\n"
                           "  help: move it away, or give the module another name\n";
  CHECK(shop.stubs("--main") == said + "directorc: nothing is written\nstatus 1\n");
  CHECK(shop.stubs("--main --dry-run") == said + "directorc: nothing is written\nstatus 1\n");
  CHECK(shop.stubs("--main --check") == said + "missing: src/main.cpp\nstatus 1\n");
  CHECK_FALSE(std::filesystem::exists(std::filesystem::path(shop.folder()) / "src/main.cpp"));
  CHECK_FALSE(std::filesystem::exists(std::filesystem::path(shop.folder()) / "src/wheels.hpp"));
}

TEST_CASE("a file that cannot be read is reported with the reason, and what is in it counts as missing") {
  const Workshop shop;
  const auto make_large = [&](const char* path) {
    shop.write(path, "");
    std::filesystem::resize_file(std::filesystem::path(shop.folder()) / path, (64U << 20U) + 1);
  };
  make_large("src/wheels.hpp");
  CHECK(shop.stubs() == "src/wheels.hpp:1:1: error: this file cannot be read: file too large; a class that implements "
                        "`cart::Wheels` would be written here, unless it has one already\n"
                        "  help: move it away, or give the module another name\nstatus 1\n");
  std::filesystem::remove(std::filesystem::path(shop.folder()) / "src/wheels.hpp");
  make_large("src/other.cpp");
  CHECK(shop.stubs("--check") ==
        "src/other.cpp:1:1: warning: this file cannot be read, so what it has counts as missing: file too large\n"
        "missing: src/wheels.hpp\nmissing: src/wheels.cpp\nstatus 1\n");
}

TEST_CASE("a dry run prints a diff that can be applied") {
  const Workshop shop;
  shop.write("src/wheels.hpp", "#pragma once\n#include \"cart.hpp\"\nstruct Wheels final : cart::Wheels {\n  " +
                                   decl_stop + "\n  " + decl_rolling + "\n};\n");
  shop.write("src/wheels.cpp", "#include \"wheels.hpp\"\nvoid Wheels::stop(cart::Drive::Stop&) {}\n"
                               "director::Outcome Wheels::provide(cart::Drive::Rolling& run) { return run.keep(); }");
  const std::string diff = shop.stubs("--dry-run");
  CHECK(diff.starts_with("--- a/src/wheels.cpp\n+++ b/src/wheels.cpp\n@@ -1,3 +1,9 @@\n #include \"wheels.hpp\"\n"));
  shop.write("diff.txt", diff);
  if (std::system("command -v patch >/dev/null") == 0) {
    CHECK(std::system(("cd '" + shop.folder() + "' && patch -s -p1 < diff.txt").c_str()) == 0);
    CHECK(shop.stubs("--check") == "");
  }
}

TEST_CASE("the user's .clang-format formats what is written, and nothing else") {
  const Workshop shop;
  shop.write(".clang-format", "BasedOnStyle: WebKit\nIndentWidth: 3\nSpaceBeforeParens: Always\n");
  const std::string header =
      "#pragma once\n#include   \"cart.hpp\"\n struct Wheels final:cart::Wheels {\n        void "
      "stop(cart::Drive::Stop&) override {}\n"
      "        director::Outcome provide( cart::Drive::Rolling&run )override{return run.keep();}\n};\n";
  shop.write("src/wheels.hpp", header);
  CHECK(shop.stubs() == "added to: src/wheels.hpp\n");
  const std::string text = shop.text("src/wheels.hpp");
  const std::size_t at = header.find("return run.keep();}") + 19;
  CHECK(text.substr(0, at) == header.substr(0, at));
  CHECK(text.substr(text.size() - 4) == "\n};\n");
  CHECK(text.find("director::Outcome provide (cart::Drive::Braking& run) override") != std::string::npos);
  shop.write(".clang-format", "BasedOnStyle: Nobody\n");
  shop.write("src/wheels.hpp", header);
  CHECK(shop.stubs().find("directorc: director-clang: the .clang-format for `") != std::string::npos);
  CHECK(shop.text("src/wheels.hpp") == header);
}

TEST_CASE("without director-clang the first files are written, and later it reports what it needs") {
  const Workshop shop;
  ::setenv("DIRECTOR_CLANG", "/nowhere/director-clang", 1);
  CHECK(shop.stubs() == "new: src/wheels.hpp\nnew: src/wheels.cpp\n");
  const std::string said = shop.stubs();
  ::unsetenv("DIRECTOR_CLANG");
  CHECK(said.starts_with(
      "directorc: what is missing in `src` can only be told by reading its C++: director-clang is not installed"));
  CHECK(said.ends_with("install the package director-clang, or, where you build Director, clang-19 libclang-19-dev "
                       "llvm-19-dev\nstatus 2\n"));
}
