// Header: compiler/emit/graph/legend.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/legend.hpp"

#include "compiler/base/html.hpp"
#include "compiler/emit/graph/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace director::compiler {

namespace {

using Sample = LegendEntry::Sample;

template <class Things, class Predicate>
bool any(const Things& things, Predicate predicate) {
  return std::any_of(things.begin(), things.end(), predicate);
}

template <class Predicate>
bool has_line(const Picture& picture, Predicate is_one) {
  return any(picture.boxes, [&](const PictureBox& box) {
    return any(box.lines, is_one) || any(box.rows, [&](const PictureRow& row) { return any(row.lines, is_one); });
  });
}

bool has_line(const Picture& picture, PictureLine::Kind kind) {
  return has_line(picture, [&](const PictureLine& line) { return line.kind == kind; });
}

constexpr std::string_view warning = "\u26A0";

/// Whether a finding below the picture is no error.
bool is_warning(const std::string& text) { return text.starts_with(warning); }

struct Line {
  std::string_view colour, style, head;
  int width = 1;
};

Line line_of(Sample sample) {
  switch (sample) {
  case Sample::both:
  case Sample::task: return {palette::task, "SOLID", "&#9654;"};
  case Sample::optional: return {palette::task, "DOTTED", "&#9655;"};
  case Sample::apart: return {palette::task, "DASHED", "&#9654;"};
  case Sample::need: return {palette::need, "SOLID", "&#9679;"};
  case Sample::push: return {palette::push, "SOLID", "&#9654;", 3};
  case Sample::take: return {palette::take, "SOLID", "&#9654;&#9654;", 2};
  case Sample::text: break;
  }
  return {};
}

/// The lower border of a cell of that height: it is at half the height of the text beside it.
std::string stroke(std::string_view colour, std::string_view style, int width) {
  return fmt::format("<TD FIXEDSIZE=\"TRUE\" WIDTH=\"30\" HEIGHT=\"{}\" CELLPADDING=\"0\" BORDER=\"{}\" SIDES=\"B\" "
                     "COLOR=\"{}\" STYLE=\"{}\"></TD>",
                     2 * width, width, colour, style);
}

/// A request and a need side by side, as in the arrow.
std::string two_strokes(bool is_grey) {
  return fmt::format("<TD ALIGN=\"RIGHT\"><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"1\" CELLPADDING=\"0\">"
                     "<TR>{}</TR><TR>{}</TR></TABLE></TD>",
                     stroke(is_grey ? palette::grey : palette::task, "SOLID", 1),
                     stroke(is_grey ? palette::grey : palette::need, "SOLID", 1));
}

std::string table_row(const LegendEntry& entry) {
  const std::string words = fmt::format("<TD ALIGN=\"LEFT\">{}</TD>", html_attribute(entry.words));
  if (entry.sample == Sample::text)
    return fmt::format("<TR><TD COLSPAN=\"2\" ALIGN=\"LEFT\">{}&#160;&#160;</TD>{}</TR>", html_attribute(entry.sign),
                       words);
  Line line = line_of(entry.sample);
  if (entry.is_grey) line.colour = palette::grey;
  const std::string drawn =
      entry.sample == Sample::both ? two_strokes(entry.is_grey) : stroke(line.colour, line.style, line.width);
  return fmt::format("<TR>{}<TD ALIGN=\"LEFT\"><FONT COLOR=\"{}\">{}</FONT></TD>{}</TR>", drawn, line.colour, line.head,
                     words);
}

class Legend {
public:
  explicit Legend(const Picture& picture)
      : picture_(picture),
        marked_(any(picture.boxes, [](const PictureBox& box) { return box.mark.has_value(); })) {}

  std::vector<LegendEntry> entries() {
    add_sign(!picture_.nothing.empty(), "nothing drawn", picture_.nothing);
    add_marks();
    add_arrows();
    add_boxes();
    add_lines();
    return std::move(out_);
  }

private:
  using Kind = PictureArrow::Kind;

  void add(bool is_drawn, Sample sample, std::string words) {
    if (is_drawn)
      out_.push_back({sample, {}, std::move(words), marked_ && sample != Sample::push && sample != Sample::take});
  }
  void add_sign(bool is_drawn, std::string sign, std::string words) {
    if (is_drawn) out_.push_back({Sample::text, std::move(sign), std::move(words), false});
  }

