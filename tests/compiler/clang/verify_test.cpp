// SPDX-License-Identifier: MIT
// What `directorc verify` reads of a build, and how it reports.
#include "compiler/base/json.hpp"
#include "compiler/cli/input/load.hpp"
#include "tests/compiler/clang/workshop.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace director::tests;
using director::compiler::Json;

const std::string yaml = "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n"
                         "  Drive: {module: wheels, tasks: [Wheel]}\n  Wheel: {module: wheels}\n";

/// `include`: the line that includes the generated header, if any.
std::string wheels(const std::string& include) {
  return include + "class MyWheels final : public cart::Wheels {\npublic:\n"
                   "  director::Outcome provide(cart::Drive::Default& run) override { return run.done(); }\n"
                   "  director::Outcome provide(cart::Wheel::Default& run) override { return run.done(); }\n};\n";
}
const std::string included = "#include \"cart.hpp\"\n";
const std::string found = "no path of `Drive` requests `Wheel`";

/// With a behaviour that has been generated.
Workshop workshop(const std::string& name) {
  Workshop out(name);
  out.write("cart.yaml", yaml);
  REQUIRE(out.directorc({"generate", out.path("cart.yaml"), "-o", out.path("generated")}).status == 0);
  return out;
}

std::vector<std::string> flags(const Workshop& work) {
  return {"-std=c++20", "-I" + work.path("generated"), "-I" + source_folder()};
}

Worked verified(const Workshop& work, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"verify", work.path("cart.yaml"), "-p", work.path(), "--format=json"};
  words.insert(words.end(), more.begin(), more.end());
  return work.directorc(words);
}

std::vector<std::string> messages(const std::string& text) {
  const auto json = director::compiler::parse_json(text);
  REQUIRE(json);
  std::vector<std::string> out;
  for (const Json& each : (*json)["findings"].items()) out.push_back(each["message"].as_text());
  return out;
}

TEST_CASE("a source that gets the generated header by its flags alone is read") {
  const Workshop work = workshop("forced");
  work.write("body.cpp", wheels(""));
  work.write("all.hpp", included);
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = flags(work);
    all.insert(all.end(), more.begin(), more.end());
    work.write_commands({work.path("body.cpp")}, all);
    const Worked worked = verified(work);
    INFO(worked.err);
    return messages(worked.out);
  };
  const std::vector<std::string> one{found};
  CHECK(with({"-include", work.path("generated/cart.hpp")}) == one);
  CHECK(with({"-include", "cart.hpp"}) == one);
  CHECK(with({"-include", "all.hpp"}) == one);
  CHECK(with({"-includeall.hpp"}) == one);
  CHECK(with({"--include=all.hpp"}) == one);
  CHECK(with({"-Xclang", "-include", "-Xclang", "all.hpp"}) == one);
}

