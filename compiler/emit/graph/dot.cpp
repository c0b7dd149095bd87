// Door: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
//
// A group is an HTML table: its rows are ports from which a provider's own arrows leave. Layers are ranks of their own,
// held in order by a chain of names down the left side. `newrank` lets the legend, a cluster, take part in that order.
#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/formats.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

// Colours that stay apart for people who see no red or green, and on paper. Source: Okabe and Ito, "Color Universal
// Design".
constexpr std::string_view task_colour = "#404040", need_colour = "#0072B2", when_colour = "#9A5B00",
                           causing_colour = "#00805A", frame_colour = "#8A8F98";

std::string html(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += letter;
    }
  }
  return out;
}

std::string dot_string(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += letter;
  }
  return out + "\"";
}

std::string node(GroupId group) { return fmt::format("g{}", group.value); }

/// Where an arrow leaves or arrives: the provider's row, or the group's head.
std::string port(const Picture& picture, GroupId group, const std::optional<ProviderId>& provider) {
  const PictureBox& box = picture.boxes[group.value];
  const bool rows = box.rows.size() > 1 || !box.rows.front().name.empty();
  return provider && rows ? fmt::format("{}:p{}", node(group), provider->value) : node(group);
}

std::string small(std::string_view colour, std::string_view word, const std::string& text) {
  if (text.empty()) return {};
  return fmt::format("<BR ALIGN=\"LEFT\"/><FONT POINT-SIZE=\"9\" COLOR=\"{}\">{} {}</FONT>", colour, word, html(text));
}

std::string conditions_of(const PictureRow& row) {
  return small(when_colour, "when", row.when) + small(when_colour, "stay", row.stay) +
         small(causing_colour, "causing", row.causing);
}

void draw_box(Code& code, const PictureBox& box) {
  code.open(fmt::format("{} [label=<", node(box.group)));
  code.line(fmt::format("<TABLE BORDER=\"{}\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"5\" COLOR=\"{}\" "
                        "BGCOLOR=\"white\" STYLE=\"ROUNDED\">",
                        box.root ? 2 : 1, box.root ? task_colour : frame_colour));
  const bool direct = box.rows.size() == 1 && box.rows.front().name.empty();
  const std::string data = box.data.empty()
                               ? std::string{}
                               : fmt::format("<BR ALIGN=\"LEFT\"/><FONT POINT-SIZE=\"8\" COLOR=\"{}\">{}</FONT>",
                                             frame_colour, html(box.data));
  code.line(fmt::format("<TR><TD ALIGN=\"LEFT\"><B>{}</B>{}{}<BR ALIGN=\"LEFT\"/></TD></TR>", html(box.name), data,
                        direct ? conditions_of(box.rows.front()) : std::string{}));
  if (!direct) {
    for (const PictureRow& row : box.rows) {
      code.line(
          fmt::format("<TR><TD ALIGN=\"LEFT\" BORDER=\"1\" SIDES=\"T\" PORT=\"p{}\">{}{}<BR ALIGN=\"LEFT\"/></TD></TR>",
                      row.provider.value, html(row.name.empty() ? "default" : row.name), conditions_of(row)));
    }
  }
  code.line("</TABLE>");
  code.close(">]");
}

std::string style_of(const PictureArrow& arrow) {
  if (arrow.task && arrow.need) return fmt::format("color=\"{}:{}\", arrowhead=vee", task_colour, need_colour);
  if (arrow.need) return fmt::format("color=\"{}\", arrowhead=dot, arrowsize=0.6", need_colour);
  if (arrow.optional) return fmt::format("color=\"{}\", style=dotted, arrowhead=vee", task_colour);
  return fmt::format("color=\"{}\", arrowhead=vee", task_colour);
}

/// Without a label, since the condition stands in both rows.
void draw_cause(Code& code, const Picture& picture, const PictureCause& cause) {
  const std::string from = port(picture, cause.causer_group, cause.causer);
  const std::string to = port(picture, cause.waiter_group, cause.waiter);
  code.line(fmt::format("{} -> {} [color=\"{}\", style=dashed, arrowhead=empty, constraint=false, tooltip={}]", from,
                        to, causing_colour, dot_string(cause.condition)));
}

