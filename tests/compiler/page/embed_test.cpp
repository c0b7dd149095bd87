// SPDX-License-Identifier: MIT
// compiler/cmake/embed_page.cmake: a page as a C++ text, in pieces.
#include "tests/support/golden.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <string>

namespace {

using namespace director::tests;

TEST_CASE("a page that is compiled in is cut between characters, also where these are of several bytes") {
  const OwnFolder folder("embed");
  for (std::size_t before = 0; before < 4; ++before) {
    CAPTURE(before);
    std::string page(7'990 + before, 'a');
    for (std::size_t i = 0; i < 2'000; ++i) page += "\u25b6 \u00e9; [x] \\\n";
    std::ofstream(folder.path / "page.html") << page;
    const std::string in = "cd '" + folder.path.string() + "' && cmake -D PAGE=page.html -D HEADER=page.hpp -D " +
                           "FUNCTION=page -D OUT=page.cpp -P '" +
                           (source_dir() / "compiler/cmake/embed_page.cmake").string() + "'";
    REQUIRE(std::system(in.c_str()) == 0);
    const std::string source = read_file(folder.path / "page.cpp");
    const std::string begin = "R\"page(", end = ")page\"";
    std::string all;
    std::size_t pieces = 0;
    for (std::size_t at = source.find(begin); at != std::string::npos; at = source.find(begin, at)) {
      at += begin.size();
      const std::string piece = source.substr(at, source.find(end, at) - at);
      REQUIRE_FALSE(piece.empty());
      CHECK((static_cast<unsigned char>(piece.front()) & 0xC0U) != 0x80U);
      all += piece;
      ++pieces;
    }
    CHECK(pieces > 3);
    CHECK(all == page);
  }
}

} // namespace
