// Header: dsl/yaml/yaml_tree.hpp. Test: tests/dsl/yaml/yaml_tree_test.cpp.
// SPDX-License-Identifier: MIT
//
// yaml-cpp is used for its events, not for its tree (a file of 64 MiB would cost 3.5 GB), and is not relied on: it
// accepts much that the language forbids, and drops some input. Its known faults:
//   - it never finishes the document `,` if further documents are requested;
//   - it ignores text behind the end of the first document until the next document is requested;
//   - it ends the text silently at a quote that is never closed, unless `...` follows;
//   - it accepts duplicate keys, invalid UTF-8 and null keys, and tabs often;
//   - it reads a bracket to its end, as it may be a key, at some 200 bytes a token, before the first event.
#include "dsl/yaml/yaml_tree.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/yaml/tree_builder.hpp"
#include "dsl/yaml/yaml_scan.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cstring>
#include <istream>
#include <streambuf>
#include <utility>

namespace director::dsl {

namespace {

using YAML::anchor_t;
using YAML::Mark;
using Style = YAML::EmitterStyle::value;

/// Limit for brackets, commas, quotes and the like that yaml-cpp reads before its next event: 200 MB of its tokens.
constexpr std::size_t most_pending = 1'000'000;
struct TooFarAhead {};

std::size_t offset(const Mark& mark) { return static_cast<std::size_t>(std::max(mark.pos, 0)); }

/// Gives the text to yaml-cpp and stops it if it reads too far ahead.
class Feed final : public std::streambuf {
public:
  explicit Feed(std::string_view text) : text_(std::string(text) + "\n...\n") {
    setg(text_.data(), text_.data(), text_.data() + text_.size());
  }
  /// Called at each event: what is read from here on is ahead of it.
  void understood() { pending_ = 0; }

private:
  std::streamsize xsgetn(char* to, std::streamsize size) override {
    size = std::min<std::streamsize>(size, egptr() - gptr());
    for (std::streamsize i = 0; i < size; ++i)
      if (std::strchr("[]{},?:&*!\"'", gptr()[i]) != nullptr) ++pending_;
    if (pending_ > most_pending) throw TooFarAhead{};
    std::copy_n(gptr(), size, to);
    setg(eback(), gptr() + size, egptr());
    return size;
  }

  std::string text_;
  std::size_t pending_ = 0; ///< indicators, of which each token has one
};

class Events final : public YAML::EventHandler {
public:
  Events(TreeBuilder& builder, Feed& feed) : builder_(builder), feed_(feed) {}

private:
  TreeBuilder& builder() {
    feed_.understood();
    return builder_;
  }
  void OnDocumentStart(const Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const Mark& mark, anchor_t) override { builder().null(offset(mark)); }
  void OnAlias(const Mark& mark, anchor_t) override { builder().alias(offset(mark)); }
  void OnScalar(const Mark& mark, const std::string& tag, anchor_t, const std::string& value) override {
    builder().scalar(offset(mark), value, tag == "?");
  }
  void OnSequenceStart(const Mark& mark, const std::string&, anchor_t, Style style) override {
    builder().start(YamlNode::Kind::list, offset(mark), style == YAML::EmitterStyle::Flow);
  }
  void OnSequenceEnd() override { builder().finish(); }
  void OnMapStart(const Mark& mark, const std::string&, anchor_t, Style style) override {
    builder().start(YamlNode::Kind::mapping, offset(mark), style == YAML::EmitterStyle::Flow);
  }
  void OnMapEnd() override { builder().finish(); }