void draw_layers(Code& code, const Picture& picture) {
  std::string chain;
  for (std::size_t i = 0; i < picture.layers.size(); ++i) {
    const PictureLayer& layer = picture.layers[i];
    code.line(fmt::format("layer{} [shape=plaintext, fontsize=11, fontcolor=\"{}\", label={}]", i, frame_colour,
                          dot_string(layer.name.empty() ? "" : layer.name)));
    std::string groups;
    for (const GroupId group : layer.groups) groups += fmt::format(" {};", node(group));
    // What is in no layer finds its place by its arrows alone.
    if (!layer.name.empty()) code.line(fmt::format("{{rank=same; layer{};{}}}", i, groups));
    if (!layer.name.empty()) chain += fmt::format("{}layer{}", chain.empty() ? "" : " -> ", i);
  }
  if (chain.find("->") != std::string::npos) code.line(chain + " [style=invis, weight=100]");
}

/// The legend is the label of the whole graph: a table that takes no part in the layout. A line is the border of a
/// cell.
std::string legend_row(std::string_view colour, std::string_view style, std::string_view head, std::string_view text) {
  return fmt::format("<TR><TD FIXEDSIZE=\"TRUE\" WIDTH=\"34\" HEIGHT=\"8\" BORDER=\"1\" SIDES=\"B\" COLOR=\"{}\" "
                     "STYLE=\"{}\"></TD><TD ALIGN=\"LEFT\"><FONT COLOR=\"{}\">{}</FONT></TD><TD ALIGN=\"LEFT\">{}"
                     "</TD></TR>",
                     colour, style, colour, head, text);
}

void draw_legend(Code& code, const Picture& picture) {
  code.open("label=<");
  code.line("<TABLE BORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">");
  code.line(fmt::format("<TR><TD COLSPAN=\"3\" ALIGN=\"LEFT\"><B>{}</B></TD></TR>", html(picture.title)));
  code.line(legend_row(task_colour, "SOLID", "&#9654;", "may request (task)"));
  code.line(legend_row(task_colour, "DOTTED", "&#9654;", "may request, optional"));
  code.line(legend_row(need_colour, "SOLID", "&#9679;", "needs (drawn beside the task where it is also requested)"));
  code.line(
      legend_row(causing_colour, "DASHED", "&#9655;", "causing: may be pushed to make true what the other waits for"));
  code.line(fmt::format("<TR><TD COLSPAN=\"3\" ALIGN=\"LEFT\"><FONT COLOR=\"{}\">when, stay</FONT>: conditions; thick "
                        "frame: a root task; arrows from a name: all its providers</TD></TR>",
                        when_colour));
  code.line("</TABLE>");
  code.close(">");
}

} // namespace

std::string dot(const Picture& picture) {
  Code code;
  code.open(fmt::format("digraph {} {{", dot_string(picture.title)));
  code.line("graph [rankdir=TB, newrank=true, fontname=\"Helvetica\", fontsize=10, nodesep=0.3, ranksep=0.7, "
            "labelloc=b, labeljust=l]");
  code.line("node [shape=plain, fontname=\"Helvetica\", fontsize=12]");
  // Every attribute that an arrow may have, by the alphabet: Graphviz 2.42 takes one for the other in an arrow between
  // neighbours of one rank, where they were not told in this order.
  code.line("edge [arrowhead=vee, arrowsize=0.7, color=black, constraint=true, fontname=\"Helvetica\", fontsize=9, "
            "headport=\"\", style=solid, tailport=\"\", tooltip=\"\", weight=1]");
  draw_legend(code, picture);
  draw_layers(code, picture); // first, so that the names of layers stand on the left
  for (const PictureBox& box : picture.boxes) draw_box(code, box);
  for (const PictureArrow& arrow : picture.arrows)
    code.line(fmt::format("{} -> {} [{}]", port(picture, arrow.from, arrow.provider), node(arrow.to), style_of(arrow)));
  for (const PictureCause& cause : picture.causes) draw_cause(code, picture, cause);
  code.close("}");
  return code.text();
}

} // namespace director::compiler
