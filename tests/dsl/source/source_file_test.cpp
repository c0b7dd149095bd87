// SPDX-License-Identifier: MIT
// Tests dsl/source/source_file.hpp.
#include "dsl/source/source_file.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("Lines and columns count from 1, columns in bytes") {
  const SourceFile file("a.yaml", "äb\n\ncd");
  CHECK(file.place(0) == Place{1, 1});
  CHECK(file.place(2) == Place{1, 3});
  CHECK(file.place(3) == Place{1, 4}); // the line break belongs to its line
  CHECK(file.place(4) == Place{2, 1});
  CHECK(file.place(6) == Place{3, 2});
  CHECK(file.place(7) == Place{3, 3});
  CHECK(file.place(99) == Place{3, 3});
  CHECK(SourceFile("empty", "").place(0) == Place{1, 1});
}

TEST_CASE("A line is given without its break, of either kind") {
  const SourceFile file("a.yaml", "one\r\ntwo\n");
  CHECK(file.line_count() == 3);
  CHECK(file.line_text(1) == "one");
  CHECK(file.line_text(2) == "two");
  CHECK(file.line_text(3) == "");
  CHECK(file.line_text(4) == "");
  CHECK(file.line_text(0) == "");
  CHECK(file.line_begin(2) == 5);
  CHECK(file.line_begin(9) == 9);
}

TEST_CASE("Files stay where they are while others are added") {
  Sources sources;
  const FileId first = sources.add("first", "abc");
  const std::string_view text = sources[first].text();
  for (int i = 0; i < 100; ++i) sources.add("more", "def");
  CHECK(sources[first].text().data() == text.data());
  CHECK(sources.size() == 101);
  CHECK(sources.text({first, 1, 3}) == "bc");
  CHECK(sources.text({first, 9, 12}) == "");
  CHECK(sources.text({{500}, 0, 1}) == "");
}
