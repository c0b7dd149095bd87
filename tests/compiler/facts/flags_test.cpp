// SPDX-License-Identifier: MIT
#include "compiler/facts/compile_commands.hpp"
#include "compiler/facts/flags.hpp"
#include "compiler/facts/includes.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using namespace director::compiler;
using Words = std::vector<std::string>;

/// Gives the same answer to every request, and counts them.
class Compiler final : public Programs {
public:
  Answer run(const Words& words, const std::string&) override {
    question = words;
    ++calls;
    return answer;
  }
  Answer answer;
  Words question;
  int calls = 0;
};

TEST_CASE("a command line is taken apart as a shell would") {
  CHECK(split_command(R"(g++  -DNAME="\"a b\"" '-DX=c d' e\ f)") == Words{"g++", "-DNAME=\"a b\"", "-DX=c d", "e f"});
  CHECK(split_command("a '' b") == Words{"a", "", "b"});
  CHECK(split_command("").empty());
}

TEST_CASE("a dollar sign in a command is read as CMake writes it, and as a shell does") {
  CHECK(split_command(R"("/a\$$b/g++" -DA="\"\$$x\"" -DB="\$$\$$c" -DC=$(c) -I"/a\$$b c/i")") ==
        Words{"/a$b/g++", "-DA=\"$x\"", "-DB=$$c", "-DC=$(c)", "-I/a$b c/i"});
  CHECK(split_command(R"("/a\$b" '/a$$b' "\$" /a\$b)") == Words{"/a$b", "/a$$b", "$", "/a$b"});
}

TEST_CASE("compile_commands.json with commands and with arguments") {
  const auto read = read_compile_commands(R"([{"directory": "/b", "file": "../s/a.cpp", "command": "g++ -c ../s/a.cpp"},
                                              {"directory": "/b", "file": "/s/b.cpp", "arguments": ["g++", "/s/b.cpp"], "output": "x"}])");
  REQUIRE(read);
  CHECK(read.value() == std::vector<CompileCommand>{{"/s/a.cpp", "/b", {"g++", "-c", "../s/a.cpp"}},
                                                    {"/s/b.cpp", "/b", {"g++", "/s/b.cpp"}, "x"}});
  const auto near = read_compile_commands(R"([{"directory": "b", "file": "../s/a.cpp", "command": "g++"}])");
  REQUIRE(near);
  const std::filesystem::path here = std::filesystem::current_path();
  CHECK(near.value() == std::vector<CompileCommand>{{here / "s/a.cpp", here / "b", {"g++"}}});
  CHECK(read_compile_commands("{").error() == CommandsFault{"it is no JSON", 1});
  CHECK(read_compile_commands("\n{}").error() == CommandsFault{"it is no JSON list", 1});
  CHECK(read_compile_commands(R"([{"file": "a.cpp"}])").error() ==
        CommandsFault{"its entry 1 needs `directory`, `file`, and `command` or `arguments`"});
}

