// Header: compiler/page/html/parts.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"
#include "compiler/page/html/parts.hpp"

#include <fmt/format.h>

#include <map>

namespace director::compiler::page {

namespace {

std::string anchor_of(const Json& row, const Json* column) {
  const std::string from = "from-" + html(row["group"].as_text());
  return column == nullptr ? from : from + "-to-" + html((*column)["group"].as_text());
}

std::string legend_html(const Json& rows) {
  std::string out = "<dl class=\"legend\">\n";
  for (const CellKind& kind : cell_kinds_in(rows))
    out += fmt::format("<div><dt><b class=\"sign\" data-kind=\"{3}\">{1}</b> {0}</dt><dd>{2}</dd></div>\n", kind.kind,
                       kind.sign, kind.meaning, kind.style);
  if (has_refuted(rows))
    out += fmt::format("<div><dt><b class=\"sign\">\u2716</b> refuted</dt><dd>{}</dd></div>\n", refuted_meaning);
  return out + "</dl>\n";
}

/// Columns that fit on A4 beside the names of the rows.
constexpr std::size_t most_on_paper = 40;

/// For print, which cannot be scrolled: the matrix once more, some columns at a time, each with all rows. Empty if it
/// fits as a whole.
std::string bands_html(const Json& rows) {
  const std::vector<Json>& all = rows.items();
  if (all.size() <= most_on_paper) return {};
  const std::size_t count = (all.size() + most_on_paper - 1) / most_on_paper;
  std::string out = "<div class=\"bands\">\n";
  for (std::size_t band = 0; band < count; ++band) { // of equal width
    const std::size_t begin = all.size() * band / count, end = all.size() * (band + 1) / count;
    out += fmt::format("<table>\n<caption>From the group of the row to that of the column; columns {} to {} of "
                       "{}</caption>\n<thead><tr><td></td>",
                       begin + 1, end, all.size());
    for (std::size_t i = begin; i < end; ++i)
      out += fmt::format("<th scope=\"col\"><span>{}</span>", html(all[i]["group"].as_text()));
    out += "</thead>\n<tbody>\n";
    for (const Json& row : all) {
      out += fmt::format("<tr><th scope=\"row\">{}", html(row["group"].as_text()));
      for (std::size_t i = begin; i < end; ++i) {
        const CellKind& kind = cell_kind(row["cells"].items()[i]);
        out += fmt::format("<td data-kind=\"{}\">{}", kind.style, cell_sign(row["cells"].items()[i]));
      }
      out += '\n';
    }
    out += "</tbody>\n</table>\n";
  }
  return out + "</div>\n";
}

std::string matrix_html(const Json& rows) {
  std::string out = "<div class=\"matrix\" tabindex=\"0\" role=\"region\" aria-label=\"Transition matrix\">\n<table>\n"
                    "<caption>From the group of the row to that of the column</caption>\n<thead><tr><td></td>";
  for (const Json& row : rows.items())
    out += fmt::format("<th scope=\"col\"><span>{}</span></th>", html(row["group"].as_text()));
  out += "</tr></thead>\n<tbody>\n";
  for (const Json& row : rows.items()) {
    out += fmt::format("<tr><th scope=\"row\"><span>{}</span></th>", html(row["group"].as_text()));
    const std::vector<Json>& cells = row["cells"].items();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const CellKind& kind = cell_kind(cells[i]);
      const Json* column = needs_explanation(cells[i]) ? &rows.items()[i] : nullptr;
      out +=
          fmt::format("<td data-kind=\"{}\"><a href=\"#{}\" title=\"{}\">{}</a>", kind.style, // </td> may be left out
                      anchor_of(row, column), kind.kind, cell_sign(cells[i]));
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n</div>\n" + bands_html(rows) + "<div id=\"cell\" hidden></div>\n";
}

/// Folded.
std::string scenario_html(const std::string& scenario) {
  return fmt::format("<details><summary>Scenario</summary><pre tabindex=\"0\">{}</pre></details>", html(scenario));
}

/// Empty where nothing was played.
std::string scenario_html(const Json& cell, const Json& pieces) {
  if (cell["scenario"].is_null()) return {};
  std::string out;
  for (const Json& piece : cell["scenario"].items())
    out += pieces.items()[static_cast<std::size_t>(piece.as_number())].as_text();
  return scenario_html(out);
}

/// Cells with an explanation of their own, with their scenarios, then the others by kind.
std::string row_html(const Json& transitions, const Json& row) {
  const Json& rows = transitions["rows"];
  std::string out = fmt::format("<article class=\"row\" id=\"{}\" tabindex=\"-1\">\n<h3>From {}</h3>\n<p>{}</p>\n",
                                anchor_of(row, nullptr), html(row["group"].as_text()), html(row["words"].as_text()));
  std::string explanations;
  std::map<std::string_view, std::vector<std::string>> others;
  const std::vector<Json>& cells = row["cells"].items();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Json& column = rows.items()[i];
    const CellKind& kind = cell_kind(cells[i]);
    if (!needs_explanation(cells[i])) {
      others[kind.kind].push_back(column["group"].as_text());
      continue;
    }
    explanations +=
        fmt::format("<div id=\"{}\" tabindex=\"-1\"><dt>to {}: <b class=\"sign\" data-kind=\"{}\">{}</b> "
                    "{}<dd>{}{}</div>\n", // </dt> and </dd> may be left out
                    anchor_of(row, &column), html(column["group"].as_text()), kind.style, cell_sign(cells[i]),
                    kind.kind, html(cells[i]["words"].as_text()), scenario_html(cells[i], transitions["pieces"]));
  }
  if (!explanations.empty()) out += fmt::format("<dl>\n{}</dl>\n", explanations);
  for (const auto& [kind, names] : others) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + html(name);
    out += fmt::format("<p>To {}: {}.</p>\n", list, kind);
  }
  return out + "</article>\n";
}

std::string take_table_html(const Json& takes) {
  std::string out = "<div class=\"wide\" tabindex=\"0\" role=\"region\" "
                    "aria-label=\"Table of who goes first\"><table>\n<thead><tr><th scope=\"col\">goes first</th><th "
                    "scope=\"col\">before</th>"
                    "<th scope=\"col\">decided by</th><th scope=\"col\">over</th></tr></thead>\n<tbody>\n";
  for (const Json& take : takes.items()) {
    std::string over;
    for (const std::string& name : take["over"].as_texts()) over += (over.empty() ? "" : ", ") + group_link(name);
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", group_link(take["winner"].as_text()),
                       group_link(take["loser"].as_text()), html(take_words(take)), over);
  }
  return out + "</tbody>\n</table></div>\n";
}