TEST_CASE("a library's header that includes the generated one is followed, and another one is not decided") {
  const Workshop work = workshop("library");
  std::string body = wheels("#include <walker.hpp>\n");
  body.replace(body.find("return run.done()"), 17, "Walker walker(run);\n    return walker.go()");
  const std::string walker = "class Walker {\npublic:\n  explicit Walker(cart::Drive::Default& run) : run_(run) {}\n"
                             "  director::Outcome go() { return run_.ANSWER; }\nprivate:\n"
                             "  cart::Drive::Default& run_;\n};\n";
  const std::string anything = "template <class Run> class Any {\npublic:\n  explicit Any(Run& run) : run_(run) {}\n"
                               "  auto go() { return run_.ANSWER; }\nprivate:\n  Run& run_;\n};\n";
  const auto with = [&](std::string header, const std::string& answer, const std::string& flag) {
    header.replace(header.find("ANSWER"), 6, answer);
    work.write("lib/parts/any.hpp", "#pragma once\n" + header);
    work.write("lib/walker.hpp", "#pragma once\n#include \"parts/any.hpp\"\n");
    work.write("body.cpp", body);
    std::vector<std::string> all = flags(work);
    all.insert(all.end(), {flag, work.path("lib")});
    work.write_commands({work.path("body.cpp")}, all);
    return verified(work);
  };
  for (const std::string flag : {"-I", "-isystem"}) {
    for (const std::string mark : {"", "#pragma GCC system_header\n"}) {
      CAPTURE(flag, mark);
      const std::string header = mark + included + walker;
      CHECK(messages(with(header, "request(cart::Wheel{})", flag).out).empty());
      CHECK(messages(with(header, "done()", flag).out) == std::vector<std::string>{found});
    }
  }
  body.replace(body.find("#include"), 0, included);
  body.replace(body.find("Walker walker(run)"), 18, "Any any(run)").replace(body.find("walker.go"), 6, "any");
  const Worked worked = with(anything, "done()", "-isystem");
  CHECK(messages(worked.out).empty());
  const auto json = director::compiler::parse_json(worked.out);
  REQUIRE(json);
  std::vector<std::string> told;
  for (const Json& each : (*json)["not_decided"].items())
    told.push_back(each.as_text().substr(each.as_text().rfind("body.cpp")));
  CHECK(told == std::vector<std::string>{"body.cpp:5:71: what `Any` does with it",
                                         "body.cpp:6:16: what `Any::go` does with it"});
}

TEST_CASE("bodies in a library's header are read") {
  const Workshop work = workshop("library-bodies");
  work.write("lib/wheels.hpp", "#pragma once\n" + wheels(included));
  work.write("body.cpp", "#include <wheels.hpp>\nMyWheels it;\n");
  std::vector<std::string> all = flags(work);
  all.insert(all.end(), {"-isystem", work.path("lib")});
  work.write_commands({work.path("body.cpp")}, all);
  const Worked worked = verified(work);
  CHECK(messages(worked.out) == std::vector<std::string>{found});
}

TEST_CASE("a source that begins with a byte order mark, or with a comment, is read") {
  const Workshop work = workshop("marked");
  const std::string begin = GENERATE("\xEF\xBB\xBF", "/* licence */ ", "\f");
  work.write("body.cpp", begin + wheels(included));
  work.write_commands({work.path("body.cpp")}, flags(work));
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
}

TEST_CASE("a body whose group was renamed is not taken for the one of the new name") {
  const Workshop work = workshop("renamed");
  work.write("body.cpp", included + "class MyWheels final : public cart::Wheels {\npublic:\n"
                                    "  director::Outcome provide(cart::Wheeel::Default& run) override;\n"
                                    "  director::Outcome provide(cart::Drive::Default& run) override {\n"
                                    "    return run.request(cart::Wheel{});\n  }\n"
                                    "  director::Outcome provide(cart::Wheel::Default& run) override;\n};\n"
                                    "director::Outcome MyWheels::provide(cart::Wheel::Default& run) {\n"
                                    "  return run.done();\n}\n");
  work.write_commands({work.path("body.cpp")}, flags(work));
  const Worked worked = verified(work);
  CHECK(messages(worked.out).empty());
  const auto json = director::compiler::parse_json(worked.out);
  REQUIRE(json);
  REQUIRE((*json)["not_decided"].items().size() == 1);
  const std::string told = (*json)["not_decided"].items()[0].as_text();
  CHECK_THAT(told, Catch::Matchers::EndsWith("body.cpp:4:35: no member named 'Wheeel' in namespace 'cart'"));
}

TEST_CASE("if no body is found, what Clang does not understand is reported first, as it may be the reason") {
  Workshop work("not_understood");
  work.write("types.hpp", "#pragma once\nnamespace types {\nstruct Speed {\n");
  work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ncpp: {headers: [types.hpp]}\n"
                          "groups: {Drive: {module: wheels, data: types::Speed}}\n");
  REQUIRE(work.directorc({"generate", work.path("cart.yaml"), "-o", work.path("generated")}).status == 0);
  work.write("body.cpp", included + "class MyWheels final : public cart::Wheels {};\n");
  std::vector<std::string> all = flags(work);
  all.push_back("-I" + work.path());
  work.write_commands({work.path("body.cpp")}, all);
  const Worked worked = verified(work);
  CHECK(worked.status == 2);
  INFO(worked.err);
  const std::size_t end = worked.err.find('\n');
  CHECK_THAT(worked.err, Catch::Matchers::StartsWith("directorc: not decided: Clang does not understand all of `"));
  CHECK_THAT(worked.err.substr(end),
             Catch::Matchers::StartsWith("\ndirectorc: no body of `cart` was found in the file of `"));
}

