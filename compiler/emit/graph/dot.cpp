// Header: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
//
// A group is an HTML table: its rows are ports for the arrows of single providers. A layer is a band of as many ranks
// as it needs: an invisible node above it is above all of its first boxes and below all of the last ones of the layer
// before. The names of layers are a chain of their own down the left side, each in the rank of that node; `newrank`
// lets them share ranks with the rest. Graphviz uses the names of nodes as titles, so they are the names of the user's
// things.
#include "compiler/base/html.hpp"
#include "compiler/base/percent.hpp"
#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/legend.hpp"
#include "compiler/emit/graph/palette.hpp"
#include "dsl/shortened.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

std::string PictureLinks::to(const PictureText& text) const {
  if (pattern.empty() || text.file.empty()) return {};
  std::string out = pattern;
  const auto put = [&](std::string_view name, const std::string& value) {
    for (std::size_t at = out.find(name); at != std::string::npos; at = out.find(name, at + value.size()))
      out.replace(at, name.size(), value);
  };
  put("{line}", std::to_string(text.line));
  put("{file}", percent_encoded(text.file, "-._~/")); // in Markdown too nothing of it has a meaning
  return out;
}

namespace {

using palette::in_quotes;

class Dot {
public:
  Dot(const Picture& picture, const PictureLinks& links) : picture_(picture), links_(links) {}

  std::string draw() {
    code_.open(fmt::format("digraph {} {{", in_quotes(picture_.title)));
    code_.line("graph [rankdir=TB, newrank=true, fontname=\"Helvetica\", fontsize=10, nodesep=0.3, ranksep=0.4, "
               "labelloc=b, labeljust=l]");
    code_.line("node [shape=plain, fontname=\"Helvetica\", fontsize=12]");
    // Every attribute that an arrow may have, in alphabetical order: Graphviz 2.42 confuses attributes of an arrow
    // between neighbours of one rank if they have another order.
    code_.line("edge [URL=\"\", arrowhead=vee, arrowsize=0.7, color=black, constraint=true, edgetooltip=\"\", "
               "fontcolor=black, fontname=\"Helvetica\", fontsize=10, headport=\"\", label=\"\", labeltooltip=\"\", "
               "penwidth=1, style=solid, tailport=\"\", tooltip=\"\", weight=1]");
    code_.open("label=<");
    for (const std::string& line : legend_table(picture_)) code_.line(line);
    code_.close(">");
    draw_layers(); // first, so that the names of layers are on the left
    for (const PictureBox& box : picture_.boxes) draw_box(box);
    for (const PictureArrow& arrow : picture_.arrows) draw_arrow(arrow);
    code_.close("}");
    return code_.text();
  }

private:
  /// `halting`, `ready.go`, `kick`: the name in the title.
  static std::string port(const PictureRow& row) { return row.name; }
  static std::string port(const PictureRow& row, const PicturePack& pack) {
    return row.name.empty() ? pack.name : row.name + "." + pack.name;
  }

  /// `"Walk":"halting"`
  std::string end(const PictureEnd& end) const {
    const PictureBox& box = picture_.boxes[end.box];
    if (!end.row && !end.pack) return in_quotes(box.name);
    const PictureRow& row = box.rows[end.row.value_or(0)];
    return fmt::format("{}:{}", in_quotes(box.name), in_quotes(end.pack ? port(row, row.packs[*end.pack]) : port(row)));
  }

  /// Graphviz reads strings of up to 16 KiB, and more than a page is not read in a tooltip. It also replaces `\N` and
  /// the like by names.
  static std::string tooltip(const PictureText& text) {
    const std::string words = dsl::shortened(text.words);
    std::string out;
    for (const char letter : text.file.empty() ? words : fmt::format("{}\n{}:{}", words, text.file, text.line))
      out += letter == '\\' ? "\\\\" : std::string(1, letter);
    return out;
  }

  /// Not of a cell: Graphviz replaces `&amp;` there.
  static std::string quoted_tooltip(const PictureText& text) {
    std::string out;
    for (const char letter : tooltip(text)) out += letter == '&' ? "&amp;" : std::string(1, letter);
    return in_quotes(out);
  }

  /// The tooltip of a cell or a table.
  std::string cell_words(const PictureText& text) const {
    std::string out = fmt::format(" TOOLTIP=\"{}\"", html_attribute(tooltip(text)));
    if (const std::string url = links_.to(text); !url.empty()) out += fmt::format(" HREF=\"{}\"", html_attribute(url));
    return out;
  }