  TreeBuilder& builder_;
  Feed& feed_;
};

/// Requests a second document, and stops at its first event.
class NothingMore final : public YAML::EventHandler {
public:
  struct More {
    std::size_t at;
  };

private:
  void OnDocumentStart(const Mark& mark) override { throw More{offset(mark)}; }
  void OnDocumentEnd() override {}
  void OnNull(const Mark&, anchor_t) override {}
  void OnAlias(const Mark&, anchor_t) override {}
  void OnScalar(const Mark&, const std::string&, anchor_t, const std::string&) override {}
  void OnSequenceStart(const Mark&, const std::string&, anchor_t, Style) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const Mark&, const std::string&, anchor_t, Style) override {}
  void OnMapEnd() override {}
};

/// Messages of yaml-cpp, and ours for them, with help.
struct Words {
  std::string_view theirs, message, help;
};
constexpr std::string_view indented = "is the line indented as it should be?";
constexpr std::string_view in_single_quotes = "in single quotes a backslash stands for itself";
constexpr std::string_view in_block_head =
    "behind it may stand `+`, `-`, an indentation from 1 to 9, and a comment; the text begins in the next line";
constexpr Words better_words[] = {
    {"illegal map value", "a `:` that belongs to no key",
     "is the line indented as it should be? A text with `: ` in it needs quotes"},
    {"illegal map key", "a `? ` that may not stand here", "put the text in quotes"},
    {"illegal block entry", "a `- ` that may not stand here",
     "a list begins in a line of its own, or is written [a, b]"},
    {"end of map not found", "expected another key, or the end of this mapping", indented},
    {"end of sequence not found", "expected another `- `, or the end of this list", indented},
    {"illegal flow end", "a closing bracket that nothing opened", "leave it out, or open it"},
    {"YAML major version too large", "this is YAML 1", "leave the line out"},
    {"unknown token", "no word begins with this character", "put the text in quotes"},
    {"the referenced anchor is not defined", "aliases are not part of the language", "write the value itself"},
    {"alias not found after *", "aliases are not part of the language", "a text that begins with `*` needs quotes"},
    {"anchor not found after &", "anchors are not part of the language", "a text that begins with `&` needs quotes"},
    {"cannot assign multiple anchors to the same node", "anchors are not part of the language", "leave them out"},
    {"cannot assign multiple tags to the same node", "tags are not part of the language", "leave them out"},
    {"bad character found while scanning hex number", "expected hexadecimal digits behind the backslash and its letter",
     in_single_quotes},
    {"unexpected character in block scalar", "expected the end of the line behind `|` or `>`", in_block_head},
    {"cannot set zero indentation for a block scalar", "a block text cannot be indented by 0", in_block_head},
};

bool report_tab(TreeBuilder& builder, std::string_view text, std::size_t at) {
  const auto tab = yaml_scan::tab_in_indentation(text, std::min(at, text.size()));
  if (tab) builder.report("yaml_syntax", *tab, *tab + 1, "a tab in the indentation", "indent with blanks");
  return tab.has_value();
}

/// What looks like a blank in the indentation of the line at `at`, copied from a page.
bool report_no_break_space(TreeBuilder& builder, std::string_view text, std::size_t at) {
  constexpr std::string_view no_break_space = "\xC2\xA0";
  const std::size_t begin = at - column_of(text, at);
  const std::size_t blank = std::min(text.find_first_not_of(" \t", begin), text.size());
  if (!text.substr(blank).starts_with(no_break_space)) return false;
  builder.report("yaml_syntax", blank, blank + no_break_space.size(), "a no-break space, U+00A0, in the indentation",
                 "indent with blanks");
  return true;
}

void report_exception(TreeBuilder& builder, std::string_view text, const YAML::Exception& exception) {
  const std::size_t at = std::min(offset(exception.mark), text.size());
  // The parser may report a tab, or an unclosed quote, only far behind it.
  if (report_tab(builder, text, at) || report_tab(builder, text, yaml_scan::skip_blanks(text, builder.cursor())))
    return;
  if (report_no_break_space(builder, text, at)) return;
  if (exception.msg.find("in scalar") != std::string::npos)
    if (const auto quote = yaml_scan::unclosed_quote(text, builder.cursor()))
      return builder.report("yaml_syntax", *quote, *quote + 1, "this quote is never closed",
                            fmt::format("close it with `{}`", text[*quote]));
  if (builder.refused_long_key()) return;
  if (const auto key = yaml_scan::too_long_key(text, yaml_scan::skip_blanks(text, builder.cursor()), at))
    return builder.refuse_long_key(*key);
  // A comment behind a word without a colon ends its text; the next key is then reported.
  const bool next_key = exception.msg == "end of map not found";
  if (exception.msg == "illegal map value" || next_key) {
    const auto key = yaml_scan::bare_key_above(text, at);
    if (key && (!next_key || yaml_scan::begins_line_before(text, key->begin, at))) return builder.report_bare_key(*key);
  }
  std::string message = exception.msg, help = "a text with such characters needs quotes";
  if (message.find("escape") != std::string::npos) help = in_single_quotes;
  if (message.starts_with("invalid unicode")) { // a surrogate, or above the last one
    message = "no character has the number behind this backslash";
    help = "write the character itself";
  }
  for (const Words& words : better_words)
    if (exception.msg == words.theirs) message = words.message, help = words.help;
  std::vector<Note> notes;
  const auto bracket = builder.open_bracket();
  if (!bracket && (exception.msg == "illegal flow end" || next_key))
    if (const auto key = yaml_scan::bare_key_with_bracket(text, at)) {
      builder.forget_last_key();
      return builder.report_bare_key(*key);
    }
  if (bracket && text[*bracket] == '{')
    if (const auto key = yaml_scan::bare_key_before(text, at)) {
      builder.forget_last_key();
      return builder.report_bare_key(*key);
    }
  if (bracket && exception.msg.find(" flow ") != std::string::npos) { // it does not end, or `}` stands where `]` should
    builder.forget_last_key();
    message = text[*bracket] == '[' ? "expected `,` or `]` here" : "expected `,` or `}` here";
    notes.push_back({builder.span(*bracket, *bracket + 1), "opened here"});
    help = "close what is opened there, or put the text in quotes";
  }
  builder.report("yaml_syntax", at, at + 1, std::move(message), std::move(help), std::move(notes));
}

void report_more(TreeBuilder& builder, std::string_view text, std::size_t at) {
  if (report_tab(builder, text, at)) return;
  if (text.substr(std::min(at, text.size())).starts_with("---"))
    builder.report("yaml_syntax", at, at + 3, "a second document; a file has one",
                   "leave out the `---`, or move what follows into a file of its own");
  else
    builder.report("yaml_syntax", at, at + 1, "text behind the end of the document", std::string(indented));
}

/// yaml-cpp accepts tabs as indentation in brackets and in the first line.
void refuse_tabs(TreeBuilder& builder, std::string_view text, const YamlNode& node) {
  const auto look = [&](std::size_t at) {
    std::size_t line = at; // back over blanks only: a line may be long, and have many values
    while (line > 0 && (text[line - 1] == ' ' || text[line - 1] == '\t')) --line;
    if (line < at && (line == 0 || text[line - 1] == '\n')) report_tab(builder, text, at);
  };
  if (node.kind == YamlNode::Kind::scalar) look(node.span.begin);
  for (const YamlNode& item : node.items) refuse_tabs(builder, text, item);
  for (const YamlPair& pair : node.pairs) {
    look(pair.key.span.begin);
    refuse_tabs(builder, text, pair.value);
  }
}

} // namespace

