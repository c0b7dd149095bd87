// SPDX-License-Identifier: MIT
// Tests dsl/lexical/cpp_type.hpp. The messages: compiler/checks/bad_type.md, bad_header.md.
#include "dsl/lexical/cpp_type.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

std::string said_of(const std::string& text) {
  const auto fault = data_fault(text);
  return fault ? fault->message : "";
}

} // namespace

TEST_CASE("A task can carry a type of a name, of arguments, of the language, and a pointer") {
  for (const char* text : {"int",
                           "unsigned char",
                           "long long int",
                           "char8_t",
                           "Course",
                           "robot::Course",
                           "::robot::Course",
                           ":: robot :: Course",
                           "std::array<int, 3>",
                           "std::array<robot::Course,-1>",
                           "Box<>",
                           "Box<true>",
                           "Box<Box<Box<int>>>::Inner<3>",
                           "const int*",
                           "int const *",
                           "void*",
                           "const robot::Map* const*",
                           "std::function<int(const robot::Map&, Course&&, int[], int[3])>",
                           "std::unique_ptr<int[]>",
                           "const volatile int* const volatile*",
                           "Box<0, 017, 0X1f, 0b11, 8u, 8LL, 8uLL>",
                           "_1",
                           "a_",
                           "Box<0x1Fu, 1'0>"})
    CHECK(
        said_of(text) ==
        (std::string(text) == "Box<0x1Fu, 1'0>" ? "`Box<0x1Fu, 1'0>` is no type of C++: expected `>`, found `'`" : ""));
}

TEST_CASE("A type is read to its end, and the message has what was expected where") {
  const auto wrong = [](const std::string& text, const std::string& why) {
    CHECK(said_of(text) == "`" + text + "` is no type of C++: " + why);
  };
  wrong("two words", "expected the end, found `words`");
  wrong("robot::", "expected a type of C++, found nothing");
  wrong("robot::int", "expected a type of C++, found `int`");
  wrong("struct robot::Course", "expected a type of C++, found `struct`");
  wrong("auto", "expected a type of C++, found `auto`");
  wrong("decltype(x)", "expected a type of C++, found `decltype`");
  wrong("unsigned double", "expected the end, found `double`");
  wrong("5", "expected a type of C++, found `5`");
  wrong("Box<3abc>", "expected a type of C++, found `3abc`");
  wrong("Box<0x>", "expected a type of C++, found `0x`");
  wrong("Box<08>", "expected a type of C++, found `08`");
  wrong("Box<0b2>", "expected a type of C++, found `0b2`");
  wrong("Box<1e5>", "expected a type of C++, found `1e5`");
  wrong("Box<3ulu>", "expected a type of C++, found `3ulu`");
  wrong("const const int*", "expected a type of C++, found `const`");
  wrong("const int const*", "expected the end, found `const`");
  wrong("int* const const", "expected the end, found `const`");
  wrong("a.b", "expected the end, found `.`");
  wrong("a{}", "expected the end, found `{`");
  wrong("a /* b", "expected the end, found `/`");
  wrong("a\"", "expected the end, found `\"`");
  wrong("Box<int", "expected `>`, found nothing");
  wrong("Box<int>>", "expected the end, found `>`");
  wrong("Box<int(int>", "expected `)`, found `>`");
  wrong("Box<;>", "expected a type of C++, found `;`");
  wrong("int[x]", "expected `]`, found `x`");
  wrong(" ", "expected a type of C++, found nothing");
  wrong("gr\xC3\xB6\xC3\x9F"
        "e",
        "expected the end, found `\xC3\xB6`");
  CHECK(said_of("int\n") == "this is no type of C++: it has control characters");
  CHECK(said_of("int\xE2\x80\xAE") == "this is no type of C++: it has control characters");
}

TEST_CASE("What the preprocessor replaces is no type, at any place") {
  const std::string macro = " is a macro of the standard headers of C++";
  CHECK(said_of("EOF") == "`EOF` is no type of C++: `EOF`" + macro);
  CHECK(said_of("robot::errno*") == "`robot::errno*` is no type of C++: `errno`" + macro);
  CHECK(said_of("std::vector<NULL>") == "`std::vector<NULL>` is no type of C++: `NULL`" + macro);
  CHECK(said_of("DIRECTOR_INLINE") ==
        "`DIRECTOR_INLINE` is no type of C++: names that begin with `DIRECTOR_` are macros of Director's own");
  CHECK(said_of("linux::Course").empty()); // a macro of some compilers, and a namespace for others
  CHECK(said_of("std::FILE*").empty());
}

TEST_CASE("Brackets within brackets end somewhere") {
  std::string text = "int";
  for (int i = 0; i < 16; ++i) text = "A<" + text + ">";
  CHECK(said_of(text).empty());
  CHECK(said_of("A<" + text + ">") ==
        "`A<" + text + ">` is no type of C++: expected fewer brackets within brackets, found `int`");
  CHECK(data_fault(std::string(100'000, '<')));
  std::string open;
  for (int i = 0; i < 100'000; ++i) open += "A<";
  CHECK(data_fault(open));
}

TEST_CASE("What cannot be stored by value is refused, within arguments it is not") {
  CHECK(said_of("int&&") == "no task can carry `int&&`: that is a reference");
  CHECK(said_of("int* const") == "no task can carry `int* const`: that is const or volatile");
  CHECK(said_of("int(int)") == "no task can carry `int(int)`: that is a function");
  CHECK(said_of("const void") == "no task can carry `const void`: there is nothing in it");
  CHECK(said_of("robot::voids").empty());
}

TEST_CASE("The first word of each name in a type is known, and how it is looked up") {
  using Words = std::vector<FirstWord>;
  CHECK(
      first_words("std::array<robot::Course<a, ::b, ::c::d>, 3>") ==
      Words{{"std", false, false}, {"robot", false, false}, {"a", false, true}, {"b", true, true}, {"c", true, false}});
  CHECK(first_words("const int*").empty());
}

TEST_CASE("A plain type has neither blanks nor `::` before it") {
  CHECK(plain_type(":: g :: Phase ") == "g::Phase");
  CHECK(plain_type("g::Phase") == "g::Phase");
}

TEST_CASE("Two spellings of a type are the same but for blanks") {
  CHECK(is_same_type("g::Phase", "g :: Phase "));
  CHECK(is_same_type("g::Tm<int>::E", "g::Tm< int >::E"));
  CHECK_FALSE(is_same_type("g::Phase", "g::Phases"));
  CHECK_FALSE(is_same_type("g::Phase", "g::Phase::E"));
  CHECK_FALSE(is_same_type("g::Phase", "::g::Phase"));
}
