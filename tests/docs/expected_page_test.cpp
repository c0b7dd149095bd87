// SPDX-License-Identifier: MIT
#include "tests/docs/comment.hpp"
#include "tests/docs/expected_page.hpp"
#include "tests/support/command.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;

namespace {

ExpectedPage expected(const std::string& text) { return expected_page("page.md", read_markdown(text)); }

std::string page(const std::string& comment, const std::string& block) {
  return (comment.empty() ? "" : "<!-- " + comment + " -->\n") + "```\n" + block + "```\n";
}

/// A page with one block that is as it should be.
void stays(const std::string& comment, const std::string& block) {
  const ExpectedPage result = expected(page(comment, block));
  CHECK(result.text == page(comment, block));
  CHECK(result.faults == std::vector<std::string>{});
}

} // namespace

TEST_CASE("a comment has a kind, options and an argument") {
  const Comment comment = read_comment("file, from \"a: b, c\", exit 1: some: thing\nmore\nlines");
  CHECK(comment.word == "file");
  CHECK(comment.options == std::map<std::string, std::string>{{"from", "a: b, c"}, {"exit", "1"}});
  CHECK(comment.argument == "some: thing");
  CHECK(comment.rest == "more\nlines");
  CHECK(read_comment("not run: because").word == "not run");
}

TEST_CASE("a command runs in its folder and its exit status is compared") {
  const TemporaryFolder folder;
  const Ran ran = run_command("pwd && echo wrong >&2 && exit 3", folder.path());
  CHECK(ran.status == 3);
  CHECK(ran.output == folder.path().string() + "\nwrong\n");
}

TEST_CASE("a block may be a file or a part of it") {
  const std::string file = "tests/support/command.hpp";
  stays("file: " + file, "#pragma once\n…\n} // namespace director::tests\n");
  stays("file, from \"struct Ran\", to \"};\": " + file, "struct Ran {\n  int status = 0;\n  std::string output; ///< "
                                                         "what it printed, and its errors, as they come\n};\n");
  stays("file, from \"int status\", before \"};\": " + file,
        "int status = 0;\nstd::string output; ///< what it printed, and its errors, as they come\n");
  CHECK(expected(page("file, to \"once\": " + file, "something\n")).text ==
        page("file, to \"once\": " + file, "#pragma once\n"));
}

TEST_CASE("a block may be what a command prints") {
  stays("run: printf 'a\\nb\\n'", "a\nb\n");
  stays("run, exit 4: echo no && exit 4", "no\n");
  stays("session", "$ echo one\none\n$ printf '1\\n2\\n3\\n'\n…\n3\n");
  stays("session, in \"tests/docs\"", "$ ls expected_page.hpp\nexpected_page.hpp\n");
  CHECK(expected(page("run: echo b", "a\n")).text == page("run: echo b", "b\n"));
}

TEST_CASE("a block may be left alone, if it has a reason") { stays("not run: there is no robot here", "./walk\n"); }

TEST_CASE("what cannot be found out is a fault, at its place") {
  const auto fault = [](const std::string& comment, const std::string& block = "") {
    return expected("words\n" + page(comment, block)).faults;
  };
  const auto is = [](const std::string& what) { return std::vector{"page.md:3: " + what}; };
  CHECK(expected(page("", "x\n")).faults ==
        std::vector<std::string>{"page.md:1: no comment says where this block comes from"});
  CHECK(fault("wrong: x") == is("nobody knows the comment `wrong`"));
  CHECK(fault("not run") == is("say why it is not run"));
  CHECK(fault("file: no/such.yaml") == is("there is no file no/such.yaml"));
  CHECK(fault("file, from \"no such line\": README.md") == is("no line of README.md holds no such line"));
  CHECK(fault("run: echo no && exit 4") == is("echo no && exit 4 ends with 4:\nno\n"));
  CHECK(fault("session", "echo\n") == is("there is no command, a line that begins with $"));
  CHECK(fault("session, in \"no/such\"", "$ echo\n") == is("there is no folder no/such"));
  CHECK(fault("output: ./finish") == is("nobody knows what ./finish prints"));
  CHECK(fault("findings") == is("there is no block before that is checked"));
}