YamlNode read_yaml(FileId file, std::string_view text, std::vector<Diagnostic>& diagnostics) {
  TreeBuilder builder(file, text, diagnostics);
  const auto refuse = [&](const yaml_scan::Fault& fault) {
    const Span span{file, static_cast<std::uint32_t>(fault.begin), static_cast<std::uint32_t>(fault.end)};
    diagnostics.push_back({"yaml_syntax", Level::error, span, fault.message, {}, fault.help});
    return YamlNode{};
  };
  if (const auto fault = yaml_scan::forbidden_bytes(text)) return refuse(*fault);
  const auto others = static_cast<std::ptrdiff_t>(diagnostics.size());
  try {
    Feed feed(text);
    std::istream stream(&feed);
    YAML::Parser parser(stream);
    Events events(builder, feed);
    parser.HandleNextDocument(events);
    NothingMore nothing_more;
    parser.HandleNextDocument(nothing_more);
    YamlNode root = builder.take_root();
    if (text.find('\t') != std::string_view::npos) refuse_tabs(builder, text, root);
    return root;
  } catch (const TreeBuilder::Stop&) {
  } catch (const TooFarAhead&) {
    const std::size_t at = yaml_scan::skip_blanks(text, builder.cursor());
    builder.report("input_limit", at, at + 1,
                   fmt::format("a piece of text with more than {} brackets, commas and quotes", most_pending),
                   "write lists and mappings in lines of their own instead of in brackets");
  } catch (const NothingMore::More& more) {
    report_more(builder, text, more.at);
  } catch (const YAML::Exception& exception) { report_exception(builder, text, exception); }
  const auto fault = yaml_scan::conflict_marker(text);
  if (!fault) return {};
  diagnostics.erase(diagnostics.begin() + others, diagnostics.end()); // what they say follows from the conflict
  return refuse(*fault);
}

} // namespace director::dsl