TEST_CASE("of several things that Clang does not understand the first is told, and how many there are besides") {
  const Workshop work = workshop("three_errors");
  work.write("body.cpp",
             wheels(included) + "int first = nowhere_a;\nint second = nowhere_b;\nint third = nowhere_c;\n");
  work.write_commands({work.path("body.cpp")}, flags(work));
  const Worked worked = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path()});
  CHECK_THAT(worked.err, Catch::Matchers::Contains("use of undeclared identifier 'nowhere_a', and 2 more\n"));
}

TEST_CASE("a build that compiles only what is generated has no file that could have a body") {
  const Workshop work = workshop("only_generated");
  work.write_commands({work.path("generated/cart.cpp")}, flags(work));
  CHECK(work.directorc({"verify", work.path("cart.yaml"), "-p", work.path()}).err ==
        "directorc: no file of `" + work.path() +
            "` includes the generated `cart.hpp`, or has it in its include folders: has the program been built?\n");
}

TEST_CASE("flags in response files count, also where one names another") {
  const Workshop work = workshop("response");
  work.write("body.cpp", wheels(included));
  work.write("flags.rsp", "-std=c++20 @more.rsp\n");
  work.write("more.rsp", "-I\"" + work.path("generated") + "\"\r\n-I" + source_folder() + "\n@more.rsp\n");
  work.write_commands({work.path("body.cpp")}, {"@flags.rsp"});
  const Worked worked = verified(work);
  INFO(worked.err);
  CHECK(messages(worked.out) == std::vector<std::string>{found});
}

TEST_CASE("test doubles can be left out by their file, their folder, or what they are compiled into") {
  const Workshop work = workshop("doubles");
  std::string twin = wheels(included);
  work.write("tests/double.cpp", twin.replace(twin.find("MyWheels"), 8, "Double"));
  std::string good = wheels(included);
  good.replace(good.find("run.done()"), 10, "run.request(cart::Wheel{})");
  work.write("body.cpp", good);
  work.write_commands({work.path("body.cpp"), work.path("tests/double.cpp")}, flags(work));
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  for (const std::string path : {"tests", "tests/", "tests/double.cpp"}) {
    CAPTURE(path);
    const Worked worked = verified(work, {"--exclude", work.path(path)});
    CHECK(messages(worked.out).empty());
    CHECK(worked.status == 0);
  }
  std::filesystem::remove(work.path("link"));
  std::filesystem::create_directory_symlink(work.path(), work.path("link"));
  const Worked linked = verified(work, {"--exclude", work.path("link/tests")});
  CHECK(linked.err == "");
  CHECK(messages(linked.out).empty());
  std::string commands = "[";
  for (const std::string file : {"body", "tests/double"})
    commands += std::string(file == "body" ? "" : ",") + R"({"directory": ")" + work.path() + R"(", "file": ")" + file +
                R"(.cpp", "command": "g++ -std=c++20 -I)" + work.path("generated") + " -I" + source_folder() +
                " -o CMakeFiles/" + (file == "body" ? "cart" : "doubles") + ".dir/" + file + ".o -c " + file +
                ".cpp\"}";
  work.write("compile_commands.json", commands + "]");
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  for (const std::string folder : {"CMakeFiles/doubles.dir", "CMakeFiles/doubles.dir/"}) // which need not exist
    CHECK(messages(verified(work, {"--exclude=" + work.path(folder)}).out).empty());
}

