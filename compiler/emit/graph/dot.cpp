// Header: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
//
// A group is an HTML table: its rows are ports for the arrows of single providers. A layer is a band of as many ranks
// as it needs: an invisible node above it is above all of its first boxes and below all of the last ones of the layer
// before. The names of layers are a chain of their own down the left side, each in the rank of that node; `newrank`
// lets them share ranks with the rest. Graphviz uses the names of nodes as titles, so they are the names of the user's
// things.
#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/dot_box.hpp"
#include "compiler/emit/graph/dot_text.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/legend.hpp"
#include "compiler/emit/graph/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::compiler {

namespace {

using palette::in_quotes;

class Dot {
public:
  Dot(const Picture& picture, const PictureLinks& links, const std::set<std::size_t>& beside)
      : picture_(picture),
        links_(links),
        beside_(beside) {}

  std::string draw() {
    code_.open(fmt::format("digraph {} {{", in_quotes(picture_.title)));
    code_.line("graph [rankdir=TB, newrank=true, fontname=\"Helvetica\", fontsize=10, nodesep=0.3, ranksep=0.4, "
               "labelloc=b, labeljust=l]");
    code_.line("node [shape=plain, fontname=\"Helvetica\", fontsize=12]");
    // Every attribute that an arrow may have, in alphabetical order: Graphviz 2.42 confuses attributes of an arrow
    // between neighbours of one rank if they have another order.
    code_.line("edge [URL=\"\", arrowhead=vee, arrowsize=0.7, color=black, constraint=true, edgetooltip=\"\", "
               "fontcolor=black, fontname=\"Helvetica\", fontsize=10, headport=\"\", label=\"\", labeltooltip=\"\", "
               "penwidth=1, style=solid, tailport=\"\", tooltip=\"\", weight=1" +
               std::string(beside_.empty() ? "]" : ", xlabel=\"\"]"));
    code_.open("label=<");
    for (const std::string& line : legend_table(picture_)) code_.line(line);
    code_.close(">");
    draw_layers(); // first, so that the names of layers are on the left
    for (const PictureBox& box : picture_.boxes) draw_box(box, links_, code_);
    for (std::size_t i = 0; i < picture_.arrows.size(); ++i) draw_arrow(picture_.arrows[i], beside_.contains(i));
    code_.close("}");
    return code_.text();
  }

private:
  /// `"Walk":"halting"`
  std::string end(const PictureEnd& end) const {
    const std::string box = in_quotes(picture_.boxes[end.box].name), at = port(picture_, end);
    return at.empty() ? box : fmt::format("{}:{}", box, in_quotes(at));
  }

  /// What is queued has a bar before its head, since dashes alone would look like those of `apart`.
  static std::string head_of(const PictureArrow& arrow) {
    const bool waits = arrow.mark == Moment::Mark::queued && !arrow.missing;
    const std::string_view usual = arrow.kind == PictureArrow::Kind::need ? "dot"
                                   : arrow.optional && !arrow.missing     ? "onormal"
                                                                          : "";
    if (!waits && usual.empty()) return {};
    return fmt::format(", arrowhead={}{}", usual.empty() ? "vee" : usual, waits ? "nonetee" : "");
  }

  static std::string style_of(const PictureArrow& arrow) {
    using Kind = PictureArrow::Kind;
    std::string how = arrow.optional ? ", style=dotted" : arrow.apart ? ", style=dashed" : "";
    if (arrow.mark == Moment::Mark::queued) how = ", style=dashed";
    if (arrow.missing) how.clear();
    if (arrow.kind != Kind::need) how += head_of(arrow);
    if (arrow.mark == Moment::Mark::inactive && !arrow.missing) how += fmt::format(", fontcolor=\"{}\"", palette::grey);
    if (arrow.missing) how += fmt::format(", fontcolor=\"{}\"", palette::queued);
    if (arrow.missing || arrow.mark == Moment::Mark::running || arrow.mark == Moment::Mark::queued)
      how += arrow.kind == Kind::both ? ", penwidth=1.3" : ", penwidth=2"; // two lines side by side must not touch
    const auto colour = [&](std::string_view usual) {
      return arrow.missing ? palette::queued : arrow.mark ? colour_of(*arrow.mark, palette::faint) : usual;
    };
    switch (arrow.kind) {
    case Kind::task: return fmt::format("color=\"{}\"{}", colour(palette::task), how);
    case Kind::both: return fmt::format("color=\"{}:{}\"{}", colour(palette::task), colour(palette::need), how);
    case Kind::need: return fmt::format("color=\"{}\"{}, arrowsize=0.6{}", colour(palette::need), head_of(arrow), how);
    case Kind::push:
      return fmt::format("color=\"{0}\", fontcolor=\"{0}\", penwidth=3, arrowhead=normal", palette::push);
    case Kind::take: break;
    }
    return fmt::format("color=\"{0}\", fontcolor=\"{0}\", penwidth=2, arrowhead=normalnormal", palette::take);
  }

