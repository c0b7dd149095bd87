#pragma once
// SPDX-License-Identifier: MIT
// A picture that Graphviz drew, as far as a test measures it: where its boxes and labels are, and what it says of them.

#include <string>
#include <vector>

namespace director::tests {

struct SvgBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  bool overlaps(const SvgBox& other) const;
  bool holds(const SvgBox& other) const;
};

struct SvgThing {
  bool is_arrow = false;
  std::string title;                 ///< as a reader gets it, without the escapes of XML
  std::vector<std::string> tooltips; ///< of it and of its parts
  std::vector<std::string> links;
  SvgBox box;                 ///< of a node: all of it; of an arrow: its line
  std::vector<SvgBox> labels; ///< of an arrow, the paper below it
};

struct Svg {
  std::string title, description; ///< for who cannot see it
  double width = 0, height = 0;   ///< in points
  SvgBox paper;
  std::vector<SvgThing> things;
  std::vector<std::string> text_colours; ///< each once, `#5a616b`
  std::vector<std::string> grounds;      ///< colours that text stands on
};

Svg read_svg(const std::string& text);

/// Of WCAG 2: from 1 to 21.
double contrast(const std::string& one, const std::string& other);

} // namespace director::tests
