// Header: compiler/emit/graph/formats.hpp. Test: tests/compiler/emit/graph/svg_test.cpp.
// SPDX-License-Identifier: MIT
//
// Adds what Graphviz cannot draw: bands of the picture's whole width behind the layers, from the name of one to the
// name of the next, labels in front of all lines, and a description. Nothing that it placed is moved.
#include "compiler/base/counted.hpp"
#include "compiler/base/html.hpp"
#include "compiler/base/replace_all.hpp"
#include "compiler/emit/graph/dot_text.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

constexpr std::size_t nowhere = std::string::npos;

std::optional<double> number_behind(const std::string& text, std::size_t from, std::string_view key) {
  const std::size_t at = text.find(key, from);
  if (at == nowhere) return {};
  double out = 0;
  const char* begin = text.data() + at + key.size();
  const auto read = std::from_chars(begin, text.data() + text.size(), out);
  return read.ec == std::errc() ? std::optional(out) : std::nullopt;
}

/// As Graphviz writes it in a title.
std::string title_text(std::string_view text) {
  std::string out;
  for (const char letter : html_attribute(text)) out += letter == '-' ? "&#45;" : std::string(1, letter);
  return out;
}

/// The base line of the first text behind a place.
std::optional<double> text_height(const std::string& svg, std::size_t from) {
  const std::size_t text = svg.find("<text", from);
  return text == nowhere ? std::nullopt : number_behind(svg, text, " y=\"");
}

struct Band {
  double top = 0, bottom = 0;
};

std::vector<Band> bands_of(const Picture& picture, const std::string& svg, double top, double bottom) {
  constexpr double above_name = 16;
  std::vector<Band> out;
  for (const PictureLayer& layer : picture.layers) {
    const std::size_t at = svg.find(fmt::format("<title>{}</title>", title_text(layer.title())));
    if (at == nowhere) continue;
    const std::optional<double> name = text_height(svg, at);
    if (!name) continue;
    if (!out.empty()) out.back().bottom = *name - above_name;
    out.push_back({out.empty() ? top : *name - above_name, bottom});
  }
  return out;
}

/// Adds them behind everything but the background polygon.
void add_bands(const Picture& picture, std::string& svg) {
  constexpr double above_legend = 12;
  const std::size_t paper = svg.find("<polygon");
  if (paper == nowhere) return;
  const std::size_t end = svg.find('\n', paper);
  const std::optional<double> legend = text_height(svg, end);
  const std::optional<double> width = number_behind(svg, 0, "viewBox=\"0.00 0.00 ");
  const std::optional<double> height = number_behind(svg, 0, "translate(4 ");
  if (end == nowhere || !legend || !width || !height) return;
  std::string drawn;
  bool dark = true;
  for (const Band& band : bands_of(picture, svg, -*height, *legend - above_legend)) {
    if (dark && band.bottom > band.top)
      drawn +=
          fmt::format("<rect class=\"band\" fill=\"{}\" x=\"-4\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                      palette::band, band.top, *width, band.bottom - band.top);
    dark = !dark;
  }
  svg.insert(end + 1, drawn);
}

/// Whether XML reads these letters as a character: `&amp;`, `&#38;`.
bool is_entity(std::string_view text) {
  const std::string_view name = text.substr(0, text.find(';'));
  return name.size() < text.size() && (name.starts_with("&#") || name == "&amp" || name == "&lt" || name == "&gt" ||
                                       name == "&quot" || name == "&apos");
}

/// Graphviz, up to some version, writes the `&` of an address as it is.
void escape_addresses(std::string& svg) {
  constexpr std::string_view open = "xlink:href=\"";
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = svg.find(open); at != nowhere; at = svg.find(open, from)) {
    const std::size_t begin = at + open.size(), end = svg.find('"', begin);
    if (end == nowhere) break;
    out.append(svg, from, begin - from);
    for (std::string_view rest(svg.data() + begin, end - begin); !rest.empty(); rest.remove_prefix(1))
      out += rest.front() == '&' && !is_entity(rest) ? "&amp;" : std::string(1, rest.front());
    from = end;
  }
  svg = out.append(svg, from);
}

/// Puts an arrow between the names of both ends: `Walk:halting` is `Walk.halting` in findings.
void name_arrows(std::string& svg) {
  constexpr std::string_view open = "<title>", close = "</title>";
  for (std::size_t at = svg.find(open); at != nowhere; at = svg.find(open, at + 1)) {
    const std::size_t end = svg.find(close, at);
    if (end == nowhere) return;
    std::string title = svg.substr(at, end - at);
    if (title.find("&#45;&gt;") != nowhere) replace_all(title, ":", ".");
    replace_all(title, "&#45;&gt;", " \u2192 ");
    svg.replace(at, end - at, title);
  }
}

