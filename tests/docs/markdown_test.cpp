// SPDX-License-Identifier: MIT
#include "tests/docs/markdown.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;

namespace {

Lines texts(const std::vector<Inline>& all) {
  Lines lines;
  for (const Inline& each : all) lines.push_back(each.text);
  return lines;
}

} // namespace

TEST_CASE("a page is taken apart into blocks with the comments before them") {
  const Markdown page = read_markdown("# Title\n"
                                      "<!-- file: a.yaml -->\n"
                                      "```yaml\n"
                                      "# no heading\n"
                                      "[no](link.md)\n"
                                      "```\n"
                                      "<!-- check\n"
                                      "groups: {} -->\n"
                                      "\n"
                                      "```\n"
                                      "```\n"
                                      "<!-- this speaks of the next line -->\n"
                                      "words\n"
                                      "```\n"
                                      "x\n"
                                      "```\n");
  REQUIRE(page.blocks.size() == 3);
  CHECK(page.blocks[0].comment == "file: a.yaml");
  CHECK(page.blocks[0].line == 2);
  CHECK(page.blocks[0].lines == Lines{"# no heading", "[no](link.md)"});
  CHECK(page.blocks[1].comment == "check\ngroups: {}");
  CHECK(page.blocks[1].lines.empty());
  CHECK(page.blocks[2].comment.empty());
  CHECK(page.links.empty());
  CHECK(page.anchors == Lines{"title"});
}

TEST_CASE("headings have the anchors that GitHub gives them") {
  const Markdown page = read_markdown("# A push, step by step\n## `expires`\n### Why?\n## Why?\n");
  CHECK(page.anchors == Lines{"a-push-step-by-step", "expires", "why", "why-1"});
}

TEST_CASE("links, pictures and code are found within lines") {
  const Markdown page = read_markdown("See [a](a.md#b), `[no](link.md)` and [c](c.md).\n"
                                      "<!-- run: draw -->\n"
                                      "![drawn](d.svg)\n"
                                      "\n"
                                      "    indented\n");
  CHECK(texts(page.links) == Lines{"a.md#b", "c.md", "d.svg"});
  CHECK(texts(page.code) == Lines{"[no](link.md)"});
  REQUIRE(page.pictures.size() == 1);
  CHECK(page.pictures[0].comment == "run: draw");
  CHECK(page.pictures[0].target == "d.svg");
  CHECK(texts(page.indented) == Lines{"    indented"});
}

TEST_CASE("blocks get other lines, and everything else stays") {
  const Markdown page = read_markdown("one\n```\na\nb\n```\ntwo\n```sh\n```\n");
  CHECK(with_blocks(page, {{"c"}, {"d", "e"}}) == "one\n```\nc\n```\ntwo\n```sh\nd\ne\n```\n");
}
