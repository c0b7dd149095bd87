// SPDX-License-Identifier: MIT
#include "compiler/page/html/parts.hpp"

#include <catch2/catch.hpp>

using director::compiler::page::svg_part;

TEST_CASE("of a file of Graphviz a page has the picture alone, without ids, comments and what is so anyway") {
  CHECK(svg_part("<?xml?>\n<!-- a -->\n<svg role=\"x\" id=\"s\">\n<!-- b -->\n<text text-anchor=\"start\" x=\"1\" "
                 "stroke=\"transparent\" "
                 "font-family=\"Helvetica,sans-Serif\">a</text>\n</svg>\n") ==
        "<svg role=\"x\"><text x=\"1\">a</text></svg>");
}

TEST_CASE("a link within the same link is left out, one to elsewhere is not; the group around an outer link is") {
  CHECK(svg_part("<svg>\n<g><a href=\"1\">\n<g><a href=\"1\">\n<text>a</text>\n</a>\n</g>\n<g><a href=\"2\">\n"
                 "<text>b</text>\n</a>\n</g>\n</a>\n</g>\n<g><a href=\"1\">\n<text>c</text>\n</a>\n</g>\n</svg>") ==
        "<svg><a href=\"1\"><text>a</text><g><a href=\"2\"><text>b</text></a></g></a><a href=\"1\"><text>c</text></a>"
        "</svg>");
  // Not closed: the links are unchanged.
  CHECK(svg_part("<svg><g><a href=\"1\">\n<g><a href=\"2\"") == "<svg><g><a href=\"1\"><g><a href=\"2\"");
}

TEST_CASE("coordinates of lines are written to a tenth of a point") {
  CHECK(svg_part(
            "<svg><path d=\"M594.07,-1774.75C597.1,-1743.61 605,-0.04 7.96,1.25\"/><polygon points=\"654.33,-1593.05 "
            "2,3\"/><text x=\"1.25\">594.07</text></svg>") ==
        "<svg><path d=\"M594.1,-1774.8C597.1,-1743.6 605,-0 8,1.2\"/><polygon points=\"654.3,-1593 2,3\"/>"
        "<text x=\"1.25\">594.07</text></svg>");
}