/// In place of the paper of a label, which also hides lines beside its letters: the letters once more, in white and
/// wider, behind themselves.
std::string with_halo(const std::string& label) {
  constexpr std::string_view paper = "<polygon", text = "<text ", close = "</text>\n", end = "/>\n";
  const std::size_t at = label.find(paper);
  if (at == nowhere) return label;
  const std::size_t behind = label.find(end, at);
  if (behind == nowhere) return label;
  std::string halo;
  for (std::size_t from = label.find(text, behind); from != nowhere; from = label.find(text, from + 1)) {
    const std::size_t to = label.find(close, from);
    if (to == nowhere) return label;
    std::string copy = label.substr(from, to + close.size() - from);
    if (const std::size_t fill = copy.find(" fill=\""); fill < copy.find('>'))
      copy.erase(fill, copy.find('"', fill + 7) + 1 - fill);
    // In small letters, as Graphviz writes colours: the style of pages finds white by them.
    halo += copy.insert(text.size(), "class=\"halo\" aria-hidden=\"true\" fill=\"#ffffff\" stroke=\"#ffffff\" "
                                     "stroke-width=\"8\" stroke-linejoin=\"round\" ");
  }
  std::string out = label;
  return out.replace(at, behind + end.size() - at, halo);
}

/// Graphviz writes a label with its own arrow, so that arrows which it writes later would strike it out.
void bring_labels_to_front(std::string& svg) {
  constexpr std::string_view arrow = "class=\"edge\">\n", link = "<g id=\"a_edge", label = "&#45;label\"",
                             close = "</a>\n</g>\n", open_title = "<title>", close_title = "</title>\n",
                             close_picture = "</g>\n</svg>";
  std::string out, labels;
  std::size_t from = 0;
  std::size_t name = svg.find(label);
  for (std::size_t at = svg.find(arrow), next = 0; at != nowhere && name != nowhere; at = next) {
    next = svg.find(arrow, at + arrow.size());
    if (name < at) name = svg.find(label, at);
    if (name == nowhere || name > next) continue;
    const std::size_t begin = svg.rfind(link, name), end = svg.find(close, name);
    const std::size_t title = svg.find(open_title, at), words = svg.find(close_title, title);
    if (begin == nowhere || begin < at || end == nowhere || words == nowhere) continue;
    labels += fmt::format("<g class=\"label\">\n{}{}</g>\n", svg.substr(title, words + close_title.size() - title),
                          with_halo(svg.substr(begin, end + close.size() - begin)));
    out.append(svg, from, begin - from);
    from = end + close.size();
  }
  out.append(svg, from);
  if (const std::size_t end = out.rfind(close_picture); end != nowhere) out.insert(end, labels);
  svg = std::move(out);
}

void add_words(const Picture& picture, std::string& svg) {
  const std::size_t tag = svg.find("<svg ");
  const std::size_t end = tag == nowhere ? nowhere : svg.find('>', tag);
  if (end == nowhere) return;
  svg.insert(end + 1, fmt::format("\n<title>{}</title>\n<desc>{}</desc>", html_attribute(picture.title),
                                  html_attribute(summary(picture))));
  svg.insert(tag + 5, "role=\"graphics-document document\" ");
}

/// ` in 3 layers and in none`; empty: each group has a box of its own.
std::string folds(const Picture& picture) {
  const bool layers = picture.fold == PictureOptions::Fold::layers;
  const auto outside = std::count_if(picture.boxes.begin(), picture.boxes.end(), [&](const PictureBox& box) {
    return layers && box.kind == PictureBox::Kind::folded && box.name == no_layer;
  });
  const auto folded = std::count_if(picture.boxes.begin(), picture.boxes.end(),
                                    [](const PictureBox& box) { return box.kind == PictureBox::Kind::folded; });
  if (folded == 0) return {};
  if (folded == outside) return " in no layer";
  return fmt::format(" in {}{}", counted(static_cast<std::size_t>(folded - outside), layers ? "layer" : "module"),
                     outside == 0 ? "" : " and in none");
}

std::string_view words_for(PictureArrow::Kind kind) {
  using Kind = PictureArrow::Kind;
  return kind == Kind::task ? "requests" : kind == Kind::need ? "needs" : kind == Kind::push ? "pushes" : "take-overs";
}

} // namespace

