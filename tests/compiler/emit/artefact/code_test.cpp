// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/code.hpp"

#include <catch2/catch.hpp>

namespace {

using director::compiler::Code;
using Texts = std::vector<std::string>;

TEST_CASE("lines have the indent of their block, and preprocessor directives have none") {
  Code code;
  code.open("struct Walk {");
  code.outdented("public:");
  code.open("int steps() {");
  code.line("#ifdef FAST");
  code.line("return 2;");
  code.close("}");
  code.close("};");
  CHECK(code.text() == "struct Walk {\npublic:\n  int steps() {\n#ifdef FAST\n    return 2;\n  }\n};\n");
}

TEST_CASE("a blank line is neither behind another nor behind what opens a block") {
  Code code;
  code.blank();
  code.open("struct A {");
  code.blank();
  code.line("int a;");
  code.blank();
  code.blank();
  code.close("};");
  code.line("namespace b {");
  code.blank();
  code.line("} // namespace b");
  CHECK(code.text() == "struct A {\n  int a;\n\n};\nnamespace b {\n\n} // namespace b\n");
}

TEST_CASE("a list is broken between items where it does not fit") {
  Code code;
  code.list("f(", {"a", "b"}, ");");
  code.list("using All = List<", Texts(3, std::string(60, 'x')), ">;");
  code.list("g(", {}, ");");
  code.list("struct All : ", Texts(2, std::string(60, 'x')), " {};"); // no blank is left behind
  const std::string x(60, 'x');
  CHECK(code.text() == "f(a, b);\nusing All = List<\n    " + x + ",\n    " + x + ",\n    " + x +
                           ">;\ng();\nstruct All :\n    " + x + ",\n    " + x + " {};\n");
  Code full; // what is behind the last item has to fit too
  full.list("using All = List<", {x, std::string(53, 'x')}, ">;");
  CHECK(full.text() == "using All = List<\n    " + x + ",\n    " + std::string(53, 'x') + ">;\n");
}

TEST_CASE("a comment is broken between words and holds nothing that a compiler would stumble over") {
  Code code;
  code.comment("One two.\nC:\\", "//");
  code.comment("a\tb \xE2\x80\xAE"
               "c");
  CHECK(code.text() == "// One two.\n// C:\\.\n/// a b c\n");
  Code wide;
  wide.comment(std::string(70, 'a') + " " + std::string(70, 'b'));
  CHECK(wide.lines().size() == 2);
}

TEST_CASE("a block keeps its own steps within the block it is put into") {
  Code code;
  code.open("{");
  code.block("if (a) {\n  b();\n}\n");
  code.close("}");
  CHECK(code.text() == "{\n  if (a) {\n    b();\n  }\n}\n");
}

} // namespace