TEST_CASE("a test double with the name of a class does not hide what the class does") {
  const Workshop work = workshop("double");
  std::string real = wheels(included);
  const std::string good = "return run.request(cart::Wheel{});";
  std::string fake = real;
  fake.replace(fake.find("return run.done();"), 18, good);
  work.write("body.cpp", real);
  work.write("fake.cpp", fake);
  for (const bool first : {true, false}) {
    const std::string one = work.path(first ? "body.cpp" : "fake.cpp");
    work.write_commands({one, work.path(first ? "fake.cpp" : "body.cpp")}, flags(work));
    CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  }
}

TEST_CASE("a test double that derives from a class does not hide what the class does, if an object of it is made") {
  const Workshop work = workshop("derived");
  std::string header = wheels("#pragma once\n#include <memory>\n" + included);
  header.erase(header.find(" final"), 6);
  work.write("wheels.hpp", header);
  work.write("robot.cpp", "#include \"wheels.hpp\"\n");
  work.write("test.cpp", "#include \"wheels.hpp\"\n#include <functional>\nclass Mock : public MyWheels {\npublic:\n"
                         "  std::function<director::Outcome(cart::Drive::Default&)> on;\n"
                         "  director::Outcome provide(cart::Drive::Default& run) override { return on(run); }\n};\n"
                         "Mock mock;\n");
  work.write_commands({work.path("robot.cpp"), work.path("test.cpp")}, flags(work));
  CHECK(messages(verified(work).out).empty()); // only the double may run
  for (const char* object : {"MyWheels own;\n", "const auto own = std::make_unique<MyWheels>();\n",
                             "struct Robot {\n  MyWheels own[2];\n};\n", "void go() { new MyWheels; }\n",
                             "class Quiet final : public MyWheels {};\nQuiet own;\n"}) {
    INFO(object);
    work.write("robot.cpp", std::string("#include \"wheels.hpp\"\n") + object);
    CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  }
}

TEST_CASE("a class of which objects are made, or from which nobody derives, lacks the bodies that it leaves out") {
  const Workshop work = workshop("lacking");
  const std::string drive = "public:\n  director::Outcome provide(cart::Drive::Default& run) override { return "
                            "run.request(cart::Wheel{}); }\n";
  for (const std::string& text : {"struct Other { virtual ~Other() = default; virtual int speed() const = 0; };\n"
                                  "class Mine final : public cart::Wheels, public Other {\n" +
                                      drive + "};\n",
                                  "class Mine : public cart::Wheels {\n" + drive +
                                      "  template <class T> explicit Mine(T) {}\nprotected:\n"
                                      "  Mine() = default;\n};\n"}) {
    INFO(text);
    work.write("a.cpp", included + text);
    work.write_commands({work.path("a.cpp")}, flags(work));
    CHECK(messages(verified(work).out) == std::vector<std::string>{"`Mine` has no body for `Wheel`"});
  }
}

TEST_CASE("a source that gets the generated header beside it, or by a path, is read") {
  const Workshop work = workshop("beside");
  const std::vector<std::string> without{"-std=c++20", "-I" + work.path(), "-I" + source_folder()};
  work.write("generated/body.cpp", wheels(included));
  work.write_commands({work.path("generated/body.cpp"), work.path("generated/cart.cpp")}, without);
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  work.write("body.cpp", wheels("#include \"generated/cart.hpp\"\n"));
  work.write_commands({work.path("body.cpp")}, without);
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
}

TEST_CASE("bodies in what CMake precompiles are read") {
  const Workshop work = workshop("precompiled");
  work.write("wheels.hpp", "#pragma once\n" + wheels(included));
  work.write("body.cpp", "int here = 0;\n");
  for (const std::string mark : {"GCC", "clang"}) {
    work.write("cmake_pch.hxx", "/* generated by CMake */\n\n#pragma " + mark + " system_header\n#include \"" +
                                    work.path("wheels.hpp") + "\"\n");
    std::vector<std::string> all = flags(work);
    const std::vector<std::string> forced =
        mark == "GCC" ? std::vector<std::string>{"-include", work.path("cmake_pch.hxx")}
                      : std::vector<std::string>{"-Xclang", "-include", "-Xclang", work.path("cmake_pch.hxx")};
    all.insert(all.end(), forced.begin(), forced.end());
    work.write_commands({work.path("body.cpp")}, all);
    const Worked worked = verified(work);
    CAPTURE(mark, worked.err);
    CHECK(messages(worked.out) == std::vector<std::string>{found});
  }
}