/// Folded: it is long.
std::string rivals_html(const std::vector<Rivals>& all) {
  std::string out =
      fmt::format("<details class=\"rivals\"><summary>Groups with several requesters</summary>\n<p>{}</p>\n"
                  "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Table of those that request "
                  "the same\"><table>\n<thead><tr><th scope=\"col\">group</th><th scope=\"col\">requesters"
                  "</th><th scope=\"col\">decided by</th></tr></thead>\n<tbody>\n",
                  rivals_intro);
  for (const Rivals& each : all) {
    std::string decisions;
    for (const std::string& decision : each.decisions) decisions += (decisions.empty() ? "" : "<br>") + html(decision);
    out += fmt::format("<tr><td>{}</td><td>{} and {}</td><td>{}</td></tr>\n", html(each.group), html(each.first),
                       html(each.second), decisions);
  }
  return out + "</tbody>\n</table></div>\n</details>\n";
}

} // namespace

std::string pictures_html(const HtmlInput& input) {
  std::string out;
  for (const PagePicture& picture : input.page.pictures) {
    const bool first = &picture == &input.page.pictures.front();
    const std::string figure = fmt::format("<div class=\"picture\" data-picture=\"{0}\" tabindex=\"0\" role=\"region\" "
                                           "aria-label=\"Picture, {0}\">\n{1}\n</div>\n",
                                           html(picture.name), svg_part(picture.text));
    out += first ? figure
                 : fmt::format("<details class=\"more\"><summary>{}</summary>\n{}</details>\n", html(picture.name),
                               figure);
  }
  return out;
}

