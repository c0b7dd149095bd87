// Header: tests/support/svg.hpp. Test: tests/compiler/emit/graph/svg_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/support/svg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>
#include <utility>

namespace director::tests {

namespace {

std::string plain(std::string text) {
  static const std::vector<std::pair<std::string, std::string>> escapes{
      {"&#45;", "-"}, {"&#10;", "\n"},  {"&#160;", " "}, {"&lt;", "<"},
      {"&gt;", ">"},  {"&quot;", "\""}, {"&#39;", "'"},  {"&amp;", "&"}};
  for (const auto& [escape, letter] : escapes) {
    for (std::size_t at = text.find(escape); at != std::string::npos; at = text.find(escape, at + letter.size()))
      text.replace(at, escape.size(), letter);
  }
  return text;
}

// Not with std::regex: tests are not optimised, and it would take most of the time that they run.

/// What stands between `begin` and the next `end`, each time.
std::vector<std::string> all_between(std::string_view text, std::string_view begin, std::string_view end) {
  std::vector<std::string> out;
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at)) {
    at += begin.size();
    const std::size_t to = text.find(end, at);
    if (to == text.npos) break;
    out.emplace_back(text.substr(at, to - at));
  }
  return out;
}

std::string first_of(const std::vector<std::string>& all) { return all.empty() ? std::string{} : all.front(); }

std::string between(std::string_view text, std::string_view begin, std::string_view end) {
  return first_of(all_between(text, begin, end));
}

/// Of each element with this name, the attributes as they are written.
std::vector<std::string> elements(std::string_view text, const std::string& name) {
  return all_between(text, "<" + name + " ", ">");
}

/// Of one of them; empty where it has none.
std::string attribute(std::string_view written, const std::string& name) {
  return between(" " + std::string(written), " " + name + "=\"", "\"");
}

/// Of each element with this name that has the attribute.
std::vector<std::string> attributes(std::string_view text, const std::string& element, const std::string& name) {
  std::vector<std::string> out;
  for (const std::string& written : elements(text, element)) {
    if (std::string found = attribute(written, name); !found.empty()) out.push_back(std::move(found));
  }
  return out;
}

std::vector<double> numbers(const std::string& list) {
  static const char* const digits = "0123456789.";
  std::vector<double> out;
  for (std::size_t at = list.find_first_of(digits); at != list.npos;) {
    const std::size_t end = std::min(list.find_first_not_of(digits, at), list.size());
    const bool is_negative = at > 0 && list[at - 1] == '-';
    out.push_back((is_negative ? -1 : 1) * std::stod(list.substr(at, end - at)));
    at = list.find_first_of(digits, end);
  }
  return out;
}

/// Around all points of lists `1,2 3,4`, whatever letters are between them.
SvgBox around(const std::vector<std::string>& lists) {
  constexpr double far = std::numeric_limits<double>::max();
  SvgBox out{far, far, -far, -far};
  for (const std::string& list : lists) {
    bool is_x = true;
    for (const double value : numbers(list)) {
      double &low = is_x ? out.left : out.top, &high = is_x ? out.right : out.bottom;
      low = std::min(low, value);
      high = std::max(high, value);
      is_x = !is_x;
    }
  }
  return out;
}

/// Points on the curves of a path: `M1,2C3,4 5,6 7,8`. Those that bend it are beside it.
std::string on_the_curve(const std::string& path) {
  const std::vector<double> values = numbers(path);
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) points.emplace_back(values[i], values[i + 1]);
  std::ostringstream out;
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    for (int step = 0; step <= 20; ++step) {
      const double t = step / 20.0, s = 1 - t;
      const auto mix = [&](auto of) {
        return s * s * s * points[i].*of + 3 * s * s * t * points[i + 1].*of + 3 * s * t * t * points[i + 2].*of +
               t * t * t * points[i + 3].*of;
      };
      out << mix(&std::pair<double, double>::first) << ',' << mix(&std::pair<double, double>::second) << ' ';
    }
  }
  return out.str();
}

