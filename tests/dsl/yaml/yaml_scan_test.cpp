// SPDX-License-Identifier: MIT
// Tests dsl/yaml/yaml_scan.hpp.
#include "dsl/yaml/yaml_scan.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;
using namespace std::string_view_literals;

TEST_CASE("Bytes that no text has are found") {
  struct Row {
    std::string_view text;
    std::size_t begin, end;
    const char* message;
  };
  for (const Row& row : {
           Row{"ab\0"sv, 2, 3, "the byte 0x00 may not stand in a text"},
           Row{"a\x1B["sv, 1, 2, "the byte 0x1B may not stand in a text"},
           Row{"a\x7F"sv, 1, 2, "the byte 0x7F may not stand in a text"},
           Row{"a\rb"sv, 1, 2, "the byte 0x0D may not stand in a text"},
           Row{"\xEF\xBB\xBF"
               "a"sv,
               0, 3, "the file begins with a byte order mark"},
           Row{"\xFF\xFE"
               "a\0"sv,
               0, 2, "the file is UTF-16, expected UTF-8"},
           Row{"\xFE\xFF\0a"sv, 0, 2, "the file is UTF-16, expected UTF-8"},
           Row{"\0a"sv, 0, 2, "the file is UTF-16, expected UTF-8"},
           Row{"a\0b\0"sv, 0, 2, "the file is UTF-16, expected UTF-8"},
           Row{"\xFF\xFE\0\0a\0\0\0"sv, 0, 4, "the file is UTF-32, expected UTF-8"},
           Row{"\0\0\xFE\xFF\0\0\0a"sv, 0, 4, "the file is UTF-32, expected UTF-8"},
           Row{"\0\0\0a"sv, 0, 4, "the file is UTF-32, expected UTF-8"},
           Row{"a\0\0\0"sv, 0, 4, "the file is UTF-32, expected UTF-8"},
           Row{"a\x80"sv, 1, 2, "the byte 0x80 is not UTF-8"},
           Row{"a\xC3"sv, 1, 2, "the byte 0xC3 is not UTF-8"},
           Row{"\xC0\xAF"sv, 0, 1, "the byte 0xC0 is not UTF-8"},         // overlong
           Row{"\xE0\x80\xAF"sv, 0, 1, "the byte 0xE0 is not UTF-8"},     // overlong
           Row{"\xED\xA0\x80"sv, 0, 1, "the byte 0xED is not UTF-8"},     // half of a surrogate pair
           Row{"\xF4\x90\x80\x80"sv, 0, 1, "the byte 0xF4 is not UTF-8"}, // above U+10FFFF
           Row{"\xF0\x9F\x98"sv, 0, 1, "the byte 0xF0 is not UTF-8"},
       }) {
    CAPTURE(row.text);
    const auto fault = yaml_scan::forbidden_bytes(row.text);
    REQUIRE(fault);
    CHECK(fault->begin == row.begin);
    CHECK(fault->end == row.end);
    CHECK(fault->message == row.message);
  }
  CHECK_FALSE(yaml_scan::forbidden_bytes("a: ä € 😀\t\r\n\xEF\xBF\xBD\xED\x9F\xBF\xF4\x8F\xBF\xBF"));
}

TEST_CASE("A tab in the indentation counts where something follows") {
  CHECK(yaml_scan::tab_in_indentation("a\n \tb\n", 4) == 3);
  CHECK(yaml_scan::tab_in_indentation("\ta", 1) == 0);
  for (const char* line : {"a\tb", "  a\t", "\t# c", "\t", "\t\n", "\t\r\n", ""}) {
    CAPTURE(line);
    CHECK_FALSE(yaml_scan::tab_in_indentation(line, 0));
  }
}

TEST_CASE("A quoted text ends at the quote that is not part of it") {
  CHECK(yaml_scan::end_of_quoted("'it''s' x", 0) == 7);
  CHECK(yaml_scan::end_of_quoted("\"a\\\"b\\\\\" x", 0) == 8);
  CHECK(yaml_scan::end_of_quoted("x ''", 2) == 4);
  CHECK_FALSE(yaml_scan::end_of_quoted("'it''", 0));
  CHECK_FALSE(yaml_scan::end_of_quoted("\"a\\", 0));
  CHECK(yaml_scan::unclosed_quote("a: it's # don't\nb: 'x' \"y", 0) == 23);
  CHECK_FALSE(yaml_scan::unclosed_quote("a: it's # don't\nb: 'x'", 0));
}

TEST_CASE("Comments begin behind blanks only") {
  CHECK(yaml_scan::skip_blanks("  # a\n\t# b\r\n c", 0) == 13);
  CHECK(yaml_scan::skip_blanks("a#b", 1) == 1);
  CHECK(yaml_scan::skip_blanks("# a", 0) == 3);
}

TEST_CASE("A place in a plain text is found over its line breaks") {
  const auto place = [](std::string_view text, std::string_view value, std::size_t index) {
    return yaml_scan::places_in_plain(text, 0, value).at(index);
  };
  CHECK(place("one  \n   two x", "one two x", 4) == 9);
  CHECK(place("one\n\n  two", "one\ntwo", 4) == 7);
  CHECK(place("one two", "one two", 7) == 7);
  CHECK(place("one", "other", 5) == 1); // only from where they differ on
  CHECK(place("", "", 0) == 0);
}

TEST_CASE("A block scalar ends before the line that is indented less") {
  const auto end = [](std::string_view text, std::size_t least) {
    return text.substr(0, yaml_scan::block_scalar(text, 0, least).end);
  };
  CHECK(end("|\n  a\n\n   b\n c", 2) == "|\n  a\n\n   b");
  CHECK(end("|\na", 1) == "|");
  CHECK(end("| # c\n\n", 1) == "| # c");
  CHECK(end("|1\n   a\n  b\n c", 2) == "|1\n   a\n  b");
  CHECK(end(">+\n a\n\n", 1) == ">+\n a");
  CHECK(end("|\na\n...\n", 0) == "|\na");
}