  static std::string_view colour_of(PictureLine::Kind kind) {
    switch (kind) {
    case PictureLine::Kind::when:
    case PictureLine::Kind::stay: return palette::when;
    case PictureLine::Kind::causing: return palette::push;
    case PictureLine::Kind::wrong: return palette::queued;
    case PictureLine::Kind::doubtful: return palette::when;
    case PictureLine::Kind::sets:
    case PictureLine::Kind::runs:
    case PictureLine::Kind::outer: break;
    }
    return palette::grey;
  }

  /// Whether all of a box is grey, as it does not run at the moment.
  static bool is_grey(const PictureBox& box) { return box.mark == Moment::Mark::inactive; }

  static bool is_grey(const PictureBox& box, const PictureRow& row) {
    return is_grey(box) || (box.mark && !box.is_direct() && !row.is_active);
  }

  static std::string name_of(bool grey, const std::string& name) {
    return grey ? fmt::format("<FONT COLOR=\"{}\">{}</FONT>", palette::grey, html_attribute(name))
                : html_attribute(name);
  }

  static std::string lines(bool grey, const std::vector<PictureLine>& all) {
    std::string out;
    for (const PictureLine& line : all) {
      const bool is_flaw = line.kind == PictureLine::Kind::wrong || line.kind == PictureLine::Kind::doubtful;
      const std::string_view colour = grey && !is_flaw ? palette::grey : colour_of(line.kind);
      out += fmt::format("<BR ALIGN=\"LEFT\"/><FONT POINT-SIZE=\"9\" COLOR=\"{}\"><B>{}&#160;</B>{}</FONT>", colour,
                         html_attribute(line.key),
                         is_flaw ? palette::wrapped(line.text, line.key.size()) : html_attribute(line.text));
    }
    return out;
  }

  static std::string small(std::string_view colour, const std::string& text) {
    return fmt::format("<FONT POINT-SIZE=\"9\" COLOR=\"{}\">{}</FONT>", colour, html_attribute(text));
  }

  static std::string row_name(const PictureBox& box, const PictureRow& row) {
    if (!row.is_active) return name_of(is_grey(box, row), row.name);
    return fmt::format("<FONT COLOR=\"{}\"><B>\u25B6 {}</B></FONT>", frame_of(box).colour, html_attribute(row.name));
  }

  /// The note about the moment as text.
  static std::string note_text(Moment::Mark mark, const std::string& note) {
    switch (mark) {
    case Moment::Mark::inactive: return {};
    case Moment::Mark::running: return "\u25B6 running";
    case Moment::Mark::queued: return "queued: " + note;
    case Moment::Mark::held: return "held for what needs it";
    case Moment::Mark::pushed: break;
    }
    return note;
  }

  static std::string note_of(const PictureBox& box) {
    const std::string text = box.mark ? palette::wrapped(note_text(*box.mark, box.note)) : "";
    if (text.empty()) return {};
    return fmt::format("<FONT POINT-SIZE=\"9\" COLOR=\"{}\"><B>{}</B></FONT>", frame_of(box).colour, text);
  }

  // Frames have each box at one place, so everything that differs between them gets the space of the largest. Only
  // Graphviz knows the size of letters: these are more than any font of this size needs.
  static constexpr std::size_t letter_width = 9, small_letter_width = 7, line_height = 20, small_line_height = 13,
                               padding = 10;

  /// Minimum width and height.
  static std::string room(std::size_t width, std::size_t height) {
    std::string out;
    if (width != 0) out += fmt::format(" WIDTH=\"{}\"", width);
    if (height != 0) out += fmt::format(" HEIGHT=\"{}\"", height);
    return out;
  }

  static std::string note_room(const PictureBox& box) {
    std::size_t width = 0, lines = 0;
    for (const Moment::Standing& frame : box.frames) {
      const std::string text = palette::wrapped(note_text(frame.mark, frame.note));
      constexpr std::string_view end = "<BR ALIGN=\"LEFT\"/>";
      std::size_t count = 0;
      for (std::size_t at = 0; at < text.size(); ++count) {
        const std::size_t next = std::min(text.find(end, at), text.size());
        width = std::max(width, next - at);
        at = next == text.size() ? next : next + end.size();
      }
      lines = std::max(lines, count);
    }
    return room(width * small_letter_width + padding, lines * small_line_height + padding);
  }

  /// Of the cell of a provider, which is marked while it is active.
  static std::string row_room(const PictureBox& box, const PictureRow& row) {
    if (box.frames.empty()) return {};
    return room((row.name.size() + 2) * letter_width + padding,
                line_height + row.lines.size() * small_line_height + padding);
  }