  template <class Predicate>
  bool draws_box(Predicate is_one) const {
    return any(picture_.boxes, is_one);
  }
  template <class Predicate>
  bool draws(Predicate is_one) const {
    return any(picture_.arrows, is_one);
  }
  static bool is_request(const PictureArrow& arrow) { return arrow.kind == Kind::task || arrow.kind == Kind::both; }
  static bool has_number(const std::string& text) {
    return any(text, [](unsigned char letter) { return std::isdigit(letter) != 0; });
  }

  /// `row`: the sign where only rows of folded boxes have that mark.
  void add_mark(Moment::Mark mark, std::string sign, std::string row, std::string words) {
    const auto is_one = [&](const Moment::Standing& frame) { return frame.mark == mark; };
    const bool framed = draws_box([&](const PictureBox& box) { return box.mark == mark || any(box.frames, is_one); });
    const bool in_rows = draws_box([&](const PictureBox& box) {
      return any(box.members, [&](const PictureMember& each) {
        return (each.now && is_one(*each.now)) || any(each.frames, is_one);
      });
    });
    add_sign(framed || in_rows, framed ? std::move(sign) : std::move(row), std::move(words));
  }
  void add_marked_line(Moment::Mark mark, std::string sign, std::string words) {
    const bool has_frames = draws_box([](const PictureBox& box) { return !box.frames.empty(); });
    const auto is_one = [&](const PictureArrow& arrow) {
      const bool is_so = arrow.mark == mark || (mark == Moment::Mark::running && arrow.mark == Moment::Mark::held);
      return arrow.kind != Kind::push && arrow.kind != Kind::take && (has_frames || is_so);
    };
    add_sign(draws(is_one), std::move(sign), std::move(words));
  }
  /// What happens at the moment that is shown.
  void add_marks() {
    add_mark(Moment::Mark::running, "blue frame, \u25B6", "blue, \u25B6", "runs, in that provider");
    add_mark(Moment::Mark::queued, "dashed red frame", "red", "queued: it is requested, and waits");
    add_mark(Moment::Mark::pushed, "green frame", "green, \u25B6", "runs, and is pushed by what waits");
    add_mark(Moment::Mark::held, "dotted blue frame", "blue", "held, and not requested yet");
    add_mark(Moment::Mark::inactive, "grey", "grey", "nothing requests it");
    if (!marked_) return;
    add_marked_line(Moment::Mark::running, std::string(blue_line), "is requested or needed, and has it");
    add_marked_line(Moment::Mark::queued, std::string(red_line), "is requested, and waits");
    add_marked_line(Moment::Mark::inactive, std::string(grey_line), "is not requested now");
  }

  void add_arrows() {
    const auto plain = [](const PictureArrow& arrow) {
      return arrow.kind == Kind::task && !arrow.optional && !arrow.apart && !arrow.missing;
    };
    const auto is = [&](Kind kind) { return draws([=](const PictureArrow& arrow) { return arrow.kind == kind; }); };
    add(draws(plain), Sample::task, "requests");
    add(draws([](const PictureArrow& arrow) { return is_request(arrow) && arrow.optional; }), Sample::optional,
        "requests, optional: weaker than all that is not");
    add(draws([](const PictureArrow& arrow) { return is_request(arrow) && arrow.apart && !arrow.optional; }),
        Sample::apart, "requests, apart: granted by itself");
    add(is(Kind::need), Sample::need, "needs: holds it while it runs");
    add(is(Kind::both), Sample::both, "needs and requests");
    add(is(Kind::push), Sample::push, "waits until that is true, and may push the other to make it true");
    add(is(Kind::take), Sample::take, "may take from the other what it holds, by these ranks");
    const auto is_loop = [&](Kind kind) {
      return draws([=](const PictureArrow& arrow) { return arrow.kind == kind && arrow.from.box == arrow.to.box; });
    };
    add_sign(is_loop(Kind::take), "back to its box", "one of its groups may take from another one of it");
    add_sign(is_loop(Kind::push), "back to its box", "one of its groups may push another one of it");
    add_sign(draws([](const PictureArrow& arrow) { return is_request(arrow) && has_number(arrow.label); }), "20",
             "priority among the tasks of the same requester: the higher one goes first");
  }

