// Header: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
//
// A layer is a subgraph, and so is a group with several providers. Their ids are numbers: names may be keywords of
// Mermaid.
#include "compiler/base/html.hpp"
#include "compiler/base/replace_all.hpp"
#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/legend.hpp"
#include "compiler/emit/graph/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace director::compiler {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
    case '"': out += "#quot;"; break;
    case '<': out += "#lt;"; break;
    case '>': out += "#gt;"; break;
    case '|': out += "#124;"; break;
    case '\n': out += "<br/>"; break;
    default: out += letter;
    }
  }
  return out;
}

class Mermaid {
public:
  Mermaid(const Picture& picture, const PictureLinks& links) : picture_(picture), links_(links) {}

  std::string draw() {
    code_.line("%%{init: {\"flowchart\": {\"wrappingWidth\": 700}}}%%"); // for the lines of the legend
    code_.open("flowchart TB");
    code_.line(fmt::format("accTitle: {}", escaped(picture_.title)));
    std::string words = summary(picture_);
    std::replace(words.begin(), words.end(), '\n', ' ');
    code_.line(fmt::format("accDescr: {}", escaped(words)));
    for (std::size_t i = 0; i < picture_.layers.size(); ++i) {
      const PictureLayer& layer = picture_.layers[i];
      if (!layer.name.empty()) code_.open(fmt::format("subgraph l{}[\"{}\"]", i, escaped(layer.name)));
      for (const std::size_t box : layer.boxes) draw_box(box);
      if (!layer.name.empty()) code_.close("end");
    }
    for (const PictureArrow& arrow : picture_.arrows) draw_arrow(arrow);
    draw_roots();
    draw_marks();
    draw_line_marks();
    draw_class("focus", "stroke-width:5px", [](const PictureBox& box) { return box.in_focus; });
    draw_legend(); // behind all arrows, which are numbered
    if (!links_.pattern.empty()) draw_links();
    code_.close("");
    return code_.text();
  }

private:
  static std::string lines(const std::vector<PictureLine>& all) {
    std::string out;
    for (const PictureLine& line : all) out += "<br/>" + words_of(line);
    return out;
  }

  static std::string words_of(const PictureLine& line) {
    return fmt::format("{}{}{}", line.key, line.text.empty() ? "" : " ", escaped(line.text));
  }

  static bool is_flaw(const PictureLine& line) {
    return line.kind == PictureLine::Kind::wrong || line.kind == PictureLine::Kind::doubtful;
  }

  static std::string note_of(const PictureBox& box) {
    if (!box.mark) return {};
    const bool has_sign = std::any_of(box.rows.begin(), box.rows.end(),
                                      [&](const PictureRow& row) { return row.is_active && !row.name.empty(); });
    if (box.kind != PictureBox::Kind::folded)
      return note_of(has_sign ? "" : std::string(runs_sign), {}, {*box.mark, {}, box.note});
    std::string out;
    for (const PictureMember& member : box.members) {
      if (member.now) out += note_of(std::string(runs_sign), escaped(member.name) + " ", *member.now);
    }
    return out;
  }

  static std::string note_of(const std::string& sign, const std::string& name, const Moment::Standing& now) {
    switch (now.mark) {
    case Moment::Mark::running: return fmt::format("<br/>{}{}running", sign, name);
    case Moment::Mark::queued: return fmt::format("<br/>{}queued: {}", name, escaped(now.note));
    case Moment::Mark::pushed: return fmt::format("<br/>{}{}", name, escaped(now.note));
    case Moment::Mark::held: return fmt::format("<br/>{}held for what needs it", name);
    case Moment::Mark::inactive: break;
    }
    return {};
  }

  static constexpr std::string_view runs_sign = "\u25B6 ";

  void draw_line_marks() {
    const std::array<std::string, 5> styles{
        fmt::format("stroke:{}", palette::faint), fmt::format("stroke:{},stroke-width:3px", palette::need),
        fmt::format("stroke:{},stroke-dasharray:6 3,stroke-width:2px", palette::queued),
        fmt::format("stroke:{},stroke-width:3px", palette::need), fmt::format("stroke:{}", palette::need)};
    for (std::size_t mark = 0; mark < styles.size(); ++mark) {
      std::string lines;
      for (std::size_t i = 0; i < picture_.arrows.size(); ++i) {
        if (is_request_or_need(picture_.arrows[i]) && picture_.arrows[i].mark == static_cast<Moment::Mark>(mark))
          lines += fmt::format("{}{}", lines.empty() ? "" : ",", i);
      }
      if (!lines.empty()) code_.line(fmt::format("linkStyle {} {}", lines, styles[mark]));
    }
  }

