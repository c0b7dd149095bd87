// SPDX-License-Identifier: MIT
// Tests dsl/source/shortened.hpp.
#include "dsl/lexical/characters.hpp"
#include "dsl/source/shortened.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

} // namespace

TEST_CASE("A text of readable length is unchanged") {
  const std::string path(longest_quotation, 'p');
  CHECK(shortened("cannot read `" + path + "`: no such file") == "cannot read `" + path + "`: no such file");
  CHECK(shortened(std::string(longest_message, '`')) == std::string(longest_message, '`'));
}

TEST_CASE("Of a long quotation the beginning and the end are kept") {
  const std::string text = std::string(372, 'a') + std::string(100'000, 'b') + std::string(125, 'c');
  CHECK(shortened("`x` is no `" + text + "` of `" + text + "`; did you mean `y`?") ==
        "`x` is no `" + std::string(372, 'a') + "…" + std::string(125, 'c') + "` of `" + std::string(372, 'a') + "…" +
            std::string(125, 'c') + "`; did you mean `y`?");
}

TEST_CASE("Of a long message the beginning and the end are kept, whatever is quoted in it") {
  const std::string text = std::string(3747, 'a') + std::string(100'000, 'b') + std::string(1250, 'c');
  CHECK(shortened(text) == std::string(3747, 'a') + "…" + std::string(1250, 'c'));
  std::string names;
  for (int i = 0; i < 2000; ++i) names += "`name`, ";
  CHECK(shortened(names).size() == longest_message);
  CHECK(shortened(shortened(names)) == shortened(names));
}

TEST_CASE("No character is cut in two") {
  for (std::size_t shift = 0; shift < 4; ++shift) {
    std::string text(shift, 'x');
    for (int i = 0; i < 3000; ++i) text += "\U0001F916";
    const std::string quoted = shortened("`" + text + "`"), whole = shortened(text);
    CAPTURE(shift);
    for (const std::string& each : {quoted, whole}) {
      CHECK(is_utf8(each));
      CHECK(each.size() <= longest_message);
      CHECK(each.find("\U0001F916…\U0001F916") != std::string::npos);
    }
  }
}

TEST_CASE("Of very many names the first are listed") {
  CHECK(shortened_list({}).empty());
  CHECK(shortened_list({"a", "b"}) == "a, b");
  std::string first = "a";
  for (std::size_t i = 1; i < most_names_listed; ++i) first += ", a";
  CHECK(shortened_list(std::vector<std::string>(most_names_listed, "a")) == first);
  CHECK(shortened_list(std::vector<std::string>(most_names_listed + 97, "a")) == first + " and 97 more");
}