std::string takes_html(const HtmlInput& input) {
  const Json &takes = input.page.data["takes"], &ranks = input.page.data["ranks"];
  const Json& takes_left_out = input.page.data["takes_left_out"];
  if (ranks["decisions"].items().empty() && ranks["left_out"].is_null() && takes_left_out.is_null()) return {};
  std::string out = fmt::format("<p>{}</p>\n<div id=\"pair\" hidden></div>\n", takes_intro);
  if (!ranks["left_out"].is_null()) out += fmt::format("<p>{}</p>\n", html(ranks["left_out"].as_text()));
  if (!takes_left_out.is_null()) out += fmt::format("<p>{}</p>\n", message_html(takes_left_out.as_text()));
  if (!takes.items().empty()) out += take_table_html(takes);
  const std::vector<Rivals> rivals = rivals_in(ranks);
  return rivals.empty() ? out : out + rivals_html(rivals);
}

std::string transitions_html(const HtmlInput& input) {
  const Json& transitions = input.page.data["transitions"];
  const Json& rows = transitions["rows"];
  if (!transitions["left_out"].is_null())
    return fmt::format("<p>{}</p>\n", message_html(transitions["left_out"].as_text()));
  if (rows.items().empty()) return {};
  std::string out = fmt::format(
      "<p>The first group runs, then the second one is requested. What the engine does then was played. {}</p>\n",
      one_course);
  if (transitions["limited"].as_boolean()) out += fmt::format("<p>{}</p>\n", limited_intro);
  out += legend_html(rows) + matrix_html(rows);
  if (std::string names; !transitions["not_requested"].items().empty()) {
    for (const std::string& name : transitions["not_requested"].as_texts())
      names += (names.empty() ? "" : ", ") + group_link(name);
    out += fmt::format("<p>Not requested: {}.</p>\n", names);
  }
  out += "<div class=\"rows\">\n";
  for (const Json& row : rows.items()) out += row_html(transitions, row);
  return out + "</div>\n";
}

std::string assertions_html(const HtmlInput& input) {
  const Json& verdicts = input.page.data["verdicts"];
  if (verdicts.items().empty()) return {};
  const std::vector<Json>& assertions = input.page.data["assertions"].items();
  std::string out = "<ul class=\"verdicts\">\n";
  for (std::size_t i = 0; i < verdicts.items().size(); ++i) {
    const Json& verdict = verdicts.items()[i];
    out +=
        fmt::format("<li><b data-verdict=\"{0}\">{0}</b>: <code>{1}</code> {2}<br>{3}", verdict["verdict"].as_text(),
                    html(verdict["assertion"].as_text()), i < assertions.size() ? place_html(assertions[i], input) : "",
                    message_html(verdict["why"].as_text()));
    if (!verdict["scenario"].is_null()) out += scenario_html(verdict["scenario"].as_text());
    out += "</li>\n";
  }
  return out + "</ul>\n";
}

std::string findings_html(const HtmlInput& input) {
  const Json& findings = input.page.data["findings"];
  if (findings.items().empty()) return "<p>None.</p>\n";
  std::string out = "<ul class=\"findings\">\n";
  for (const Json& finding : findings.items()) {
    out += fmt::format("<li><b data-level=\"{0}\">{0}</b>: {1} <code>{2}</code> {3}", finding["level"].as_text(),
                       message_html(finding["message"].as_text()), html(finding["id"].as_text()),
                       place_html(Json::object({{"place", finding}}), input));
    if (!finding["help"].is_null()) out += fmt::format("<br>{}", message_html(finding["help"].as_text()));
    out += "</li>\n";
  }
  return out + "</ul>\n";
}

} // namespace director::compiler::page
