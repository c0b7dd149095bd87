// Header: compiler/page/pages.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
//
// The page has all its content as text; the script only moves, hides and marks. Nothing is loaded: the policy allows
// only the script and the style whose hashes it has.
#include "compiler/base/html.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/base/packed.hpp"
#include "compiler/base/sha256.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/page/html/parts.hpp"
#include "compiler/page/html/script_data.hpp"
#include "compiler/page/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace director::compiler {

namespace page {

namespace {

int digit(char letter) { return letter <= '9' ? letter - '0' : letter - 'a' + 10; }

/// As a policy names it.
std::string check_sum(std::string_view bytes) {
  const std::string hex = sha256(bytes);
  std::string sum;
  for (std::size_t at = 0; at < hex.size(); at += 2) sum += static_cast<char>(digit(hex[at]) * 16 + digit(hex[at + 1]));
  return "sha256-" + base64(sum);
}

/// JSON that may stand in a script's tag.
std::string in_script(const Json& data) {
  std::string out;
  for (const char letter : to_line(data)) {
    if (letter == '<') out += "\\u003c";
    if (letter != '<') out += letter;
  }
  return out;
}

struct Section {
  std::string_view id, title;
  std::string (*html)(const HtmlInput& input);
};
constexpr std::array<Section, 8> sections{{{"picture", "Picture", pictures_html},
                                           {"timeline", "Timeline", timeline_html},
                                           {"groups", "Groups", groups_html},
                                           {"states", "States", states_html},
                                           {"takes", "Who goes first", takes_html},
                                           {"transitions", "Transitions", transitions_html},
                                           {"assertions", "Assertions", assertions_html},
                                           {"findings", "Findings", findings_html}}};

std::uint64_t count_where(const Json& all, std::string_view key, std::string_view value) {
  return static_cast<std::uint64_t>(std::count_if(all.items().begin(), all.items().end(),
                                                  [&](const Json& each) { return each[key].as_text() == value; }));
}

/// The title in the list of sections, with the counts that say how far the page can be trusted.
std::string counted_title(const Section& section, const Json& data) {
  std::string out{section.title};
  const auto add = [&](std::uint64_t count, std::string_view sign, const std::string& words) {
    if (count != 0) out += fmt::format("{} {} {}", out.find(':') == std::string::npos ? ":" : ",", sign, words);
  };
  if (section.id == "assertions") {
    const std::uint64_t refuted = count_where(data["verdicts"], "verdict", "refuted");
    add(refuted, "\u2716", fmt::format("{} refuted", refuted));
  }
  if (section.id == "findings") {
    const std::uint64_t errors = count_where(data["findings"], "level", "error");
    const std::uint64_t warnings = count_where(data["findings"], "level", "warning");
    add(errors, "\u2716", counted(errors, "error"));
    add(warnings, "\u26a0", counted(warnings, "warning"));
  }
  return out;
}

} // namespace

std::string message_html(std::string_view message) {
  return in_pieces(
      message, [](std::string_view piece) { return html(piece); },
      [](std::string_view piece) { return fmt::format("<code>{}</code>", html(piece)); });
}

std::string place_html(const Json& thing, const HtmlInput& input) {
  const std::string link = place_link(thing["place"], input.page.link);
  const std::string words = html(place_text(thing["place"]));
  return link.empty() ? fmt::format("<span class=\"place\">{}</span>", words)
                      : fmt::format("<a class=\"place\" href=\"{}\">{}</a>", html(link), words);
}

std::string doc_html(const Json& thing) {
  std::string out;
  for (const DocBlock& block : doc_blocks(thing)) {
    if (block.kind == DocBlock::Kind::paragraph) {
      out += fmt::format("<p class=\"doc\">{}</p>\n", html(block.items.front()));
      continue;
    }
    const std::string_view tag = block.kind == DocBlock::Kind::bullets ? "ul" : "ol";
    out += fmt::format("<{} class=\"doc\">\n", tag);
    for (const std::string& item : block.items) out += fmt::format("<li>{}</li>\n", html(item));
    out += fmt::format("</{}>\n", tag);
  }
  return out;
}

std::string group_link(const std::string& name) { return fmt::format("<a href=\"#group-{0}\">{0}</a>", html(name)); }

} // namespace page

std::string html_page(const PageInput& input) {
  using namespace page;
  const Relations relations = find_relations(input.data);
  const HtmlInput parts{input, relations};
  const std::string name = html(input.data["behaviour"].as_text());
  std::string body, nav;
  for (const Section& section : sections) {
    const std::string html = section.html(parts);
    if (html.empty()) continue;
    nav += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, counted_title(section, input.data));
    body += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
        section.id, section.title, html);
  }
  // The script makes links of the places in answers to `why`.
  std::string about = input.link.empty() ? "" : fmt::format(" data-link=\"{}\"", html(input.link));
  // The script compares it with that of the running program.
  if (!input.fingerprint.empty()) about += fmt::format(" data-fingerprint=\"{}\"", html(input.fingerprint));
  return fmt::format(
      "<!DOCTYPE html>\n{}\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; style-src '{}'; "
      "base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body{}>\n"
      "<a class=\"skip\" href=\"#main\">To the text</a>\n<header>\n<h1>{}</h1>\n{}"
      "<div id=\"finder\" hidden></div>\n</header>\n<nav aria-label=\"On this page\">\n<ul>\n{}</ul>\n</nav>\n"
      "<main id=\"main\">\n{}</main>\n<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n"
      "</body>\n</html>\n",
      html_notice(input.file), check_sum(page_script()), check_sum(page_style()), name, page_style(), about, name,
      doc_html(input.data), nav, body, in_script(script_data(input.data)), page_script());
}

} // namespace director::compiler