TEST_CASE("a build that does not list what includes the generated header is reported as such") {
  const Workshop work = workshop("unlisted");
  work.write("other.cpp", "int here = 0;\n");
  work.write_commands({work.path("other.cpp")}, flags(work));
  const Worked worked = verified(work);
  CHECK(worked.err == "directorc: no file that `" + work.path() +
                          "` lists includes the generated `cart.hpp`: is the target with the bodies in it? With CMake, "
                          "set `CMAKE_EXPORT_COMPILE_COMMANDS` for all targets\n");
  CHECK(worked.status == 2);
}

TEST_CASE("a file that is compiled twice does what it does with the flags of both") {
  const Workshop work = workshop("twice");
  std::string body = wheels(included);
  body.replace(body.find("return run.done();"), 18,
               "\n#ifdef SIM\nreturn run.done();\n#else\nreturn run.request(cart::Wheel{});\n#endif\n");
  work.write("body.cpp", body);
  const auto entry = [&](const std::string& more) {
    std::string out =
        "{\"directory\": \"" + work.path() + "\", \"file\": \"" + work.path("body.cpp") + "\", \"arguments\": [\"g++\"";
    for (const std::string& flag : flags(work)) out += ", \"" + flag + "\"";
    return out + more + ", \"-c\", \"" + work.path("body.cpp") + "\"]}";
  };
  const std::string sim = entry(", \"-DSIM\""), robot = entry("");
  for (const std::string& both : {sim + ", " + robot, robot + ", " + sim}) {
    work.write("compile_commands.json", "[" + both + "]");
    CHECK(messages(verified(work).out) == std::vector<std::string>{});
  }
  work.write("compile_commands.json", "[" + sim + "]");
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
}

TEST_CASE("a missing file that is to be left out is reported") {
  const Workshop work = workshop("no-doubles");
  work.write("body.cpp", wheels(included));
  work.write_commands({work.path("body.cpp")}, flags(work));
  const Worked worked = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path(), "--exclude=nowhere"});
  CHECK(worked.err == "directorc: `--exclude=nowhere` leaves nothing out: no source of `" + work.path() +
                          "` lies there, and none is compiled into it\n");
  CHECK(worked.status == 0);
  const Worked all = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path(), "--exclude", work.path()});
  CHECK(all.err ==
        "directorc: no file of `" + work.path() +
            "` that is not excluded includes the generated `cart.hpp`, or has it in its include folders: has the "
            "program been built?\n");
  CHECK(all.status == 2);
}

TEST_CASE("a source that the build lists and that does not exist is reported, once") {
  const Workshop work = workshop("gone");
  work.write("body.cpp", wheels(included));
  work.write_commands({work.path("body.cpp"), work.path("gone.cpp"), work.path("gone.cpp")}, flags(work));
  const Worked worked = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path()});
  CHECK(worked.err == "directorc: not decided: `" + director::compiler::cli::shown_path(work.path("gone.cpp")) +
                          "`, a source of the build, cannot be read: No such file or directory; configure again if it "
                          "is gone, build if it is generated\n");
  const Worked left_out =
      work.directorc({"verify", work.path("cart.yaml"), "-p", work.path(), "--exclude", work.path("gone.cpp")});
  CHECK(left_out.err.empty());
}

