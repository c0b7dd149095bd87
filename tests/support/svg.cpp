// Header: tests/support/svg.hpp. Test: tests/compiler/cli/picture_svg_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/support/svg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <sstream>

namespace director::tests {

namespace {

using Matches = std::sregex_iterator;

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

std::string first(const std::string& text, const std::string& pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string{};
}

std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  std::vector<std::string> out;
  const std::regex each(pattern);
  for (Matches at(text.begin(), text.end(), each), end; at != end; ++at) out.push_back((*at)[1].str());
  return out;
}

/// Around all numbers of a list of points, whatever letters are between them.
SvgBox around(const std::vector<std::string>& lists) {
  constexpr double far = std::numeric_limits<double>::max();
  SvgBox out{far, far, -far, -far};
  static const std::regex number("-?[0-9.]+");
  for (const std::string& list : lists) {
    bool is_x = true;
    for (Matches at(list.begin(), list.end(), number), end; at != end; ++at, is_x = !is_x) {
      const double value = std::stod(at->str());
      double &low = is_x ? out.left : out.top, &high = is_x ? out.right : out.bottom;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return out;
}

/// Points on the curves of a path: `M1,2C3,4 5,6 7,8`. Those that bend it are beside it.
std::string on_the_curve(const std::string& path) {
  static const std::regex pair("(-?[0-9.]+),(-?[0-9.]+)");
  std::vector<std::pair<double, double>> points;
  for (Matches at(path.begin(), path.end(), pair), end; at != end; ++at)
    points.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
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
  out.title = plain(first(text, "<title>([^<]*)</title>"));
  for (const std::string& words : all(text, "xlink:title=\"([^\"]*)\"")) out.tooltips.push_back(plain(words));
  for (const std::string& link : all(text, "xlink:href=\"([^\"]*)\"")) out.links.push_back(plain(link));
  std::vector<std::string> points = all(text, "<path[^>]* d=\"([^\"]*)\"");
  if (is_arrow) {
    for (std::string& path : points) path = on_the_curve(path);
    for (const std::string& label : all(text, "<polygon fill=\"#ffffff\" stroke=\"transparent\" points=\"([^\"]*)\""))
      out.labels.push_back(around({label}));
  } else {
    for (const std::string& polygon : all(text, "points=\"([^\"]*)\"")) points.push_back(polygon);
    for (const std::string& at : all(text, "<text[^>]* x=\"([^\"]*\" y=\"[^\"]*)\"")) points.push_back(at);
  }
  out.box = around(points);
  return out;
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
  out.title = plain(first(text, "<svg[^>]*>\\s*<title>([^<]*)</title>"));
  out.description = plain(first(text, "<desc>([^<]*)</desc>"));
  out.width = std::stod(first(text, "<svg[^>]* width=\"([0-9]+)pt\""));
  out.height = std::stod(first(text, "<svg[^>]* height=\"([0-9]+)pt\""));
  out.paper = around({first(text, "<polygon[^>]* points=\"([^\"]*)\"")});
  static const std::regex begin("<g id=\"[a-z]+[0-9]+\" class=\"(node|edge)\">");
  std::size_t at = 0;
  std::string kind;
  for (Matches each(text.begin(), text.end(), begin), end;; ++each) {
    const auto next = each == end ? text.size() : static_cast<std::size_t>(each->position());
    if (!kind.empty()) out.things.push_back(read_thing(text.substr(at, next - at), kind == "edge"));
    if (each == end) break;
    at = next;
    kind = (*each)[1];
  }
  out.text_colours = unique(all(text, "<text[^>]* fill=\"(#[0-9a-f]{6})\""));
  out.grounds = unique(all(text, "<rect class=\"band\" fill=\"(#[0-9A-Fa-f]{6})\""));
  out.grounds.emplace_back("#ffffff");
  return out;
}

double contrast(const std::string& one, const std::string& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

} // namespace director::tests
