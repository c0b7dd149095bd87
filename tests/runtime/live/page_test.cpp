// SPDX-License-Identifier: MIT
// Tests runtime/live/page.hpp.
#include "runtime/live/page.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

using namespace director::live;
using namespace director::tests;

TEST_CASE("a page of directorc docs is sent with its policy as a header, which allows requests to its own server") {
  const TemporaryFolder folder;
  REQUIRE(run_command("directorc docs tests/docs/rover/rover.yaml -o " + folder.path().string(), source_dir()).status ==
          0);
  const std::string html = read_file((folder.path() / "rover.html").string());
  const std::optional<Page> page = to_send(html);
  REQUIRE(page);
  CHECK(page->policy.starts_with("default-src 'none'; script-src 'sha256-"));
  CHECK(page->policy.ends_with("; base-uri 'none'; form-action 'none'; connect-src 'self'; frame-ancestors 'none'"));
  CHECK(page->html.find("Content-Security-Policy") == std::string::npos);
  const std::string tag = "<meta name=\"director-live\" content=\"events\">\n<meta name=\"viewport\"";
  CHECK(page->html.find(tag) != std::string::npos);
  CHECK(html.find("director-live\"") == html.find("director-live\"]")); // in the file only the script has it
  CHECK(page->html.substr(page->html.find("<meta name=\"viewport\"")) ==
        html.substr(html.find("<meta name=\"viewport\"")));
}

TEST_CASE("a page that is not from directorc docs is not sent") {
  for (const char* html :
       {"", "text", "<html></html>", "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'",
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src\n'none'\">"})
    CHECK_FALSE(to_send(html));
}