TEST_CASE("a behaviour that is wrong is reported in the format that is requested") {
  const Workshop work = workshop("wrong");
  work.write("types.hpp", "#pragma once\nnamespace cart { enum class Gait { walk, run }; }\n");
  std::string drifted = yaml;
  drifted.insert(drifted.find("roots"),
                 "cpp: {headers: [types.hpp]}\nstates: {Gait: {type: cart::Gait, values: [walk]}}\n");
  work.write("cart.yaml", drifted);
  work.write("body.cpp", wheels(included));
  std::vector<std::string> all = flags(work);
  all.push_back("-I" + work.path());
  work.write_commands({work.path("body.cpp")}, all);
  const std::string drift = "`cart::Gait` has `run`, which the values of `Gait` lack";
  const Worked json = verified(work);
  CHECK(json.status == 1);
  CHECK(json.err == "");
  CHECK(messages(json.out) == std::vector<std::string>{drift});
  const Worked sarif = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path(), "--format=sarif"});
  CHECK(sarif.status == 1);
  CHECK(sarif.err == "");
  const auto log = director::compiler::parse_json(sarif.out);
  REQUIRE(log);
  CHECK((*log)["runs"].items()[0]["results"].items()[0]["ruleId"].as_text() == "enum_drift");
  const Worked text = work.directorc({"verify", work.path("cart.yaml"), "-p", work.path()});
  CHECK(text.status == 1);
  CHECK(text.out == "");
  CHECK(text.err.find("error: " + drift + " [enum_drift]\n") != std::string::npos);
}

TEST_CASE("for a compiled library it is reported what cannot be determined, if a group is realtime") {
  const Workshop work("library");
  work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n"
                          "  Drive: {module: wheels, realtime: true}\n");
  work.write("vendor/chip.hpp", "#pragma once\nnamespace chip {\nint read(int channel);\nstruct Bus { virtual ~Bus() = "
                                "default; void flush(); };\ntemplate <class T> T* make() { return new T; }\n"
                                "inline int twice() { return read(2); }\n}\nextern \"C\" int chip_fast() noexcept;\n");
  work.write("body.cpp", included + "#include <chip.hpp>\n#include <cmath>\n#include <cstring>\n"
                                    "static chip::Bus bus;\n"
                                    "class MyWheels final : public cart::Wheels {\n"
                                    "  director::Outcome provide(cart::Drive::Default& run) override {\n"
                                    "    chip::read(1);\n    bus.flush();\n    chip::twice();\n    chip_fast();\n"
                                    "    char c[3];\n    std::memset(c, static_cast<int>(std::sin(c[0])), 3);\n"
                                    "    chip::make<int>();\n    return run.done();\n  }\n};\n");
  REQUIRE(work.directorc({"generate", work.path("cart.yaml"), "-o", work.path("generated")}).status == 0);
  std::vector<std::string> all = flags(work);
  all.insert(all.end(), {"-isystem", work.path("vendor")});
  work.write_commands({work.path("body.cpp")}, all);
  const Worked worked = verified(work);
  INFO(worked.err);
  CHECK(messages(worked.out) == std::vector<std::string>{"`chip::make` uses the heap, and `Drive` is `realtime`"});
  const auto json = director::compiler::parse_json(worked.out);
  std::vector<std::string> open;
  for (const std::string& each : (*json)["not_decided"].as_texts()) open.push_back(each.substr(each.find("body.cpp")));
  CHECK(open == std::vector<std::string>{"body.cpp:8:11: `chip::read`", "body.cpp:9:9: `chip::Bus::flush`",
                                         "body.cpp:10:11: `chip::read`, which `chip::twice` calls"});
}

TEST_CASE("a header that is included by two names is one file, with all that it does in one of them") {
  const Workshop work = workshop("spellings");
  std::string twin = wheels("#pragma once\n" + included);
  twin.replace(twin.find("return run.done();"), 18,
               "\n#ifndef SIM\n    const auto go = [&] { return run.request(cart::Wheel{}); };\n"
               "    if (this == nullptr) return go();\n#endif\n    return run.done();\n");
  work.write("include/wheels.hpp", twin);
  work.write("src/a.cpp", "#define SIM\n#include \"../include/wheels.hpp\"\nstatic MyWheels own;\n");
  work.write("src/b.cpp", "#include <wheels.hpp>\nstatic MyWheels own;\n");
  std::vector<std::string> all = flags(work);
  all.push_back("-I" + work.path("include"));
  work.write_commands({work.path("src/a.cpp"), work.path("src/b.cpp")}, all);
  const Worked both = verified(work);
  INFO(both.err);
  CHECK(messages(both.out).empty());
  work.write("src/b.cpp", "#define SIM\n#include <wheels.hpp>\nstatic MyWheels own;\n");
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
}