  static bool runs(const PictureBox& box) {
    return box.mark == Moment::Mark::running || box.mark == Moment::Mark::pushed;
  }

  struct Frame {
    std::string_view colour, style;
    int width = 1;
  };
  static Frame frame_of(const PictureBox& box) {
    Frame out = mark_frame(box, "ROUNDED");
    if (!box.frames.empty()) out.width = box.in_focus ? 4 : 2;
    return out;
  }

  /// The frame around groups that are requested alike, each of which has a frame of its own for its status.
  static Frame frame_around(const PictureBox& box) {
    const std::string_view colour = box.in_focus ? palette::ink : is_grey(box) ? palette::faint : palette::frame;
    return {colour, "DASHED", box.in_focus ? 4 : 1};
  }

  static Frame mark_frame(const PictureBox& box, std::string_view solid) {
    const auto at_least = [&](int width) { return box.in_focus ? 4 : width; };
    const int width = at_least(box.requested ? 2 : 1);
    if (box.kind == PictureBox::Kind::missing) return {palette::queued, "ROUNDED,DASHED", 2};
    if (!box.mark) return {box.in_focus || box.requested ? palette::ink : palette::frame, solid, width};
    switch (*box.mark) {
    case Moment::Mark::running: return {palette::need, solid, at_least(3)};
    case Moment::Mark::pushed: return {palette::push, solid, at_least(3)};
    case Moment::Mark::queued: return {palette::queued, "ROUNDED,DASHED", at_least(2)};
    case Moment::Mark::held: return {palette::need, "ROUNDED,DOTTED", at_least(2)};
    case Moment::Mark::inactive: break;
    }
    return {palette::faint, solid, width};
  }

  /// Graphviz sets a line as high as its largest letter, and so close that a name would touch the smaller line above
  /// it.
  static constexpr std::string_view below_smaller = "<FONT POINT-SIZE=\"15\">&#160;</FONT>";

