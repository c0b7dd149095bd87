// SPDX-License-Identifier: MIT
// The whole pages of a small behaviour are goldens; properties of every page are checked besides.
#include "compiler/base/sha256.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/page/facts/facts.hpp"
#include "compiler/page/pages.hpp"
#include "tests/compiler/support/checked.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

namespace {

const char* const robot = R"(doc: A robot that walks & kicks, <softly>.
layers: [plan, skill]
states:
  Pose: {doc: How it stands., values: [moving, still], initial: still}
  Ball: {values: [lost, near], initial: lost, external: true, expires: {after: 1 s, to: lost}}
roots: {Kick: {priority: 20, doc: At times.}, Walk: {priority: 10}}
groups:
  Kick: {doc: One leg swings., layer: plan, when: [Pose == still, Ball == near], needs: [Legs]}
  Walk:
    layer: skill
    providers:
      - {name: walking, doc: Step by step., needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Legs: {layer: skill, stop: {sets: [Pose == still]}}
assertions:
  - never_together: [Kick, Walk]
)";

/// Both pages, with a picture that is no more than a name.
struct Pages {
  std::string html, markdown;
};

Pages pages_of(const std::string& behaviour, const std::string& link) {
  const CheckedText text = check_text(behaviour);
  INFO(text.findings());
  const compiler::Checked& checked = text.checked;
  const compiler::PictureFlaws none;
  compiler::Json data =
      compiler::graph_json({checked.model, checked.graph, text.sources, none, nullptr, &checked.findings});
  if (checked.lowerable) compiler::add_page_facts(data, checked.model, checked.graph, "robot.yaml");
  const std::string drawn =
      "<?xml?>\n<!-- title -->\n<svg role=\"x\" id=\"s\"><g id=\"graph0\" class=\"graph\"></g></svg>\n";
  return {compiler::html_page({data, {{"All groups", drawn}, {"By layer", drawn}}, link, "robot.yaml"}),
          compiler::markdown_page({data, {{"All groups", "flowchart TB\n"}}, link, "robot.yaml"})};
}

/// The text between the last of these before the end and that.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  REQUIRE(from != std::string::npos);
  const std::size_t to = text.find(end, from + begin.size());
  REQUIRE(to != std::string::npos);
  return text.substr(from + begin.size(), to - from - begin.size());
}

std::string in_hex(const std::string& base64) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string digits = "0123456789abcdef";
  std::string bits, out;
  for (const char letter : base64) {
    if (letter == '=') continue;
    for (int bit = 5; bit >= 0; --bit) bits += (letters.find(letter) >> bit & 1) != 0 ? '1' : '0';
  }
  for (std::size_t at = 0; at + 4 <= bits.size() && out.size() < 64; at += 4) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 2 + (bits[at + i] == '1' ? 1 : 0);
    out += digits[value];
  }
  return out;
}

} // namespace

TEST_CASE("a page as Markdown: texts, picture, groups, states, ranks, transitions, verdicts and findings", "[golden]") {
  check_golden("tests/compiler/page/golden/robot.md", pages_of(robot, "https://example.org/{file}#L{line}").markdown);
}

TEST_CASE("a page as HTML, without its script and style", "[golden]") {
  std::string html = pages_of(robot, {}).html;
  const auto leave_out = [&](std::string_view what, const std::string& with) {
    const std::size_t at = html.find(what);
    REQUIRE(at != std::string::npos);
    html.replace(at, what.size(), with);
  };
  leave_out(compiler::page::page_script(), "(script)");
  leave_out(compiler::page::page_style(), "(style)");
  leave_out(between(html, "<meta http-equiv=", ">"), "(policy)");
  check_golden("tests/compiler/page/golden/robot.html", html);
}

TEST_CASE("a text of several paragraphs has them on both pages") {
  const Pages pages =
      pages_of("roots: [Walk]\ngroups:\n  Walk:\n    doc: |\n      One\n      leg.\n\n      The other.\n", "");
  CHECK(pages.markdown.find("\n\nOne leg.\n\nThe other.\n\n") != std::string::npos);
  CHECK(pages.html.find("<p class=\"doc\">One\nleg.</p>\n<p class=\"doc\">The other.</p>\n") != std::string::npos);
}

