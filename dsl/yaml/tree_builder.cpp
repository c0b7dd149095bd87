// Header: dsl/yaml/tree_builder.hpp. Test: tests/dsl/yaml/yaml_tree_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/yaml/tree_builder.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace director::dsl {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The end of a word, which is a byte of `ends`.
std::size_t end_of_word(std::string_view text, std::size_t at, std::string_view ends) {
  return std::min(text.find_first_of(ends, at), text.size());
}

/// The length of the word at the beginning that YAML reads as null; 0 if there is none.
std::size_t null_word(std::string_view text) {
  for (const std::string_view word : {"~", "null", "Null", "NULL"})
    if (text.starts_with(word)) return word.size();
  return 0;
}

} // namespace

TreeBuilder::TreeBuilder(FileId file, std::string_view text, std::vector<Diagnostic>& diagnostics)
    : file_(file),
      text_(text),
      content_size_(text.find_last_not_of(blanks) + 1),
      diagnostics_(diagnostics) {}

void TreeBuilder::report(std::string id, std::size_t begin, std::size_t end, std::string message, std::string help,
                         std::vector<Note> notes) {
  diagnostics_.push_back(
      {std::move(id), Level::error, span(begin, end), std::move(message), std::move(notes), std::move(help)});
}

Span TreeBuilder::span(std::size_t begin, std::size_t end) const {
  begin = std::min(begin, content_size_);
  end = std::clamp(end, begin, content_size_);
  return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

std::optional<std::size_t> TreeBuilder::open_bracket() const {
  for (auto frame = open_.rbegin(); frame != open_.rend(); ++frame)
    if (frame->brackets) return frame->node.span.begin;
  return std::nullopt;
}

void TreeBuilder::forget_last_key() {
  if (last_key_report_ && *last_key_report_ + 1 == diagnostics_.size()) diagnostics_.pop_back();
}

void TreeBuilder::report_bare_key(const yaml_scan::BareKey& key) {
  report("yaml_syntax", key.begin, key.end,
         fmt::format("expected {} behind `{}`", key.blank ? "a blank" : "`:`",
                     text_.substr(key.begin, key.end - key.begin)),
         "a key and its value are written `key: value`; a text goes on in a line of its own only with `|` or in "
         "quotes");
}

void TreeBuilder::refuse_long_key(const yaml_scan::BareKey& key) {
  report("input_limit", key.begin, key.end, fmt::format("a key of more than {} bytes", yaml_scan::longest_key),
         "choose a shorter name: YAML has no longer keys");
  refused_long_key_ = true;
}

void TreeBuilder::null(std::size_t at) {
  at = std::min(refuse_properties(at), text_.size());
  YamlNode node = begin(YamlNode::Kind::null, at, at);
  const bool value = !open_.empty() && open_.back().pair;
  if (const std::size_t size = null_word(text_.substr(at)); size != 0) {
    node.span = span(at, at + size);
    if (text_[at] == 'N') node.text = text_.substr(at, size); // it may be meant as a name
  } else if (value) {
    node.span = open_.back().pair->key.span;
  } else { // of a list: its dash or comma
    const std::size_t next = yaml_scan::skip_blanks(text_, cursor_);
    node.span = span(next, next + 1);
  }
  end(std::move(node));
}

void TreeBuilder::alias(std::size_t at) {
  const std::size_t last = end_of_word(text_, at + 1, " \t\r\n,]}");
  report("yaml_syntax", at, last, "aliases are not part of the language", "write the value itself");
  end(begin(YamlNode::Kind::broken, at, last));
}

void TreeBuilder::scalar(std::size_t at, const std::string& value, bool plain) {
  const std::size_t first = refuse_properties(at);
  YamlNode node = begin(YamlNode::Kind::scalar, first, first);
  node.text = value;
  const char lead = first < text_.size() ? text_[first] : '\0';
  std::size_t last = first;
  if (lead == '"' || lead == '\'') {
    node.style = lead == '"' ? YamlNode::Style::double_quoted : YamlNode::Style::single_quoted;
    last = yaml_scan::end_of_quoted(text_, first).value_or(text_.size());
  } else if (!plain && (lead == '|' || lead == '>')) {
    node.style = lead == '|' ? YamlNode::Style::literal : YamlNode::Style::folded;
    last = yaml_scan::block_scalar(text_, first, least_indentation()).end;
  } else {
    last = yaml_scan::end_of_plain(text_, first, value);
  }
  node.span = span(first, last);
  end(std::move(node));
}

void TreeBuilder::start(YamlNode::Kind kind, std::size_t at, bool flow) {
  at = refuse_properties(at);
  if (open_.size() == deepest_nesting) {
    report("input_limit", at, at + 1, fmt::format("nested deeper than {} levels", deepest_nesting),
           "the language needs ten at most: leave out what nests the others");
    throw Stop{};
  }
  // The mapping in `[a: 1]` has no braces: it ends where its value ends.
  const bool brackets = flow && at < text_.size() && (text_[at] == '[' || text_[at] == '{');
  open_.push_back({begin(kind, at, at), brackets});
  cursor_ = std::max(cursor_, brackets ? at + 1 : at);
}

void TreeBuilder::finish() {
  Frame frame = std::move(open_.back());
  open_.pop_back();
  if (frame.brackets) {
    const char bracket = frame.node.kind == YamlNode::Kind::list ? ']' : '}';
    std::size_t at = cursor_;
    while (at < text_.size() && text_[at] != bracket) {
      const std::size_t next = yaml_scan::skip_blanks(text_, at);
      at = next > at ? next : at + 1; // a comma, or the `:` and `?` of a null
    }
    cursor_ = std::min(at + 1, text_.size());
  }
  frame.node.span.end = span(cursor_, cursor_).end;
  if (frame.node.kind == YamlNode::Kind::mapping) refuse_duplicates(frame.node);
  end(std::move(frame.node));
}

/// Reports anchors and tags, and returns where the value itself begins.
std::size_t TreeBuilder::refuse_properties(std::size_t at) {
  while (at < text_.size() && (text_[at] == '&' || text_[at] == '!')) {
    const std::size_t last = end_of_word(text_, at + 1, blanks);
    if (at >= cursor_) { // a mapping and its first key may have the same mark
      if (text_[at] == '&')
        report("yaml_syntax", at, last, "anchors are not part of the language",
               "write the value wherever it is needed");
      else
        report("yaml_syntax", at, last, "tags are not part of the language", "leave it out");
      cursor_ = last;
    }
    at = yaml_scan::skip_blanks(text_, last);
  }
  return at;
}

std::size_t TreeBuilder::least_indentation() const {
  for (auto frame = open_.rbegin(); frame != open_.rend(); ++frame)
    if (!frame->brackets) return column_of(text_, frame->node.span.begin) + 1;
  return 0;
}

YamlNode TreeBuilder::begin(YamlNode::Kind kind, std::size_t first, std::size_t last) {
  if (++values_ > most_values) {
    report("input_limit", first, first + 1, fmt::format("the file has more than {} keys and values", most_values),
           "divide it into files that import one another");
    throw Stop{};
  }
  YamlNode node;
  node.kind = kind;
  node.span = span(first, last);
  return node;
}

/// Adds the complete node to its parent.
void TreeBuilder::end(YamlNode node) {
  cursor_ = std::max<std::size_t>(cursor_, node.span.end);
  if (open_.empty()) {
    root_ = std::move(node);
  } else if (Frame& frame = open_.back(); frame.node.kind == YamlNode::Kind::list) {
    frame.node.items.push_back(std::move(node));
  } else if (!frame.pair) {
    begin_pair(frame, std::move(node));
  } else {
    frame.pair->span = frame.pair->key.span;
    frame.pair->span.end = std::max(node.span.end, frame.pair->span.end);
    frame.pair->value = std::move(node);
    if (!frame.drop) frame.node.pairs.push_back(std::move(*frame.pair));
    frame.node.left_out = frame.node.left_out || frame.drop;
    frame.pair.reset();
  }
}

void TreeBuilder::begin_pair(Frame& frame, YamlNode key) {
  const Span place = key.span;
  frame.pair = YamlPair{{std::move(key.text), place}, key.style, {}, {}};
  frame.drop = true;
  const std::size_t behind = yaml_scan::skip_blanks(text_, place.end);
  if (key.kind == YamlNode::Kind::list || key.kind == YamlNode::Kind::mapping) {
    report("wrong_node_kind", place.begin, place.end,
           fmt::format("a key is a word, found a {}", key.kind == YamlNode::Kind::list ? "list" : "mapping"),
           "put a word before the `:`");
  } else if (key.kind == YamlNode::Kind::null) {
    if (const auto longer = yaml_scan::too_long_key(text_, place.begin, place.begin)) return refuse_long_key(*longer);
    const std::string& word = frame.pair->key.value;
    if (word.empty())
      report("wrong_node_kind", place.begin, place.end, "a key is a word, found nothing", "put a word before the `:`");
    else
      report("wrong_node_kind", place.begin, place.end,
             fmt::format("a key is a word, found `{}`, which YAML reads as nothing", word), "put it in quotes");
  } else if (key.kind == YamlNode::Kind::scalar) {
    if (!key.quoted() && frame.pair->key.value == "<<") {
      report("yaml_syntax", place.begin, place.end, "merge keys are not part of the language",
             "write the keys themselves");
    } else if (behind >= text_.size() || text_[behind] != ':') {
      const auto bare = key.quoted() ? std::nullopt : yaml_scan::bare_key_in(text_, place.begin, place.end);
      if (bare)
        report_bare_key(*bare);
      else
        report("yaml_syntax", place.begin, place.end, fmt::format("expected `:` behind `{}`", frame.pair->key.value),
               frame.brackets && !frame.node.pairs.empty()
                   ? "if it belongs to the text before the comma, put that text in quotes"
                   : "");
      last_key_report_ = diagnostics_.size() - 1;
    } else {
      frame.drop = false;
    }
  }
}

void TreeBuilder::refuse_duplicates(YamlNode& mapping) {
  if (mapping.pairs.size() < 2) return;
  std::unordered_map<std::string, Span> first;
  std::erase_if(mapping.pairs, [&](const YamlPair& pair) {
    const auto [earlier, is_new] = first.emplace(pair.key.value, pair.key.span);
    if (!is_new)
      report("duplicate_key", pair.key.span.begin, pair.key.span.end,
             fmt::format("the key `{}` stands here twice", pair.key.value),
             "leave one of them out, or put into one what both say", {{earlier->second, "the first one is here"}});
    return !is_new;
  });
}

} // namespace director::dsl
