// Header: compiler/emit/graph/dot_box.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/dot_box.hpp"

#include "compiler/base/html.hpp"
#include "compiler/emit/graph/dot_text.hpp"
#include "compiler/emit/graph/palette.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

using palette::in_quotes;

std::string_view colour_of(PictureLine::Kind kind) {
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
bool is_grey(const PictureBox& box) { return box.mark == Moment::Mark::inactive; }

bool is_grey(const PictureBox& box, const PictureRow& row) {
  return is_grey(box) || (box.mark && !box.is_direct() && !row.is_active);
}

struct Frame {
  std::string_view colour, style;
  int width = 1;
};

Frame mark_frame(const PictureBox& box, std::string_view solid) {
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

Frame frame_of(const PictureBox& box) {
  Frame out = mark_frame(box, "ROUNDED");
  if (!box.frames.empty()) out.width = box.in_focus ? 4 : 2;
  return out;
}

/// The frame around groups that are requested alike, each of which has a frame of its own for its status.
Frame frame_around(const PictureBox& box) {
  const std::string_view colour = box.in_focus ? palette::ink : is_grey(box) ? palette::faint : palette::frame;
  return {colour, "DASHED", box.in_focus ? 4 : 1};
}

std::string name_of(bool grey, const std::string& name) {
  return grey ? fmt::format("<FONT COLOR=\"{}\">{}</FONT>", palette::grey, html_attribute(name)) : html_attribute(name);
}

std::string lines(bool grey, const std::vector<PictureLine>& all) {
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

/// `text`: as HTML.
std::string small_html(std::string_view colour, const std::string& text) {
  return fmt::format("<FONT POINT-SIZE=\"9\" COLOR=\"{}\">{}</FONT>", colour, text);
}

std::string small(std::string_view colour, const std::string& text) { return small_html(colour, html_attribute(text)); }

std::string row_name(const PictureBox& box, const PictureRow& row) {
  if (!row.is_active) return name_of(is_grey(box, row), row.name);
  return fmt::format("<FONT COLOR=\"{}\"><B>\u25B6 {}</B></FONT>", frame_of(box).colour, html_attribute(row.name));
}

/// The note about the moment as text.
std::string note_text(Moment::Mark mark, const std::string& note) {
  switch (mark) {
  case Moment::Mark::inactive: return {};
  case Moment::Mark::running: return "\u25B6 running";
  case Moment::Mark::queued: return "queued: " + note;
  case Moment::Mark::held: return "held for what needs it";
  case Moment::Mark::pushed: break;
  }
  return note;
}

/// `▶ Kick`, `Walk queued: Legs is held by Kick`.
std::string member_text(const std::string& name, const Moment::Standing& now) {
  if (now.mark == Moment::Mark::running) return "\u25B6 " + name;
  const std::string note = note_text(now.mark, now.note);
  return note.empty() ? name : fmt::format("{}{} {}", now.mark == Moment::Mark::pushed ? "\u25B6 " : "", name, note);
}

std::string note_of(const PictureBox& box) {
  const std::string text =
      box.mark && box.kind != PictureBox::Kind::folded ? palette::wrapped(note_text(*box.mark, box.note)) : "";
  if (text.empty()) return {};
  return fmt::format("<FONT POINT-SIZE=\"9\" COLOR=\"{}\"><B>{}</B></FONT>", frame_of(box).colour, text);
}

// Frames have each box at one place, so everything that differs between them gets the space of the largest. Only
// Graphviz knows the size of letters: these are more than any font of this size needs.
constexpr std::size_t letter_width = 9, small_letter_width = 7, line_height = 20, small_line_height = 13, padding = 10;

/// Minimum width and height.
std::string room(std::size_t width, std::size_t height) {
  std::string out;
  if (width != 0) out += fmt::format(" WIDTH=\"{}\"", width);
  if (height != 0) out += fmt::format(" HEIGHT=\"{}\"", height);
  return out;
}

/// `before`: at the beginning of each.
std::string note_room(const std::vector<Moment::Standing>& frames, const std::string& before = {}) {
  std::size_t width = 0, lines = 0;
  for (const Moment::Standing& frame : frames) {
    const std::string text =
        palette::wrapped(before.empty() ? note_text(frame.mark, frame.note) : member_text(before, frame));
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
std::string row_room(const PictureBox& box, const PictureRow& row) {
  if (box.frames.empty()) return {};
  return room((row.name.size() + 2) * letter_width + padding,
              line_height + row.lines.size() * small_line_height + padding);
}

bool runs(const PictureBox& box) { return box.mark == Moment::Mark::running || box.mark == Moment::Mark::pushed; }

class Box {
public:
  Box(const PictureBox& box, const PictureLinks& links, Code& code) : box_(box), links_(links), code_(code) {}

  void draw() {
    const bool alike = box_.kind == PictureBox::Kind::alike;
    const Frame frame = alike ? frame_around(box_) : frame_of(box_);
    const std::string url = links_.to(box_.about);
    code_.open(fmt::format("{} [tooltip={}{}, label=<", in_quotes(box_.name), quoted_tooltip(box_.about),
                           url.empty() ? "" : ", URL=" + in_quotes(url)));
    code_.line(fmt::format("<TABLE BORDER=\"{}\" CELLBORDER=\"0\" CELLSPACING=\"{}\" CELLPADDING=\"4\" COLOR=\"{}\" "
                           "BGCOLOR=\"{}\" STYLE=\"{}\">",
                           frame.width, alike ? 3 : 0, frame.colour, palette::paper, frame.style));
    if (!alike) draw_head();
    for (const PictureRow& row : box_.rows) draw_row(row);
    draw_members();
    code_.line("</TABLE>");
    code_.close(">]");
  }

private:
  /// Graphviz sets a line as high as its largest letter, and so close that a name would touch the smaller line above
  /// it.
  static constexpr std::string_view below_smaller = "<FONT POINT-SIZE=\"15\">&#160;</FONT>";

  void draw_head() {
    std::string text;
    if (box_.requested)
      text += small_html(is_grey(box_) ? palette::grey : palette::ink,
                         palette::wrapped("\u25BC program" + (box_.requested->empty() ? "" : ": " + *box_.requested))) +
              "<BR ALIGN=\"LEFT\"/>";
    if (box_.kind == PictureBox::Kind::missing)
      text += small(palette::queued, "\u2716 no such group") + "<BR ALIGN=\"LEFT\"/>";
    text += fmt::format("<B>{}</B>", name_of(is_grey(box_), box_.name));
    if (box_.requested) text += below_smaller;
    if (!box_.data.empty()) text += "<BR ALIGN=\"LEFT\"/>" + small(palette::grey, box_.data);
    text += lines(is_grey(box_), box_.lines);
    if (box_.is_direct()) text += lines(is_grey(box_), box_.rows.front().lines);
    const std::string note = note_of(box_);
    if (box_.frames.empty() && !note.empty()) text += "<BR ALIGN=\"LEFT\"/>" + note;
    code_.line(
        fmt::format("<TR><TD ALIGN=\"LEFT\"{}>{}<BR ALIGN=\"LEFT\"/></TD></TR>", cell_words(box_.about, links_), text));
    if (!box_.frames.empty() && box_.kind != PictureBox::Kind::folded)
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" VALIGN=\"TOP\"{}{}>{}</TD></TR>", note_room(box_.frames),
                             cell_words(box_.about, links_), note.empty() ? "" : note + "<BR ALIGN=\"LEFT\"/>"));
  }

  void draw_row(const PictureRow& row) {
    if (!row.name.empty()) {
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" BORDER=\"1\" SIDES=\"T\" PORT=\"{}\"{}{}>{}{}<BR "
                             "ALIGN=\"LEFT\"/></TD></TR>",
                             html_attribute(port(row)), row_room(box_, row), cell_words(row.about, links_),
                             row_name(box_, row), lines(is_grey(box_, row), row.lines)));
    }
    for (const PicturePack& pack : row.packs) {
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\" PORT=\"{}\"{}>{}<BR ALIGN=\"LEFT\"/></TD></TR>",
                             html_attribute(port(row, pack)), cell_words(pack.about, links_),
                             small(is_grey(box_, row) ? palette::grey : palette::ink, "\u25C7 " + pack.name)));
    }
  }

  /// Whether it is requested or held at some moment that is shown.
  static bool is_active(const PictureMember& member) {
    const auto acts = [](const Moment::Standing& each) { return each.mark != Moment::Mark::inactive; };
    return (member.now && acts(*member.now)) || std::any_of(member.frames.begin(), member.frames.end(), acts);
  }

  void draw_member(const PictureMember& member) {
    const std::string room = member.frames.empty() ? "" : note_room(member.frames, member.name);
    const std::string text = !member.now ? small(palette::ink, member.name)
                                         : fmt::format("<FONT POINT-SIZE=\"9\" COLOR=\"{}\">{}</FONT>",
                                                       colour_of(member.now->mark, palette::grey),
                                                       palette::wrapped(member_text(member.name, *member.now)));
    code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\"{}{}>{}{}</TD></TR>", room, cell_words(member.about, links_), text,
                           member.now ? "<BR ALIGN=\"LEFT\"/>" : ""));
  }

  /// The first of many; at a moment those that are active.
  void draw_members() {
    constexpr std::size_t most = 12;
    const bool few = box_.members.size() <= most || box_.kind == PictureBox::Kind::alike;
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < box_.members.size(); ++i) {
      const PictureMember& member = box_.members[i];
      if (!few && (member.now ? !is_active(member) : i >= most - 1)) {
        ++left_out;
        continue;
      }
      if (box_.kind == PictureBox::Kind::alike) {
        const Frame frame = frame_of(box_);
        code_.line(fmt::format(
            "<TR><TD BORDER=\"{}\" STYLE=\"{}\" COLOR=\"{}\" BGCOLOR=\"{}\"{}{}><B>{}</B>{}</TD></TR>",
            box_.mark ? frame.width : 1, frame.style, frame.colour, palette::paper,
            box_.frames.empty() ? "" : room((member.name.size() + 2) * letter_width + padding, line_height + padding),
            cell_words(member.about, links_), name_of(is_grey(box_), (runs(box_) ? "\u25B6 " : "") + member.name),
            box_.data.empty() ? "" : "<BR/>" + small(palette::grey, box_.data)));
      } else {
        draw_member(member);
      }
    }
    if (left_out != 0)
      code_.line(fmt::format("<TR><TD ALIGN=\"LEFT\">{}</TD></TR>",
                             small(palette::grey, fmt::format("and {} more", left_out))));
  }

  const PictureBox& box_;
  const PictureLinks& links_;
  Code& code_;
};

} // namespace

std::string_view colour_of(Moment::Mark mark, std::string_view inactive) {
  switch (mark) {
  case Moment::Mark::running:
  case Moment::Mark::held: return palette::need;
  case Moment::Mark::pushed: return palette::push;
  case Moment::Mark::queued: return palette::queued;
  case Moment::Mark::inactive: break;
  }
  return inactive;
}

void draw_box(const PictureBox& box, const PictureLinks& links, Code& code) { Box(box, links, code).draw(); }

} // namespace director::compiler
