#pragma once
// SPDX-License-Identifier: MIT
// Builds a YAML tree from a parser's events. A parser reports where things begin; this class finds in the text where
// they end, and reports what the parser accepts although the language forbids it. Offsets are bytes of the text.

#include "dsl/source/diagnostic.hpp"
#include "dsl/yaml/yaml_node.hpp"
#include "dsl/yaml/yaml_scan.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::dsl {

/// Limit for nested lists and mappings.
inline constexpr std::size_t deepest_nesting = 64;
/// Limit for keys, scalars, lists and mappings in one file. A group has about 30; each costs 200 bytes here and about
/// as much later.
inline constexpr std::size_t most_values = 2'000'000;

class TreeBuilder {
public:
  /// Thrown to end the reading; its diagnostic has been added.
  struct Stop {};

  TreeBuilder(FileId file, std::string_view text, std::vector<Diagnostic>& diagnostics);

  // Events. `at` is where the parser's mark stands, in front of an anchor or a tag.
  void null(std::size_t at);
  void alias(std::size_t at);
  /// `plain`: neither quoted nor a block.
  void scalar(std::size_t at, const std::string& value, bool plain);
  void start(YamlNode::Kind kind, std::size_t at, bool flow);
  void finish();

  YamlNode take_root() { return std::move(root_); }
  /// The parser has read everything before this offset.
  std::size_t cursor() const { return cursor_; }
  /// The innermost list or mapping in brackets that is still open.
  std::optional<std::size_t> open_bracket() const;
  /// A parser that meets the end inside brackets makes the last word a key: this removes the diagnostic about that key.
  void forget_last_key();
  void report_bare_key(const yaml_scan::BareKey& key);
  void refuse_long_key(const yaml_scan::BareKey& key);
  /// The parser cannot continue after it.
  bool refused_long_key() const { return refused_long_key_; }

  void report(std::string id, std::size_t begin, std::size_t end, std::string message, std::string help = "",
              std::vector<Note> notes = {});
  /// A span that ends at the last byte of the text that is not blank, or before.
  Span span(std::size_t begin, std::size_t end) const;

private:
  struct Frame {
    YamlNode node;
    bool brackets = false;
    std::optional<YamlPair> pair{}; ///< a key that waits for its value
    bool drop = false;              ///< ... and is not kept
  };

  std::size_t refuse_properties(std::size_t at);
  std::size_t least_indentation() const;
  YamlNode begin(YamlNode::Kind kind, std::size_t first, std::size_t last);
  void end(YamlNode node);
  void begin_pair(Frame& frame, YamlNode key);
  void refuse_duplicates(YamlNode& mapping);

  FileId file_;
  std::string_view text_;
  std::size_t content_size_; ///< without the blanks at the end of the text
  std::vector<Diagnostic>& diagnostics_;
  YamlNode root_;
  std::vector<Frame> open_;
  std::size_t cursor_ = 0;
  std::size_t values_ = 0;
  std::optional<std::size_t> last_key_report_; ///< index into diagnostics_
  bool refused_long_key_ = false;
};

} // namespace director::dsl