SvgThing read_thing(const std::string& text, bool is_arrow) {
  SvgThing out;
  out.is_arrow = is_arrow;
  out.title = plain(between(text, "<title>", "<"));
  for (const std::string& words : all_between(text, "xlink:title=\"", "\"")) out.tooltips.push_back(plain(words));
  for (const std::string& link : all_between(text, "xlink:href=\"", "\"")) out.links.push_back(plain(link));
  std::vector<std::string> points = attributes(text, "path", "d");
  if (is_arrow) {
    for (std::string& path : points) path = on_the_curve(path);
  } else {
    for (const std::string& polygon : all_between(text, "points=\"", "\"")) points.push_back(polygon);
    for (const std::string& words : elements(text, "text"))
      points.push_back(attribute(words, "x") + "," + attribute(words, "y"));
  }
  out.box = around(points);
  return out;
}

/// The halo of a label repeats its letters.
std::string without_halos(std::string text) {
  constexpr std::string_view halo = "<text class=\"halo\"";
  for (std::size_t at = text.find(halo); at != text.npos; at = text.find(halo, at))
    text.erase(at, text.find('\n', at) + 1 - at);
  return text;
}

/// With letters as wide as in the widest font.
SvgBox box_of_letters(const std::string& label) {
  constexpr double letter_width = 6, above = 8, below = 2;
  SvgBox out{1e9, 1e9, -1e9, -1e9};
  for (const std::string& line : all_between(without_halos(label), "<text ", "</text>")) {
    const double x = std::stod(attribute(line, "x")), y = std::stod(attribute(line, "y"));
    const auto letters = static_cast<double>(plain(line.substr(line.find('>') + 1)).size());
    out.left = std::min(out.left, x);
    out.right = std::max(out.right, x + letter_width * letters);
    out.top = std::min(out.top, y - above);
    out.bottom = std::max(out.bottom, y + below);
  }
  return out;
}

/// A label stands behind all arrows, with the title of its own.
void add_label(const std::string& text, std::vector<SvgThing>& things) {
  const std::string title = plain(between(text, "<title>", "<"));
  for (SvgThing& thing : things) {
    if (!thing.is_arrow || thing.title != title) continue;
    thing.labels.push_back(box_of_letters(text));
    for (const std::string& words : all_between(text, "xlink:title=\"", "\"")) thing.tooltips.push_back(plain(words));
    for (const std::string& link : all_between(text, "xlink:href=\"", "\"")) thing.links.push_back(plain(link));
    return;
  }
}

double luminance(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    const double value = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

std::vector<std::string> unique(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

} // namespace

bool SvgBox::overlaps(const SvgBox& other) const {
  return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
}

bool SvgBox::holds(const SvgBox& other) const {
  return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
}

Svg read_svg(const std::string& text) {
  Svg out;
  out.title = plain(between(between(text, "<svg ", "</title>") + "<", ">\n<title>", "<"));
  out.description = plain(between(text, "<desc>", "</desc>"));
  out.width = std::stod(first_of(attributes(text, "svg", "width")));
  out.height = std::stod(first_of(attributes(text, "svg", "height")));
  out.paper = around({first_of(attributes(text, "polygon", "points"))});
  static constexpr std::string_view label = "<g class=\"label\">";
  std::size_t from = 0;
  std::string kind;
  for (std::size_t at = text.find("<g id=");; at = text.find("<g id=", at + 1)) {
    const std::string next = at == text.npos ? "" : attribute(text.substr(at, text.find('>', at) - at), "class");
    if (at != text.npos && next != "node" && next != "edge") continue;
    const std::size_t end = std::min(at, text.find(label, from));
    if (!kind.empty()) out.things.push_back(read_thing(text.substr(from, end - from), kind == "edge"));
    if (at == text.npos) break;
    from = at;
    kind = next;
  }
  for (const std::string& written : all_between(text, label, "</a>")) add_label(written, out.things);
  out.text_colours = unique(attributes(without_halos(text), "text", "fill"));
  out.grounds = unique(all_between(text, "<rect class=\"band\" fill=\"", "\""));
  out.grounds.emplace_back("#ffffff");
  return out;
}

double contrast(const std::string& one, const std::string& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

} // namespace director::tests