  void draw_head(const PictureBox& box) {
    std::string text;
    if (box.requested)
      text += small(is_grey(box) ? palette::grey : palette::ink,
                    "\u25BC program" + (box.requested->empty() ? "" : ": " + *box.requested)) +
              "<BR ALIGN=\"LEFT\"/>";
    if (box.kind == PictureBox::Kind::missing)
      text += small(palette::queued, "\u2716 no such group") + "<BR ALIGN=\"LEFT\"/>";
    text += fmt::format("<B>{}</B>", name_of(is_grey(box), box.name));
    if (box.requested) text += below_smaller;
    if (!box.data.empty()) text += "<BR ALIGN=\"LEFT\"/>" + small(palette::grey, box.data);
    text += lines(is_grey(box), box.lines);
    if (box.is_direct()) text += lines(is_grey(box), box.rows.front().lines);
    const std::string note = note_of(box);
    if (box.frames.empty() && !note.empty()) text += "<BR ALIGN=\"LEFT\"/>" + note;
    code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\"{}>{}<BR ALIGN=\"LEFT\"/></TD></TR>", cell_words(box.about), text));
    if (!box.frames.empty())
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" VALIGN=\"TOP\"{}{}>{}</TD></TR>", note_room(box),
                             cell_words(box.about), note.empty() ? "" : note + "<BR ALIGN=\"LEFT\"/>"));
  }

  void draw_row(const PictureBox& box, const PictureRow& row) {
    if (!row.name.empty()) {
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" BORDER=\"1\" SIDES=\"T\" PORT=\"{}\"{}{}>{}{}<BR "
                             "ALIGN=\"LEFT\"/></TD></TR>",
                             html_attribute(port(row)), row_room(box, row), cell_words(row.about), row_name(box, row),
                             lines(is_grey(box, row), row.lines)));
    }
    for (const PicturePack& pack : row.packs) {
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" PORT=\"{}\"{}>{}<BR ALIGN=\"LEFT\"/></TD></TR>",
                             html_attribute(port(row, pack)), cell_words(pack.about),
                             small(is_grey(box, row) ? palette::grey : palette::ink, "\u25C7 " + pack.name)));
    }
  }

  void draw_members(const PictureBox& box) {
    constexpr std::size_t most = 12;
    const bool few = box.members.size() <= most || box.kind == PictureBox::Kind::alike;
    for (std::size_t i = 0; i < (few ? box.members.size() : most - 1); ++i) {
      const PictureMember& member = box.members[i];
      if (box.kind == PictureBox::Kind::alike) {
        const Frame frame = frame_of(box);
        code_.line(fmt::format(
            "<TR><TD BORDER=\"{}\" STYLE=\"{}\" COLOR=\"{}\" BGCOLOR=\"{}\"{}{}><B>{}</B>{}</TD></TR>",
            box.mark ? frame.width : 1, frame.style, frame.colour, palette::paper,
            box.frames.empty() ? "" : room((member.name.size() + 2) * letter_width + padding, line_height + padding),
            cell_words(member.about), name_of(is_grey(box), (runs(box) ? "\u25B6 " : "") + member.name),
            box.data.empty() ? "" : "<BR/>" + small(palette::grey, box.data)));
      } else {
        code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\"{}>{}</TD></TR>", cell_words(member.about),
                               small(palette::ink, member.name)));
      }
    }
    if (!few)
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\">{}</TD></TR>",
                             small(palette::grey, fmt::format("and {} more", box.members.size() - most + 1))));
  }

  void draw_box(const PictureBox& box) {
    const bool alike = box.kind == PictureBox::Kind::alike;
    const Frame frame = alike ? frame_around(box) : frame_of(box);
    const std::string url = links_.to(box.about);
    code_.open(fmt::format("{} [tooltip={}{}, label=<", in_quotes(box.name), quoted_tooltip(box.about),
                           url.empty() ? "" : ", URL=" + in_quotes(url)));
    code_.line(fmt::format("<TABLE BORDER=\"{}\" CELLBORDER=\"0\" CELLSPACING=\"{}\" CELLPADDING=\"4\" COLOR=\"{}\" "
                           "BGCOLOR=\"{}\" STYLE=\"{}\">",
                           frame.width, alike ? 3 : 0, frame.colour, palette::paper, frame.style));
    if (!alike) draw_head(box);
    for (const PictureRow& row : box.rows) draw_row(box, row);
    draw_members(box);
    code_.line("</TABLE>");
    code_.close(">]");
  }

  static std::string_view mark_colour(Moment::Mark mark) {
    switch (mark) {
    case Moment::Mark::running:
    case Moment::Mark::held: return palette::need;
    case Moment::Mark::queued: return palette::queued;
    case Moment::Mark::pushed: return palette::push;
    case Moment::Mark::inactive: break;
    }
    return palette::faint;
  }

  static std::string style_of(const PictureArrow& arrow) {
    using Kind = PictureArrow::Kind;
    std::string how = arrow.optional ? ", style=dotted, arrowhead=onormal" : arrow.apart ? ", style=dashed" : "";
    if (arrow.mark == Moment::Mark::queued) how = ", style=dashed";
    if (arrow.mark == Moment::Mark::running) how += ", penwidth=2";
    if (arrow.mark == Moment::Mark::inactive) how += fmt::format(", fontcolor=\"{}\"", palette::grey);
    if (arrow.missing) how = fmt::format(", fontcolor=\"{}\", penwidth=2", palette::queued);
    const auto colour = [&](std::string_view usual) {
      return arrow.missing ? palette::queued : arrow.mark ? mark_colour(*arrow.mark) : usual;
    };
    switch (arrow.kind) {
    case Kind::task: return fmt::format("color=\"{}\"{}", colour(palette::task), how);
    case Kind::both: return fmt::format("color=\"{}:{}\"{}", colour(palette::task), colour(palette::need), how);
    case Kind::need: return fmt::format("color=\"{}\", arrowhead=dot, arrowsize=0.6{}", colour(palette::need), how);
    case Kind::push:
      return fmt::format("color=\"{0}\", fontcolor=\"{0}\", penwidth=3, arrowhead=normal", palette::push);
    case Kind::take: break;
    }
    return fmt::format("color=\"{0}\", fontcolor=\"{0}\", penwidth=2, arrowhead=normalnormal", palette::take);
  }

  /// With its own background, so that no line crosses it.
  static std::string label_of(const std::string& text) {
    std::string lines;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines += (lines.empty() ? "" : "<BR/>") + html_attribute(text.substr(begin, end - begin));
      begin = end + 1;
    }
    return fmt::format(
        "<TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"1\" BGCOLOR=\"{}\"><TR><TD>{}"
        "</TD></TR></TABLE>",
        palette::paper, lines);
  }

  void draw_arrow(const PictureArrow& arrow) {
    std::string text = arrow.hidden ? "style=invis" : style_of(arrow);
    const std::string apart = arrow.apart && !arrow.optional ? (arrow.label.empty() ? "apart" : ", apart") : "";
    if (const std::string label = arrow.label + apart; !label.empty()) text += ", label=<" + label_of(label) + ">";
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
  Code code_;
};

} // namespace

std::string dot(const Picture& picture, const PictureLinks& links) { return Dot(picture, links).draw(); }

} // namespace director::compiler