  void add_boxes() {
    const bool ranked = draws_box([](const PictureBox& box) { return box.requested && has_number(*box.requested); });
    add_sign(draws_box([](const PictureBox& box) { return box.requested.has_value(); }),
             marked_ ? "\u25BC program" : "thick frame",
             fmt::format("the program itself requests it{}", ranked ? ", with that priority" : ""));
    add_sign(draws_box([](const PictureBox& box) { return box.in_focus; }), "thickest", "the groups in focus");
    const bool from_rows = draws([](const PictureArrow& arrow) { return arrow.from.row.has_value(); });
    add_sign(draws_box([](const PictureBox& box) { return box.rows.size() > 1; }), "rows",
             fmt::format("providers, the preferred one first{}",
                         picture_.packs_left_out ? "; an arrow stands for all that request"
                         : from_rows             ? "; an arrow from one row is of that provider alone"
                                                 : ""));
    add_sign(draws_box([](const PictureBox& box) {
               return any(box.rows, [](const PictureRow& row) { return !row.packs.empty(); });
             }),
             "\u25C7", "packs: it requests one of them at a time");
    const auto is = [&](PictureBox::Kind kind) {
      return draws_box([=](const PictureBox& box) { return box.kind == kind; });
    };
    add_sign(is(PictureBox::Kind::alike), "dashed box", "groups that the same ones request in the same way");
    add_sign(is(PictureBox::Kind::missing) || has_line(picture_, PictureLine::Kind::wrong) ||
                 any(picture_.wrong, [](const std::string& text) { return !is_warning(text); }),
             "red, \u2716", "is wrong, or missing");
  }

  /// What the lines of the boxes say.
  void add_lines() {
    const auto add_line = [&](PictureLine::Kind kind, std::string sign, std::string words) {
      // What is wrong with a condition stands behind the word before it: `✖ causing`.
      const auto is_one = [&](const PictureLine& line) {
        const std::size_t word = line.key.rfind(' ');
        return line.kind == kind || (line.kind == PictureLine::Kind::wrong && word != std::string::npos &&
                                     sign.find(line.key.substr(word + 1)) != std::string::npos);
      };
      const bool drawn = has_line(picture_, is_one);
      add_sign(drawn, std::move(sign), std::move(words));
    };
    add_sign(has_line(picture_, PictureLine::Kind::doubtful) || any(picture_.wrong, is_warning), std::string(warning),
             "a warning, or a lint");
    add_line(PictureLine::Kind::when, "when, stay", "when must hold for it to run, stay is enough to go on");
    add_line(PictureLine::Kind::causing, "causing", "makes that true when it is pushed");
    add_line(PictureLine::Kind::sets, "sets", "may set that, and promises nothing");
    add_line(PictureLine::Kind::runs, "on, every", "runs again then");
    add_line(PictureLine::Kind::outer, "extern", "whoever imports this file must provide it");
  }

  const Picture& picture_;
  const bool marked_;
  std::vector<LegendEntry> out_;
};

} // namespace

std::vector<LegendEntry> legend_of(const Picture& picture) { return Legend(picture).entries(); }

std::vector<std::string> legend_table(const Picture& picture) {
  std::vector<std::string> out;
  out.emplace_back("<TABLE BORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">");
  constexpr std::size_t letter_width = 9; // more than any font needs, like that of the boxes
  const std::size_t letters = picture.longest_head == 0 ? 0 : picture.title.size() + 2 + picture.longest_head;
  const std::string room = letters == 0 ? "" : fmt::format(" WIDTH=\"{}\"", letters * letter_width);
  const auto line = [&](const std::string& text) {
    out.push_back(fmt::format("<TR><TD COLSPAN=\"3\" ALIGN=\"LEFT\"{}>{}</TD></TR>", room, text));
  };
  const std::string moment = picture.moment.empty() ? "" : ", " + html_attribute(picture.moment);
  line(fmt::format("<B>{}{}</B>", html_attribute(picture.title), moment));
  for (const std::string& value : picture.values) line(html_attribute(value));
  for (const std::string& wrong : picture.wrong)
    line(fmt::format("<FONT COLOR=\"{}\">{}</FONT>", is_warning(wrong) ? palette::when : palette::queued,
                     palette::wrapped(wrong) + "<BR ALIGN=\"LEFT\"/>"));
  for (const LegendEntry& entry : legend_of(picture)) out.push_back(table_row(entry));
  out.emplace_back("</TABLE>");
  return out;
}

} // namespace director::compiler