  static bool is_request_or_need(const PictureArrow& arrow) {
    return arrow.kind != PictureArrow::Kind::push && arrow.kind != PictureArrow::Kind::take;
  }

  void draw_marks() {
    const std::array<std::string, 5> styles{
        fmt::format("stroke:{},color:{}", palette::faint, palette::grey),
        fmt::format("stroke:{},stroke-width:3px", palette::need),
        fmt::format("stroke:{},stroke-dasharray:6 3,stroke-width:2px", palette::queued),
        fmt::format("stroke:{},stroke-width:3px", palette::push),
        fmt::format("stroke:{},stroke-dasharray:2 2", palette::need)};
    constexpr std::array<std::string_view, 5> names{"inactive", "running", "queued", "pushed", "held"};
    for (std::size_t mark = 0; mark < styles.size(); ++mark)
      draw_class(names[mark], styles[mark],
                 [&](const PictureBox& box) { return box.mark == static_cast<Moment::Mark>(mark); });
  }

  template <class Predicate>
  void draw_class(std::string_view name, std::string_view style, Predicate has_it) {
    std::string boxes;
    for (std::size_t i = 0; i < picture_.boxes.size(); ++i) {
      if (has_it(picture_.boxes[i])) boxes += fmt::format("{}g{}", boxes.empty() ? "" : ",", i);
    }
    if (boxes.empty()) return;
    code_.line(fmt::format("classDef {} {}", name, style));
    code_.line(fmt::format("class {} {}", boxes, name));
  }

  void draw_box(std::size_t at) {
    const PictureBox& box = picture_.boxes[at];
    std::string head;
    if (box.kind == PictureBox::Kind::missing) head += "<br/>\u2716 no such group";
    head += note_of(box);
    if (box.requested) head += "<br/>program" + (box.requested->empty() ? "" : ": " + escaped(*box.requested));
    std::vector<PictureLine> all = box.lines;
    if (box.is_direct()) all.insert(all.end(), box.rows.front().lines.begin(), box.rows.front().lines.end());
    if (is_node(box)) return code_.line(fmt::format("g{}[\"{}{}{}\"]", at, escaped(box.name), head, lines(all)));
    draw_title(at, box.name, head, all);
    for (std::size_t row = 0; row < box.rows.size(); ++row) {
      const PictureRow& shown = box.rows[row];
      if (!shown.name.empty())
        code_.line(fmt::format("g{}p{}[\"{}{}{}{}\"]", at, row, shown.is_active ? "\u25B6 " : "",
                               box.rows.size() > 1 ? fmt::format("{} ", row + 1) : "", escaped(shown.name),
                               lines(shown.lines)));
      for (std::size_t pack = 0; pack < shown.packs.size(); ++pack) {
        const std::string owner = shown.name.empty() ? "" : shown.name + ", ";
        code_.line(
            fmt::format("g{}p{}k{}([\"{}{}\"])", at, row, pack, escaped(owner), escaped(shown.packs[pack].name)));
      }
    }
    code_.close("end");
  }

  static bool is_node(const PictureBox& box) {
    return box.rows.empty() || (box.is_direct() && box.rows.front().packs.empty());
  }

  /// A subgraph has room for one line above its boxes. What was found, which may be long, is in it as a text.
  void draw_title(std::size_t at, const std::string& name, const std::string& head,
                  const std::vector<PictureLine>& all) {
    constexpr std::string_view next = "<br/>";
    std::string title = head, flaws;
    for (const PictureLine& line : all) {
      if (is_flaw(line)) flaws += (flaws.empty() ? "" : std::string(next)) + words_of(line);
      if (!is_flaw(line)) title += std::string(next) + words_of(line);
    }
    if (!title.empty()) title = " (" + title.substr(next.size()) + ")";
    replace_all(title, next, "; ");
    code_.open(fmt::format("subgraph g{}[\"{}{}\"]", at, escaped(name), title));
    if (flaws.empty()) return;
    code_.line(fmt::format("g{}f[\"{}\"]", at, flaws));
    code_.line(fmt::format("style g{}f fill:none,stroke:none", at));
  }

  std::string end(const PictureEnd& end) const {
    std::string out = fmt::format("g{}", end.box);
    if (end.row || end.pack) out += fmt::format("p{}", end.row.value_or(0));
    if (end.pack) out += fmt::format("k{}", *end.pack);
    return out;
  }

  static std::string_view line_of(const PictureArrow& arrow) {
    using Kind = PictureArrow::Kind;
    if (arrow.kind == Kind::push || arrow.kind == Kind::take) return "==>";
    if (arrow.kind == Kind::need) return "--o";
    return arrow.optional ? "-.->" : "-->";
  }