TEST_CASE("an answer is not taken from the cache if a header appears that the program would include") {
  const Workshop work = workshop("appears");
  std::string twin =
      wheels("#if __has_include(\"site/own.hpp\")\n#include \"site/own.hpp\"\n#endif\n#include <way.hpp>\n" + included);
  twin.replace(twin.find("return run.done();"), 18, "REQUESTS return run.done();");
  const std::string requests = "#define REQUESTS if (this != nullptr) return run.request(cart::Wheel{});\n";
  work.write("body.cpp", twin);
  work.write("second/way.hpp", "#ifndef REQUESTS\n#define REQUESTS\n#endif\n");
  std::vector<std::string> all = flags(work);
  all.insert(all.end(), {"-I" + work.path(), "-I" + work.path("first"), "-I" + work.path("second")});
  work.write_commands({work.path("body.cpp")}, all);
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  CHECK(messages(verified(work).out) == std::vector<std::string>{found});
  const std::string path = GENERATE("site/own.hpp", "first/way.hpp", "way.hpp");
  CAPTURE(path);
  work.write(path, requests);
  CHECK(messages(verified(work).out).empty());
}

TEST_CASE("the folder of the generated files may be named by a symbolic link") {
  const Workshop work = workshop("linked");
  work.write("body.cpp", wheels(included));
  work.write_commands({work.path("body.cpp")}, flags(work));
  std::filesystem::remove(work.path("link"));
  std::filesystem::create_directory_symlink(work.path(), work.path("link"));
  CHECK(messages(verified(work, {"--generated", work.path("link/generated")}).out) == std::vector<std::string>{found});
  CHECK(verified(work, {"--generated", work.path("link")}).status == 2);
}

TEST_CASE("what a driver in C does is followed") {
  const Workshop work("driver");
  work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n"
                          "  Drive: {module: wheels, realtime: true}\n");
  work.write("hal.h", "#ifdef __cplusplus\nextern \"C\" {\n#endif\nvoid hal_delay(int ms);\n"
                      "#ifdef __cplusplus\n}\n#endif\n");
  work.write("hal.c", "#include \"hal.h\"\n#include <stdlib.h>\n#include <unistd.h>\n"
                      "void hal_delay(int ms) {\n  int* class = malloc(sizeof *class);\n  usleep(ms);\n"
                      "  free(class);\n  (void)_Generic(ms, double: sleep(3), default: 0U);\n}\n");
  work.write("body.cpp", included + "#include \"hal.h\"\nclass MyWheels final : public cart::Wheels {\n"
                                    "  director::Outcome provide(cart::Drive::Default& run) override {\n"
                                    "    hal_delay(3);\n    return run.done();\n  }\n};\n");
  REQUIRE(work.directorc({"generate", work.path("cart.yaml"), "-o", work.path("generated")}).status == 0);
  const auto entry = [&](const std::string& compiler, const std::string& file) {
    return R"({"directory": ")" + work.path() + R"(", "file": ")" + file + R"(", "command": ")" + compiler + " -I" +
           work.path("generated") + " -I" + source_folder() + " -c " + file + R"("})";
  };
  work.write("compile_commands.json",
             "[" + entry("g++ -std=c++20", "body.cpp") + "," + entry("gcc -std=gnu11", "hal.c") + "]");
  const Worked worked = verified(work);
  CHECK(worked.err == "");
  std::vector<std::string> said = messages(worked.out);
  std::sort(said.begin(), said.end());
  CHECK(said == std::vector<std::string>{"`free` uses the heap, and `Drive` is `realtime`",
                                         "`malloc` uses the heap, and `Drive` is `realtime`",
                                         "`usleep` sleeps, and `Drive` is `realtime`"});
}

