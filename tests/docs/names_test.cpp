// SPDX-License-Identifier: MIT
#include "tests/docs/names.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;

TEST_CASE("a link must lead to a file, or to a heading in it") {
  const Markdown page = read_markdown("# Here\n[a](#here) [b](markdown.hpp) [c](https://example.org/x#y)\n"
                                      "[d](#there) [e](no.md)\n[f](../../docs/README.md#nowhere)\n[g](../../start#L2) "
                                      "[h](../../start#L9999)\n");
  CHECK(link_faults("tests/docs/page.md", page) ==
        std::vector<std::string>{"tests/docs/page.md:3: there is no heading #there",
                                 "tests/docs/page.md:3: there is no no.md",
                                 "tests/docs/page.md:4: there is no heading #nowhere in ../../docs/README.md",
                                 "tests/docs/page.md:5: ../../start has no line 9999"});
}

TEST_CASE("a file of the source tree that is between backticks must exist") {
  const Markdown page = read_markdown(
      "`docs/README.md` `./start` `build/any` `and/or` `tests/*` `soccer.yaml`\n`docs/no.md` `./finish`\n");
  CHECK(name_faults("page.md", page) ==
        std::vector<std::string>{"page.md:2: there is no `docs/no.md`", "page.md:2: there is no `./finish`"});
}

TEST_CASE("a command that is between backticks must exist, with its options") {
  const Markdown page = read_markdown("`directorc --version` `directorc check --format=json soccer.yaml`\n"
                                      "`directorc cook` `directorc check --hard` `directorc --hard`\n");
  CHECK(name_faults("page.md", page) == std::vector<std::string>{"page.md:2: `directorc` has no command cook",
                                                                 "page.md:2: `directorc check` has no option --hard",
                                                                 "page.md:2: `directorc` has no option --hard"});
}

TEST_CASE("a folder to which the page beside it does not link is found") {
  CHECK(folder_faults("runtime/page.md",
                      read_markdown("[a](core/tables.hpp) [b](./dds/) [c](hosted.md) [e](live/) [d](../hosted)\n")) ==
        std::vector<std::string>{"runtime/page.md: no link leads to hosted/"});
}
