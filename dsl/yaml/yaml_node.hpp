#pragma once
// SPDX-License-Identifier: MIT
// A node of a YAML file with its place. Nothing is converted: a scalar is its text, and whether it was quoted.

#include "dsl/source/span.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

struct YamlPair;

struct YamlNode {
  enum class Kind {
    broken, ///< a diagnostic has been given for it: look no further
    null,   ///< nothing, `~` or a bare null; the place is that of the key or dash before it
    scalar,
    list,
    mapping
  };
  enum class Style { plain, single_quoted, double_quoted, literal, folded };

  Kind kind = Kind::broken;
  Style style = Style::plain;  ///< of a scalar
  bool left_out = false;       ///< of a mapping: a diagnostic has been given for some key, so none should be missed
  std::string text;            ///< of a scalar
  std::vector<YamlNode> items; ///< of a list
  std::vector<YamlPair> pairs; ///< of a mapping, in the order of the file, each key once
  Span span{};

  bool quoted() const { return style != Style::plain; }
  /// The value of a key; nullptr without it, or if this is no mapping.
  const YamlNode* find(std::string_view key) const;
};

struct YamlPair {
  Word key;
  YamlNode::Style key_style = YamlNode::Style::plain;
  YamlNode value;
  Span span{}; ///< from the key to the end of the value
};

/// The places of the parts of a scalar's text; the place of the whole scalar if escapes or folding hide them. Both
/// texts are scanned once, for any number of parts.
class PlacesWithin {
public:
  PlacesWithin(const YamlNode& scalar, std::string_view source);
  /// The bytes [first, last). `first == last` is a place between two bytes.
  Span span(std::size_t first, std::size_t last) const;

private:
  Span whole_;
  std::size_t text_ = 0;            ///< where the text begins; without `places_`, it stands there as it is
  std::vector<std::size_t> places_; ///< of each byte of the text, and of its end
  bool known_ = true;
};

/// The lines of a scalar, each trimmed, and each with its place if the scalar is a literal (`|`).
std::vector<Word> lines_of(const YamlNode& scalar, std::string_view source);

} // namespace director::dsl