TEST_CASE("a file with the name of one of C that a compiler of C++ compiles is read as C++") {
  const Workshop work("driver_of_cpp");
  work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n"
                          "  Drive: {module: wheels, realtime: true}\n");
  work.write("hal.hpp", "namespace hal {\nvoid delay(int ms);\n}\n");
  work.write("hal.c", "#include \"hal.hpp\"\n#include <unistd.h>\n"
                      "void hal::delay(int ms) { usleep(static_cast<unsigned>(ms)); }\n");
  work.write("body.cpp", included + "#include \"hal.hpp\"\nclass MyWheels final : public cart::Wheels {\n"
                                    "  director::Outcome provide(cart::Drive::Default& run) override {\n"
                                    "    hal::delay(3);\n    return run.done();\n  }\n};\n");
  REQUIRE(work.directorc({"generate", work.path("cart.yaml"), "-o", work.path("generated")}).status == 0);
  work.write_commands({work.path("body.cpp"), work.path("hal.c")}, flags(work));
  const Worked worked = verified(work);
  CHECK(worked.err == "");
  CHECK(messages(worked.out) == std::vector<std::string>{"`usleep` sleeps, and `Drive` is `realtime`"});
}

TEST_CASE("of a long way to what blocks the first calls and the last one are noted") {
  const Workshop work("long-way");
  work.write("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n"
                          "  Drive: {module: wheels, realtime: true}\n");
  std::string calls = included + "#include <mutex>\nstatic std::mutex m;\nstatic void f0() { m.lock(); }\n";
  for (int i = 1; i < 60; ++i)
    calls += "static void f" + std::to_string(i) + "() { f" + std::to_string(i - 1) + "(); }\n";
  work.write("body.cpp", calls + "class MyWheels final : public cart::Wheels {\n"
                                 "  director::Outcome provide(cart::Drive::Default& run) override {\n"
                                 "    f59();\n    return run.done();\n  }\n};\n");
  REQUIRE(work.directorc({"generate", work.path("cart.yaml"), "-o", work.path("generated")}).status == 0);
  work.write_commands({work.path("body.cpp")}, flags(work));
  const auto json = director::compiler::parse_json(verified(work).out);
  REQUIRE(json);
  const std::vector<Json>& notes = (*json)["findings"].items().at(0)["notes"].items();
  REQUIRE(notes.size() == 40);
  CHECK(notes.front()["message"].as_text() == "it runs in `Drive`");
  CHECK(notes[38]["message"].as_text() == "and 22 more of such notes, before the last one");
  CHECK(notes.back()["message"].as_text() == "which calls `f0`");
}

TEST_CASE("bodies that are as stubs wrote them are named in one line, and judged when they are written") {
  const Workshop work = workshop("unwritten");
  std::string fresh = wheels(included);
  for (std::size_t at = fresh.find("{ return run.done(); }"); at != std::string::npos;
       at = fresh.find("{ return run.done(); }"))
    fresh.replace(at, 22, "{\n    return run.keep(); // does nothing yet\n  }");
  work.write("body.cpp", fresh);
  work.write_commands({work.path("body.cpp")}, flags(work));
  const std::vector<std::string> words{"verify", work.path("cart.yaml"), "-p", work.path(), "--werror"};
  const Worked unwritten = work.directorc(words);
  CHECK(unwritten.out == "");
  CHECK(unwritten.err == "directorc: 2 bodies are as `stubs` wrote them: `Drive`, `Wheel`\n");
  CHECK(unwritten.status == 0);
  fresh.replace(fresh.find(" // does nothing yet"), 20, "");
  work.write("body.cpp", fresh);
  const Worked written = work.directorc(words);
  CHECK(written.out.find("error: every path of `Drive` ends in `keep()`: it never requests anything, and is never done "
                         "[only_keeps]") != std::string::npos);
  CHECK(written.err == "directorc: 1 body is as `stubs` wrote it: `Wheel`\n");
  CHECK(written.status == 1);
}

} // namespace