TEST_CASE("response files that name themselves many times come to an end") {
  director::dsl::MemoryFiles files;
  files.add("/b/a.rsp", "@a.rsp @a.rsp @a.rsp @a.rsp @a.rsp @a.rsp @a.rsp @a.rsp");
  CHECK(with_response_files({"g++", "@a.rsp"}, "/b", files).size() < 20'000);
}

TEST_CASE("words of response files are in their place, and what cannot be read remains") {
  director::dsl::MemoryFiles files;
  files.add("/b/a.rsp", "-DA '-DB=b c'\r\n@sub/c.rsp");
  files.add("/b/sub/c.rsp", "-DC @/b/loop.rsp");
  files.add("/b/loop.rsp", "@loop.rsp");
  CHECK(with_response_files({"g++", "@a.rsp", "@gone.rsp", "@", "-c"}, "/b", files) ==
        Words{"g++", "-DA", "-DB=b c", "-DC", "@loop.rsp", "@gone.rsp", "@", "-c"});
  files.add("b/compile_commands.json",
            R"([{"directory": "/b", "file": "a.cpp", "command": "g++ @sub/c.rsp -o d/a.o -c a.cpp"}])");
  files.add("/b/loop.rsp", "-DL");
  CHECK(load_compile_commands("b", files).commands ==
        std::vector<CompileCommand>{{"/b/a.cpp", "/b", {"g++", "-DC", "-DL", "-o", "d/a.o", "-c", "a.cpp"}, "d/a.o"}});
}

TEST_CASE("files that flags include are looked for where the compiler runs, and in the folders") {
  CHECK(forced_includes({"-I", "i", "-include", "a.hpp", "-imacros/m.hpp", "-include-pch", "x"}, "/b") ==
        Words{"/m.hpp", "/b/a.hpp", "/b/i/a.hpp"});
  CHECK(fit_for_clang({"clang++", "-Xclang", "-include-pch", "-Xclang", "a.pch", "-Xclang", "-include", "-Xclang",
                       "a.hxx", "-c", "x.cpp"})
            .words == Words{"-include", "a.hxx"});
}

TEST_CASE("long forms of flags are equal to the short ones") {
  CHECK(fit_for_clang({"g++", "--include=a.hpp", "--include", "b.hpp", "--imacros=m.hpp", "--include-directory=i",
                       "--include-directory-after", "j", "--define-macro=A=1", "--undefine-macro", "B", "--sysroot=/s",
                       "x.cpp"})
            .words == Words{"-include", "a.hpp", "-include", "b.hpp", "-imacros", "m.hpp", "-I", "i", "-idirafter", "j",
                            "-D", "A=1", "-U", "B", "--sysroot=/s"});
}

TEST_CASE("what is defined by way of the preprocessor counts") {
  CHECK(fit_for_clang({"g++", "-Wp,-MD,a.d,-DSIM", "-Wp,-UHOST,-Iinclude", "-Wp,-D", "-Xpreprocessor", "-DREAL=1",
                       "-Xpreprocessor", "-MD", "-Xpreprocessor", "x.d", "x.cpp"})
            .words == Words{"-DSIM", "-UHOST", "-Iinclude", "-DREAL=1"});
}

TEST_CASE("compile_commands.json of a build, or what is wrong with it") {
  director::dsl::MemoryFiles files;
  const LoadedCommands absent = load_compile_commands("b", files);
  CHECK_FALSE(absent.was_read);
  CHECK(absent.fault == "cannot read `b/compile_commands.json`: No such file or directory; CMake writes it with "
                        "-D CMAKE_EXPORT_COMPILE_COMMANDS=ON");
  const auto fault = [&](const std::string& text) {
    files.add("b/compile_commands.json", text);
    const LoadedCommands wrong = load_compile_commands("b", files);
    CHECK(wrong.was_read);
    return wrong.fault;
  };
  CHECK(fault("{}") == "`b/compile_commands.json:1:1` is wrong: it is no JSON list");
  CHECK(fault("") == "`b/compile_commands.json:1:1` is wrong: it is no JSON");
  CHECK(fault("[\n  {\"file\": \"a.cpp\",,\n") == "`b/compile_commands.json:2:20` is wrong: it is no JSON");
  CHECK(fault("[\n  {\"file\": \"a.cpp\"}\n") == "`b/compile_commands.json:3:1` is wrong: it is no JSON");
  CHECK(fault("\n" + std::string(600, '[')) == "`b/compile_commands.json:2:501` is wrong: it is no JSON");
  CHECK(fault("[1]") ==
        "`b/compile_commands.json` is wrong: its entry 1 needs `directory`, `file`, and `command` or `arguments`");
}

TEST_CASE("the nearest compile_commands.json is in a folder, in its `build`, or in those above") {
  director::dsl::MemoryFiles files;
  CHECK(find_compile_commands("/u/robot/src", files).fault ==
        "no compile_commands.json can be read in `/u/robot/src` or above it");
  const std::string text = R"([{"directory": "/b", "file": "/s/a.cpp", "command": "g++"}])";
  for (const char* path : {"/build/compile_commands.json", "/u/compile_commands.json",
                           "/u/robot/build/compile_commands.json", "/u/robot/src/compile_commands.json"}) {
    files.add(path, text);
    const LoadedCommands found = find_compile_commands("/u/robot/src", files);
    CHECK(found.path == path);
    CHECK(found.fault.empty());
    CHECK(found.commands.size() == 1);
  }
  files.add("/u/robot/src/compile_commands.json", "{"); // a farther one does not replace it
  CHECK(find_compile_commands("/u/robot/src", files).fault ==
        "`/u/robot/src/compile_commands.json:1:2` is wrong: it is no JSON");
}

TEST_CASE("flags that only g++ knows are left out, and what is written too") {
  const Flags flags = fit_for_clang({"/usr/bin/ccache",
                                     "/usr/bin/g++",
                                     "-Iinclude",
                                     "-isystem",
                                     "/opt/x",
                                     "-DA=1",
                                     "-D",
                                     "B",
                                     "-O2",
                                     "-Wall",
                                     "-Werror",
                                     "-fno-var-tracking",
                                     "-fconcepts-diagnostics-depth=2",
                                     "-std=gnu++20",
                                     "--param",
                                     "max-inline=3",
                                     "-MD",
                                     "-MT",
                                     "a.o",
                                     "-MF",
                                     "a.d",
                                     "-fno-exceptions",
                                     "-include",
                                     "all.hpp",
                                     "--sysroot=/target",
                                     "-mcpu=cortex-m3",
                                     "-o",
                                     "a.o",
                                     "-c",
                                     "a.cpp"});
  CHECK(flags.compiler == "/usr/bin/g++");
  CHECK(flags.words == Words{"-Iinclude", "-isystem", "/opt/x", "-DA=1", "-D", "B", "-std=gnu++20", "-fno-exceptions",
                             "-include", "all.hpp", "--sysroot=/target", "-mcpu=cortex-m3"});
}

TEST_CASE("the compiler behind a launcher with options of its own is found, also in the folder of its entry") {
  const auto compiler = [](const Words& words) { return fit_for_clang(CompileCommand{"/s/a.cpp", "/b", words}); };
  for (const Words& launcher :
       {Words{"cmake", "-E", "env", "CCACHE_DIR=/c", "ccache"}, Words{"env", "-u", "X", "ccache"},
        Words{"env", "CXX=g++", "-u", "X", "ccache"}, Words{"taskset", "0x3"}, Words{"ionice", "-c", "2"},
        Words{"nice", "-n", "10"}, Words{"/usr/bin/ccache"}, Words{}}) {
    Words words = launcher;
    words.insert(words.end(), {"arm-none-eabi-g++-12", "-Ix", "-c", "a.cpp"});
    CHECK(compiler(words) == Flags{"arm-none-eabi-g++-12", {"-Ix"}});
  }
  for (const char* other : {"icpx", "em++", "x86_64-w64-mingw32-g++-posix"})
    CHECK(compiler({"ccache", other, "-Ix", "-I", "/opt/gcc", "-c", "src/motor.cc"}) ==
          Flags{other, {"-Ix", "-I", "/opt/gcc"}});
  CHECK(compiler({"nice", "-n", "10", "icpx", "-Ix", "-c", "src/motor.cc"}).words == Words{"-Ix"});
  CHECK(compiler({"./tools/g++", "-Ix"}) == Flags{"/b/tools/g++", {"-Ix"}});
  CHECK(compiler({"/usr/bin/cc", "-T", "link.ld", "-e", "start", "-iprefix", "/p", "-std=c++20"}) ==
        Flags{"/usr/bin/cc", {"-iprefix", "/p", "-std=c++20"}});
}

TEST_CASE("a file of C is read as one, and its compiler is queried for C") {
  const auto of = [](const std::string& file, const Words& words) {
    return fit_for_clang(CompileCommand{file, "/b", words}).words;
  };
  CHECK(of("/s/hal.c", {"gcc", "-std=c11", "-c", "hal.c"}) == Words{"-x", "c", "-std=c11"});
  CHECK(of("/s/hal.c", {"g++", "-x", "c++", "-c", "hal.c"}) == Words{"-x", "c++"});
  CHECK(of("/s/hal.cc", {"g++", "-c", "hal.cc"}).empty());
  CHECK(of("/s/hal.c", {"g++", "-std=c++20", "-c", "hal.c"}) == Words{"-std=c++20"});
  for (const char* of_cpp : {"g++", "/usr/bin/clang++-19", "g++-posix"})
    CHECK(of("/s/hal.c", {of_cpp, "-c", "hal.c"}).empty());
  CHECK(of("/s/hal.c", {"gcc", "-std=c++20", "-c", "hal.c"}) == Words{"-std=c++20"});
  CHECK(of("/s/hal.c", {"gcc", "-c", "hal.c"}) == Words{"-x", "c"});
  Compiler compiler;
  Compilers(compiler).complete({"gcc", {"-x", "c", "-std=c11"}});
  CHECK(compiler.question ==
        Words{"sh", "-c", "exec \"$0\" \"$@\" 2>&1", "gcc", "-std=c11", "-v", "-E", "-x", "c", "/dev/null"});
}

TEST_CASE("a g++ is queried for its target and its folders, once for each way of calling it") {
  Compiler compiler;
  compiler.answer = {true, 0,
                     "Target: arm-none-eabi\n#include \"...\" search starts here:\n#include <...> search starts here:\n"
                     " /usr/lib/gcc/arm-none-eabi/12/../../../arm-none-eabi/include/c++/12\n"
                     " /usr/lib/gcc/arm-none-eabi/12/include\n /usr/lib/gcc/arm-none-eabi/12/include-fixed\n"
                     " /usr/arm-none-eabi/include\nEnd of search list.\n"};
  Compilers compilers(compiler);
  const Flags flags{"arm-none-eabi-g++", {"-Ix", "-mcpu=cortex-m3", "-std=c++20"}};
  const Words expected{"-Ix",         "-mcpu=cortex-m3",
                       "-std=c++20",  "--target=arm-none-eabi",
                       "-nostdinc++", "-nostdlibinc",
                       "-isystem",    "/usr/lib/arm-none-eabi/include/c++/12",
                       "-idirafter",  "/usr/arm-none-eabi/include"};
  CHECK(compilers.complete(flags) == expected);
  CHECK(compilers.complete({"arm-none-eabi-g++", {"-Iy", "-mcpu=cortex-m3", "-std=c++20"}}).front() == "-Iy");
  CHECK(compiler.calls == 1);
  CHECK(compiler.question == Words{"sh", "-c", "exec \"$0\" \"$@\" 2>&1", "arm-none-eabi-g++", "-mcpu=cortex-m3",
                                   "-std=c++20", "-v", "-E", "-x", "c++", "/dev/null"});
}

TEST_CASE("a clang, or a compiler that is not there, changes nothing") {
  Compiler compiler;
  Compilers compilers(compiler);
  CHECK(compilers.complete({"/usr/bin/clang++-19", {"-Ix"}}) == Words{"-Ix"});
  CHECK(compiler.calls == 0);
  CHECK(compilers.complete({"lost-g++", {"-Ix"}}) == Words{"-Ix"});
}

TEST_CASE("folders in the order in which they are looked into") {
  CHECK(include_folders({"-isystem", "/s", "-Ia/../b", "-DX", "-iquote", "q", "-I", "/c"}, "/d") ==
        Words{"/d/q", "/d/b", "/c", "/s"});
  CHECK(include_folders({"-isystem", "/s", "-Ia/../b", "-iquote", "q"}, "/d", true) == Words{"/d/b", "/s"});
}

TEST_CASE("whether a file may include the generated header") {
  director::dsl::MemoryFiles files;
  files.add("/s/main.cpp", "#include <vector>\n  #  include \"player/a.hpp\"\n");
  files.add("/s/player/a.hpp", "#include \"b.hpp\"\n");
  files.add("/s/player/b.hpp", "#include <soccer.hpp> // here\n#include \"a.hpp\"\n");
  files.add("/s/other.cpp", "#include \"player/c.hpp\"\n// #include \"soccer.hpp\"\n");
  files.add("/s/player/c.hpp", "");
  files.add("/s/odd.cpp", "#include WHATEVER\n");
  files.add("/g/soccer.hpp", "");
  Includes includes(files);
  CHECK(includes.may_include("/s/main.cpp", {"/g"}, "/g/soccer.hpp"));
  CHECK_FALSE(includes.may_include("/s/main.cpp", {"/h"}, "/g/soccer.hpp"));
  CHECK_FALSE(includes.may_include("/s/other.cpp", {"/g"}, "/g/soccer.hpp"));
  CHECK(includes.may_include("/s/odd.cpp", {"/g"}, "/g/soccer.hpp"));
}

TEST_CASE("an include is found in whatever way a compiler may read it") {
  const auto includes_it = [](const std::string& text) {
    director::dsl::MemoryFiles files;
    files.add("/s/main.cpp", text);
    files.add("/g/soccer.hpp", "");
    return Includes(files).may_include("/s/main.cpp", {"/g"}, "/g/soccer.hpp");
  };
  for (const char* const text :
       {"\xEF\xBB\xBF#include \"soccer.hpp\"", "\xEF\xBB\xBF #include \"soccer.hpp\"\r\n",
        "/* licence */ #include \"soccer.hpp\"\n", "/* of\n * many */#include <soccer.hpp>\n",
        "# /* a */ include /* b\n */ \"soccer.hpp\"\n", "#import \"soccer.hpp\"\n", "#include_next <soccer.hpp>\n",
        "int i;\n\f\v#\finclude\t<soccer.hpp>\n", "#inc\\\nlude \"soc\\\r\ncer.hpp\"\n",
        "#include \\  \n  \"soccer.hpp\"\n", "int i;\r#include \"soccer.hpp\"\rint j;\r", "#include\"soccer.hpp\""}) {
    CAPTURE(text);
    CHECK(includes_it(text));
  }
  for (const char* const text :
       {"", "#", "// a \\\n#include \"soccer.hpp\"\n", "const char* s = \"#include \\\"soccer.hpp\\\"\";\n",
        "#define A #include \"soccer.hpp\"\n", "#if 1 /*\n", "\xEF\xBB\xBF"}) {
    CAPTURE(text);
    CHECK(!includes_it(text));
  }
}

} // namespace