TEST_CASE("a text keeps its lists on both pages, and no letter of it becomes a mark of Markdown or HTML") {
  const Pages pages =
      pages_of("roots: [Walk]\ngroups:\n  Walk:\n    doc: |\n      Legs:\n      - left\n        one\n      - right\n\n"
               "      1. first\n      2. second\n\n      - a\n\n      -> a \\* b ~~c~~ &lt; d & e\n\n          code\n\n"
               "      12) no list\n",
               "");
  CHECK(pages.markdown.find("\n\nLegs:\n\n- left one\n- right\n\n1. first\n2. second\n\n- a\n\n"
                            "\\-&gt; a \\\\\\* b \\~\\~c\\~\\~ &amp;lt; d & e\n\ncode\n\n12\\) no list\n\n") !=
        std::string::npos);
  CHECK(pages.html.find(
            "<p class=\"doc\">Legs:</p>\n<ul class=\"doc\">\n<li>left\none</li>\n<li>right</li>\n</ul>\n"
            "<ol class=\"doc\">\n<li>first</li>\n<li>second</li>\n</ol>\n<ul class=\"doc\">\n<li>a</li>\n</ul>\n"
            "<p class=\"doc\">-&gt; a \\* b ~~c~~ &amp;lt; d &amp; e</p>\n") != std::string::npos);
}

TEST_CASE("in Markdown, no text becomes a formula or an emoji") {
  const std::string markdown = pages_of("roots: [Walk]\ngroups:\n  Walk: {doc: \"From $a$ to $b$ :+1: a: b, "
                                        "c::d http://e:80/ 12:30:45\"}\n",
                                        "")
                                   .markdown;
  CHECK(markdown.find("\n\nFrom <span>&#36;</span>a<span>&#36;</span> to <span>&#36;</span>b<span>&#36;</span> "
                      "<span>:</span>+1: a: b, c::d http://e:80/ 12<span>:</span>30:45\n\n") != std::string::npos);
}

TEST_CASE("a condition of `stay` is none that anything waits for") {
  const Pages pages = pages_of("states: {Ball: {values: [far, near], initial: near, external: true}}\nroots: [Kick]\n"
                               "groups: {Kick: {when: [Ball == near], stay: [Ball == far]}}\n",
                               "");
  CHECK(pages.markdown.find(
            "- waited for by: [Kick](#kick) (Ball == near)\n- lets go on: [Kick](#kick) (Ball == far)\n") !=
        std::string::npos);
  CHECK(between(pages.html, "<dt>waited for by</dt><dd>", "</dd>") ==
        "<a href=\"#group-Kick\">Kick</a> (Ball == near)");
  CHECK(between(pages.html, "<dt>lets go on</dt><dd>", "</dd>") == "<a href=\"#group-Kick\">Kick</a> (Ball == far)");
}

TEST_CASE("where a group has several providers, it is said which of them may be pushed") {
  const Pages pages = pages_of(robot, "");
  CHECK(pages.markdown.find("- may be pushed by: [Kick](#kick) (Pose == still, to halting)\n") != std::string::npos);
  CHECK(between(pages.html, "<dt>may be pushed by</dt><dd>", "</dd>") ==
        "<a href=\"#group-Kick\">Kick</a> (Pose == still, to halting)");
}