  /// `&gt;` is one.
  static std::size_t letters_of(std::string_view text) {
    std::size_t out = 0;
    for (std::size_t at = 0; at < text.size(); ++at, ++out) {
      if (text[at] == '&') at = std::min(text.find(';', at), text.size() - 1);
    }
    return out;
  }

  /// With its own background, so that no line crosses it; and wide enough for the letters of any font, since a viewer
  /// may have another one than Graphviz, whose letters would stick out of the paper, or below the next label.
  static std::string label_of(const std::string& text) {
    constexpr std::size_t letter_width = 6, padding = 4;
    constexpr std::string_view next = "<BR/>";
    std::string lines;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines += std::string(lines.empty() ? "" : next) + palette::wrapped(text.substr(begin, end - begin), 0, next);
      begin = end + 1;
    }
    std::size_t longest = 0;
    for (std::size_t begin = 0; begin <= lines.size();) {
      const std::size_t end = std::min(lines.find(next, begin), lines.size());
      longest = std::max(longest, letters_of(std::string_view(lines).substr(begin, end - begin)));
      begin = end + next.size();
    }
    return fmt::format(
        "<TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"1\" BGCOLOR=\"{}\"><TR><TD "
        "ALIGN=\"LEFT\" WIDTH=\"{}\">{}</TD></TR></TABLE>",
        palette::paper, letter_width * longest + padding, lines);
  }

  void draw_arrow(const PictureArrow& arrow, bool beside) {
    std::string text = arrow.hidden ? "style=invis" : style_of(arrow);
    if (const std::string label = label_text(arrow); !label.empty())
      text += fmt::format(", {}=<{}>", beside ? "xlabel" : "label", label_of(label));
    if (!arrow.ranks) text += ", constraint=false";
    const std::string words = quoted_tooltip(arrow.about);
    text += fmt::format(", tooltip={0}, edgetooltip={0}, labeltooltip={0}", words);
    if (const std::string url = links_.to(arrow.about); !url.empty()) text += ", URL=" + in_quotes(url);
    code_.line(fmt::format("{} -> {} [{}]", end(arrow.from), end(arrow.to), text));
  }

  /// Places the boxes one below the other, regardless of arrows.
  void draw_order(const PictureLayer& layer) {
    if (!layer.in_order) return;
    for (std::size_t i = 1; i < layer.boxes.size(); ++i)
      code_.line(fmt::format("{} -> {} [style=invis, weight=10]", in_quotes(picture_.boxes[layer.boxes[i - 1]].name),
                             in_quotes(picture_.boxes[layer.boxes[i]].name)));
  }

  /// Groups in no layer have a band of their own too: in that of another they would seem to belong to it.
  void draw_layers() {
    const std::vector<PictureLayer>& layers = picture_.layers;
    for (const PictureLayer& layer : layers) draw_order(layer);
    if (std::all_of(layers.begin(), layers.end(), [](const PictureLayer& layer) { return layer.name.empty(); })) return;
    const auto name = [&](std::size_t i) { return in_quotes(layers[i].title()); };
    const auto top = [&](std::size_t i) { return in_quotes("top of " + layers[i].title()); };
    for (std::size_t i = 0; i < layers.size(); ++i) {
      code_.line(fmt::format("{} [shape=plaintext, fontsize=11, height=0.2, fontcolor=\"{}\", label={}, tooltip={}]",
                             name(i), palette::grey, in_quotes(layers[i].label()), name(i)));
      code_.line(fmt::format("{} [shape=point, style=invis, width=0.01]", top(i)));
      code_.line(fmt::format("{{rank=same; {}; {};}}", name(i), top(i)));
      if (i > 0) code_.line(fmt::format("{} -> {} [style=invis, weight=100]", name(i - 1), name(i)));
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
      for (const std::size_t box : layers[i].first)
        code_.line(fmt::format("{} -> {} [style=invis, weight=0{}]", top(i), in_quotes(picture_.boxes[box].name),
                               i == 0 ? ", minlen=0" : "")); // the first name is beside its boxes
      if (i + 1 == layers.size()) break;
      for (const std::size_t box : layers[i].last)
        code_.line(fmt::format("{} -> {} [style=invis, weight=0]", in_quotes(picture_.boxes[box].name), top(i + 1)));
    }
  }

  const Picture& picture_;
  const PictureLinks& links_;
  const std::set<std::size_t>& beside_;
  Code code_;
};

} // namespace

std::string dot(const Picture& picture, const PictureLinks& links, const std::set<std::size_t>& beside) {
  return Dot(picture, links, beside).draw();
}

} // namespace director::compiler