  static std::string label_of(const PictureArrow& arrow) {
    using Kind = PictureArrow::Kind;
    std::string out = arrow.label;
    const auto add = [&](std::string_view word) { out += fmt::format("{}{}", out.empty() ? "" : ", ", word); };
    if (arrow.kind == Kind::both) add("needs");
    if (arrow.apart && !arrow.optional) add("apart");
    if (arrow.mark == Moment::Mark::queued && is_request_or_need(arrow)) add("queued");
    if (arrow.kind == Kind::push) return "until " + out;
    if (arrow.kind == Kind::take) return "takes, " + out;
    return out;
  }

  void draw_arrow(const PictureArrow& arrow) {
    const std::string label = label_of(arrow);
    code_.line(fmt::format("{} {}{} {}", end(arrow.from), line_of(arrow),
                           label.empty() ? "" : fmt::format("|\"{}\"|", escaped(label)), end(arrow.to)));
  }

  /// At a moment thick is what runs.
  void draw_roots() {
    draw_class("root", "stroke-width:3px", [](const PictureBox& box) { return box.requested && !box.mark; });
  }

  static std::string_view sign_of(LegendEntry::Sample sample) {
    switch (sample) {
    case LegendEntry::Sample::optional: return "dotted arrow";
    case LegendEntry::Sample::apart: return "apart";
    case LegendEntry::Sample::need: return "line with a circle";
    case LegendEntry::Sample::both: return "arrow, needs";
    case LegendEntry::Sample::push: return "thick arrow, until";
    case LegendEntry::Sample::take: return "thick arrow, takes";
    case LegendEntry::Sample::task:
    case LegendEntry::Sample::text: break;
    }
    return "arrow";
  }

  static std::string sign_in_boxes(const std::string& sign) {
    if (sign == "\u25C7") return "round box";
    if (sign == "\u25BC program") return "program";
    if (sign == blue_line) return "thick blue line";
    if (sign == red_line) return "dashed red line, queued";
    return sign == "rows" ? "1, 2" : sign;
  }

  /// Providers are boxes, which the viewer places in any order.
  static std::string words_in_boxes(const LegendEntry& entry) {
    if (entry.sign != "rows") return entry.words;
    std::string out = entry.words;
    const auto put = [&](std::string_view old, std::string_view with) {
      if (const std::size_t at = out.find(old); at != std::string::npos) out.replace(at, old.size(), with);
    };
    put("the preferred one first", "the preferred one is 1");
    put("one row", "one of them");
    return out;
  }

  void draw_legend() {
    std::string text; // first the findings that are about no box
    for (const std::string& wrong : picture_.wrong) text += (text.empty() ? "" : "<br/>") + escaped(wrong);
    for (const LegendEntry& entry : legend_of(picture_)) {
      const bool is_text = entry.sample == LegendEntry::Sample::text;
      if (entry.sign == "dashed box") continue; // the names of such a box show it
      const std::string sign = !is_text ? std::string(sign_of(entry.sample)) : sign_in_boxes(entry.sign);
      text += fmt::format("{}{}: {}", text.empty() ? "" : "<br/>", escaped(sign), escaped(words_in_boxes(entry)));
    }
    if (text.empty()) return;
    code_.line(fmt::format("legend[\"{}\"]", text));
    code_.line("style legend fill:none,stroke:none,text-align:left");
    if (picture_.boxes.empty()) return;
    const std::size_t last = picture_.layers.empty() ? picture_.boxes.size() - 1 : picture_.layers.back().boxes.back();
    code_.line(fmt::format("g{} ~~~ legend", last)); // below it
  }

  void draw_links() {
    for (std::size_t i = 0; i < picture_.boxes.size(); ++i) {
      const PictureBox& box = picture_.boxes[i];
      const auto link = [&](const std::string& id, const PictureText& about) {
        if (const std::string url = links_.to(about); !url.empty())
          code_.line(fmt::format("click {} href \"{}\"", id, escaped(url)));
      };
      if (is_node(box)) link(fmt::format("g{}", i), box.about);
      if (is_node(box)) continue;
      for (std::size_t row = 0; row < box.rows.size(); ++row) {
        if (!box.rows[row].name.empty()) link(fmt::format("g{}p{}", i, row), box.rows[row].about);
      }
    }
  }

  const Picture& picture_;
  const PictureLinks& links_;
  Code code_;
};

} // namespace

std::string mermaid(const Picture& picture, const PictureLinks& links) {
  return without_controls(Mermaid(picture, links).draw());
}

} // namespace director::compiler