TEST_CASE("a provider without a name is called `default` on both pages where `extend` adds others") {
  const Pages pages = pages_of("states:\n  Pose: {values: [moving, still], initial: still}\n"
                               "  Charge: {values: [low, high], initial: high, external: true}\n"
                               "roots: {Kick: {priority: 20}, Walk: {priority: 10}}\n"
                               "groups:\n  Kick: {when: [Pose == still], needs: [Legs], tasks: [Legs]}\n"
                               "  Walk: {needs: [Legs], causing: [Pose == still], sets: [Pose == moving], tasks: "
                               "[Legs]}\n  Legs: {}\n"
                               "extend:\n  Walk: {before: default, providers: [{name: slow, when: [Charge == low]}]}\n",
                               "");
  CHECK(pages.markdown.find("- **Walk.slow**\n    - runs when: `Charge == low`\n"
                            "- **Walk.default**\n    - needs: [Legs](#legs)\n") != std::string::npos);
  CHECK(pages.markdown.find("- may be pushed by: [Kick](#kick) (Pose == still, to default)\n") != std::string::npos);
  CHECK(pages.markdown.find("- needed by: [Kick](#kick); [Walk.default](#walk)\n") != std::string::npos);
  CHECK(pages.html.find("<h4>Walk.slow <") != std::string::npos);
  CHECK(pages.html.find("<h4>Walk.default <") != std::string::npos);
  CHECK(between(pages.html, "<dt>may be pushed by</dt><dd>", "</dd>") ==
        "<a href=\"#group-Kick\">Kick</a> (Pose == still, to default)");
}

TEST_CASE("both pages say of which level of a request something is true") {
  const Pages pages =
      pages_of("roots: [Head]\ngroups:\n  Head:\n    tasks:\n      Move: {levels: {firm: {priority: 50, "
               "optional: true}, spare: {priority: 60}, lone: {priority: 5, apart: true}}}\n"
               "      Look: {priority: 3, optional: true}\n  Move: {}\n  Look: {}\n",
               "");
  for (const std::string text : {"(priority firm 50 optional, spare 60, lone 5 apart)", "(priority 3, optional)"}) {
    CHECK(pages.markdown.find(text) != std::string::npos);
    CHECK(pages.html.find(text) != std::string::npos);
  }
}

TEST_CASE("both pages have what states and groups declare besides conditions and requests") {
  const Pages pages =
      pages_of("states: {Ball: {values: [lost, far, near], unordered: [lost], external: true}}\nroots: [Kick]\n"
               "groups:\n  Kick: {data: int, start: true, stop: true, tasks: [Leg], uses: [Leg]}\n  Leg: {}\n",
               "");
  CHECK(pages.markdown.find("lost, far, near; without an order to the others: lost; unset") != std::string::npos);
  CHECK(pages.html.find("lost, far, near; without an order to the others: lost; unset") != std::string::npos);
  CHECK(pages.markdown.find(", a start handler, a stop handler, data `int`\n") != std::string::npos);
  CHECK(pages.html.find(", a start handler, a stop handler, data <code>int</code></p>") != std::string::npos);
  CHECK(pages.markdown.find("- reads whether these run: [Leg](#leg)\n") != std::string::npos);
  CHECK(pages.html.find("<dt>reads whether these run</dt><dd><a href=\"#group-Leg\">Leg</a></dd>") !=
        std::string::npos);
}

TEST_CASE("a group that others must provide is in no module") {
  const Pages pages = pages_of("extern: [Legs]\ngroups: {Kick: {needs: [Legs]}}\n", "");
  const std::string words = "extern: whoever imports this file must provide it";
  CHECK(pages.markdown.find("`, " + words + "\n") != std::string::npos);
  CHECK(pages.html.find("<p class=\"about\">" + words + "</p>") != std::string::npos);
}

TEST_CASE("the `doc` of a root, a task and `extend` is on both pages") {
  const Pages pages = pages_of("roots: {A: {priority: 3, doc: At times.}}\n"
                               "groups: {A: {tasks: {B: {optional: true, doc: If <light>.}}}, B: {doc: It is.}}\n"
                               "extend: {B: {doc: And more., providers: [{name: more}]}}\n",
                               "");
  for (const std::string text : {"(priority 3: At times.)", "(priority 0, optional: If &lt;light&gt;.)"}) {
    CHECK(pages.markdown.find(text) != std::string::npos);
    CHECK(pages.html.find(text) != std::string::npos);
  }
  CHECK(pages.markdown.find("\n\nIt is.\n\nAnd more.\n\n") != std::string::npos);
  CHECK(pages.html.find("<p class=\"doc\">It is.</p>\n<p class=\"doc\">And more.</p>") != std::string::npos);
}