std::string summary(const Picture& picture) {
  using Kind = PictureArrow::Kind;
  std::size_t groups = 0;
  std::string roots;
  for (const PictureBox& box : picture.boxes) {
    groups += box.groups.size();
    for (const std::string& root : box.roots) roots += (roots.empty() ? "" : ", ") + root;
  }
  const auto count = [&](auto... kinds) {
    return static_cast<std::size_t>(std::count_if(picture.arrows.begin(), picture.arrows.end(), [&](const auto& arrow) {
      return !arrow.hidden && ((arrow.kind == kinds) || ...);
    }));
  };
  std::string out = groups < picture.all_groups ? fmt::format("{} of {}", groups, counted(picture.all_groups, "group"))
                                                : counted(groups, "group");
  out += folds(picture);
  std::string layers;
  std::size_t named = 0;
  for (const PictureLayer& layer : picture.layers) {
    if (layer.name.empty()) continue;
    layers += (layers.empty() ? "" : ", ") + layer.name;
    ++named;
  }
  if (!layers.empty()) out += fmt::format(", in the {} {}", named == 1 ? "layer" : "layers", layers);
  std::string arrows;
  for (const Kind kind : picture.kinds) {
    const bool may_be_both = kind == Kind::task || kind == Kind::need;
    arrows += fmt::format("{}{} for {}", arrows.empty() ? "" : ", ",
                          may_be_both ? count(kind, Kind::both) : count(kind), words_for(kind));
  }
  if (!arrows.empty()) out += fmt::format("; arrows: {}", arrows);
  out += ".";
  if (!roots.empty())
    out += fmt::format(" {} program requests {}.", groups < picture.all_groups ? "Of these, the" : "The", roots);
  if (!picture.moment.empty()) {
    const auto marked = [&](Moment::Mark mark, std::string_view word) {
      std::string names;
      for (const PictureBox& box : picture.boxes) {
        const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
        for (const PictureMember& member : box.members) {
          if (member.now && member.now->mark == mark) add(member.name);
        }
        if (box.kind != PictureBox::Kind::folded && box.mark == mark) add(box.name);
      }
      if (!names.empty()) out += fmt::format(" {}: {}.", word, names);
    };
    out += fmt::format(" This is {}.", picture.moment);
    marked(Moment::Mark::running, "Running");
    marked(Moment::Mark::pushed, "Pushed");
    marked(Moment::Mark::queued, "Queued");
  }
  if (!picture.doc.empty()) out = picture.doc + (picture.doc.ends_with('\n') ? "" : "\n") + out;
  return out;
}

std::set<std::size_t> lost_labels(const Picture& picture, const std::string& drawn) {
  constexpr std::string_view arrow = "class=\"edge\">\n<title>", close = "</title>", label = "&#45;label\"";
  std::map<std::string, std::size_t> labels; // by the title of their arrows
  for (std::size_t at = drawn.find(arrow), next = 0; at != nowhere; at = next) {
    next = drawn.find(arrow, at + arrow.size());
    const std::size_t begin = at + arrow.size(), end = drawn.find(close, begin);
    if (end == nowhere) break;
    const std::string_view lines = std::string_view(drawn).substr(end, next == nowhere ? nowhere : next - end);
    if (lines.find(label) != nowhere) ++labels[drawn.substr(begin, end - begin)];
  }
  const auto name = [&](const PictureEnd& end) {
    const std::string at = port(picture, end);
    return title_text(picture.boxes[end.box].name + (at.empty() ? "" : ":" + at));
  };
  std::map<std::string, std::set<std::size_t>> labelled;
  for (std::size_t i = 0; i < picture.arrows.size(); ++i) {
    const PictureArrow& each = picture.arrows[i];
    if (!each.hidden && !label_text(each).empty()) labelled[name(each.from) + "&#45;&gt;" + name(each.to)].insert(i);
  }
  std::set<std::size_t> out;
  for (auto& [title, arrows] : labelled) {
    if (labels[title] < arrows.size()) out.merge(arrows);
  }
  return out;
}

std::string finish_svg(const Picture& picture, const std::string& drawn) {
  std::string out = drawn;
  escape_addresses(out);
  add_bands(picture, out);
  bring_labels_to_front(out);
  replace_all(out, target_in_svg, "");
  replace_all(out, "stroke-dasharray=\"1,5\"", "stroke-dasharray=\"2,3\""); // dots that far apart nearly vanish
  name_arrows(out);
  add_words(picture, out);
  return out;
}

} // namespace director::compiler