TEST_CASE("Markdown links to a group lead to it, also where an earlier heading of the page is equal") {
  const std::string markdown = pages_of("roots: [Master]\ngroups:\n"
                                        "  Master: {tasks: [Robot, Groups, WalkTo, Walkto, Findings]}\n"
                                        "  Robot: {}\n  Groups: {}\n  WalkTo: {}\n  Walkto: {}\n  Findings: {}\n",
                                        "")
                                   .markdown;
  for (const std::string name : {"Robot", "Groups", "Walkto"}) {
    CHECK(markdown.find("[" + name + "](#group-" + name + ")") != std::string::npos);
    CHECK(markdown.find("<a id=\"group-" + name + "\"></a>\n\n### " + name + "\n") != std::string::npos);
  }
  CHECK(markdown.find("[WalkTo](#walkto)") != std::string::npos);
  CHECK(markdown.find("[Findings](#findings)") != std::string::npos);
}

TEST_CASE("the policy of a page allows its own script and style by their check sums, and nothing else") {
  const std::string html = pages_of(robot, {}).html;
  const std::string policy = between(html, "content=\"default-src 'none'; ", "\">");
  CHECK(in_hex(between(policy, "script-src 'sha256-", "'")) == compiler::sha256(compiler::page::page_script()));
  CHECK(in_hex(between(policy, "style-src 'sha256-", "'")) == compiler::sha256(compiler::page::page_style()));
  CHECK(policy.substr(policy.find("base-uri")) == "base-uri 'none'; form-action 'none'");
  CHECK(html.find(" style=\"") == std::string::npos);
  CHECK(html.find("<link") == std::string::npos);
  CHECK(html.find(" src=") == std::string::npos);
}

TEST_CASE("a module that is no deployment has a page without what only a deployment has") {
  const std::string html = pages_of("groups: {Walk: {needs: [Legs]}, Legs: {}}\n", {}).html;
  CHECK(html.find("id=\"groups\"") != std::string::npos);
  CHECK(html.find("id=\"transitions\"") == std::string::npos);
  CHECK(html.find("id=\"takes\"") == std::string::npos);
}

} // namespace director::tests

TEST_CASE("groups to which no request of the program leads are named above all groups, also without a matrix") {
  const Pages pages = pages_of("roots: [Walk]\ngroups:\n  Walk: {}\n  Forgotten: {tasks: [Also]}\n  Also: {}\n", "");
  CHECK(between(pages.html, "<p class=\"unreached\">", "</p>") ==
        "No request of the program leads to these groups: <a href=\"#group-Forgotten\">Forgotten</a>, "
        "<a href=\"#group-Also\">Also</a>.");
  CHECK(pages.html.find("<dt>requested by</dt><dd>nobody</dd>") == pages.html.rfind("<dt>requested by</dt><dd>nobody"));
  CHECK(between(pages.html, "id=\"group-Forgotten\"", "</article>").find("<dd>nobody</dd>") != std::string::npos);
  CHECK(pages.markdown.find(
            "No request of the program leads to these groups: [Forgotten](#forgotten), [Also](#also).\n") !=
        std::string::npos);
  CHECK(pages.markdown.find("- requested by: nobody\n") != std::string::npos);
  CHECK(pages_of("groups:\n  Walk: {}\n", "").html.find("No request of the program") == std::string::npos);
  const Pages none = pages_of("roots: []\ngroups:\n  Walk: {tasks: [Legs]}\n  Legs: {}\n", "");
  CHECK(none.markdown.find("No request of the program leads to these groups: [Walk](#walk), [Legs](#legs).\n") !=
        std::string::npos);
  CHECK(none.markdown.find("- requested by: nobody\n") != std::string::npos);
}
