// Door: dsl/plain_yaml.hpp. Test: tests/dsl/plain_yaml_test.cpp.
//
// One pass, forwards. Every function begins at the first byte of its thing, ends behind it, and returns whether that
// was ordinary; where it was not, nothing that was built counts.
#include "dsl/plain_yaml.hpp"

#include "dsl/tree_builder.hpp"

#include <algorithm>
#include <string>

namespace director::dsl {

namespace {

/// yaml-cpp takes nothing longer for a key: with a margin, for what it counts and this does not.
constexpr std::size_t longest_key = 1000;
/// In one pair of brackets, with what is in them. yaml-cpp reads so much ahead, and no more than a million.
constexpr std::size_t most_in_brackets = 100'000;

bool is_letter(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || byte == '_';
}

class PlainReader {
public:
  PlainReader(std::string_view text, TreeBuilder& builder) : text_(text), builder_(builder) {}

  bool read() {
    to_content();
    return column_ == 0 && block() && column_ == at_end;
  }

private:
  struct Scalar {
    std::string_view value;
    std::size_t end = 0; ///< behind it, quotes included
  };
  static constexpr int at_end = -1;

  char byte(std::size_t at) const { return at < text_.size() ? text_[at] : '\n'; }
  bool is_blank(std::size_t at) const { return byte(at) == ' ' || byte(at) == '\n'; }
  bool is_comment(std::size_t at) const { return byte(at) == '#' && (at == 0 || is_blank(at - 1)); }
  bool is_dash() const { return byte(at_) == '-' && is_blank(at_ + 1); }
  bool ends_key(std::size_t at) const { return byte(at) == ':' && is_blank(at + 1); }
  void skip_blanks() {
    while (byte(at_) == ' ') ++at_;
  }

  /// From the beginning of a line over blank ones and comments; `column_` is where the next content stands.
  void to_content() {
    while (at_ < text_.size()) {
      const std::size_t line = at_;
      skip_blanks();
      if (is_comment(at_)) at_ = std::min(text_.find('\n', at_), text_.size());
      if (byte(at_) != '\n') {
        column_ = static_cast<int>(at_ - line);
        line_ = line;
        return;
      }
      ++at_;
    }
    column_ = at_end;
  }

  /// From behind a value: there is nothing more in its line.
  bool to_next_line() {
    skip_blanks();
    if (is_comment(at_)) at_ = std::min(text_.find('\n', at_), text_.size());
    if (byte(at_) != '\n') return false;
    ++at_;
    to_content();
    return true;
  }

  bool block() { return is_dash() ? list(column_) : mapping(column_); }

  bool list(int column) {
    builder_.start(YamlNode::Kind::list, at_, false);
    while (column_ == column && is_dash()) {
      ++at_;
      if (!item(column)) return false;
    }
    builder_.finish();
    return column_ <= column;
  }

  /// Behind a dash.
  bool item(int column) {
    skip_blanks();
    if (const auto key = scan(false); key && ends_key(key->end)) return mapping(static_cast<int>(at_ - line_));
    return value(column, column + 1);
  }

  bool mapping(int column) {
    builder_.start(YamlNode::Kind::mapping, at_, false);
    do {
      const std::optional<Scalar> key = scan(false);
      if (!key || !ends_key(key->end)) return false;
      if (!take_key(*key) || !value(column, column)) return false;
    } while (column_ == column && !is_dash());
    builder_.finish();
    return column_ < column;
  }

  bool take_key(const Scalar& key) {
    if (key.end - at_ > longest_key) return false;
    take(key);
    ++at_; // its colon
    return true;
  }

  /// Of a key or a dash that stands at `column`: the rest of its line, or a block behind that whose dashes stand at
  /// `dashes` or farther to the right.
  bool value(int column, int dashes) {
    skip_blanks();
    if (byte(at_) == '\n' || is_comment(at_))
      return to_next_line() && (column_ > column || (column_ >= dashes && is_dash())) && block();
    if (byte(at_) == '|' || byte(at_) == '>') return text_block(column);
    if (byte(at_) == '[' || byte(at_) == '{') {
      left_ = column;
      pieces_ = 0;
      if (!brackets()) return false;
    } else {
      const std::optional<Scalar> scalar = scan(false);
      if (!scalar) return false;
      take(*scalar);
    }
    return to_next_line() && column_ <= column; // farther to the right, the text would go on
  }

  /// `|` or `>`, perhaps with a `-`. The text begins in the next line; a folded one is indented evenly.
  bool text_block(int column) {
    const std::size_t begin = at_;
    const bool folded = byte(at_++) == '>';
    const bool strip = byte(at_) == '-';
    if (strip) ++at_;
    if (byte(at_++) != '\n') return false;
    std::string value;
    std::size_t indent = 0, empty_lines = 0;
    while (at_ < text_.size()) {
      const std::size_t first = std::min(text_.find_first_not_of(' ', at_), text_.size()), blanks = first - at_;
      const std::size_t end = std::min(text_.find('\n', first), text_.size());
      const bool outside = static_cast<int>(blanks) <= column;
      if (first == end) {
        if (value.empty() || blanks > indent) return false;
        ++empty_lines;
      } else {
        if (value.empty()) indent = blanks;
        if (outside && !value.empty()) break;
        if (outside || blanks < indent || (folded && blanks > indent)) return false;
        if (folded && empty_lines == 0 && !value.empty())
          value += ' ';
        else if (!value.empty())
          value.append(folded ? empty_lines : empty_lines + 1, '\n');
        value += text_.substr(at_ + indent, end - at_ - indent);
        empty_lines = 0;
      }
      at_ = std::min(end + 1, text_.size());
    }
    if (value.empty()) return false;
    if (!strip) value += '\n';
    builder_.scalar(begin, value, false);
    to_content();
    return column_ <= column;
  }

  bool brackets() {
    const bool mapping = byte(at_) == '{';
    const char close = mapping ? '}' : ']';
    builder_.start(mapping ? YamlNode::Kind::mapping : YamlNode::Kind::list, at_, true);
    ++at_;
    if (!skip_lines()) return false;
    for (bool more = byte(at_) != close; more;) {
      if (++pieces_ > most_in_brackets || !entry(mapping) || !skip_lines()) return false;
      more = byte(at_) == ',';
      if (more) ++at_;
      if (!skip_lines()) return false;
    }
    if (byte(at_) != close) return false;
    ++at_;
    builder_.finish();
    return true;
  }

  bool entry(bool mapping) {
    if (mapping) {
      const std::optional<Scalar> key = scan(true);
      if (!key || !ends_key(key->end) || !take_key(*key)) return false;
      skip_blanks();
    }
    if (byte(at_) == '[' || byte(at_) == '{') return brackets();
    const std::optional<Scalar> scalar = scan(true);
    if (!scalar) return false;
    take(*scalar);
    return true;
  }

  /// In brackets: over blanks, comments and ends of lines, as long as they stand farther to the right than what they
  /// belong to.
  bool skip_lines() {
    skip_blanks();
    if (byte(at_) != '\n' && !is_comment(at_)) return true;
    return to_next_line() && column_ > left_;
  }

  /// Nothing where it is no ordinary word and no ordinary quote.
  std::optional<Scalar> scan(bool in_brackets) const {
    return byte(at_) == '"' || byte(at_) == '\'' ? scan_quote() : scan_word(in_brackets);
  }

  std::optional<Scalar> scan_quote() const {
    const std::string_view special = byte(at_) == '"' ? "\"\\\n" : "'\n";
    const std::size_t close = text_.find_first_of(special, at_ + 1);
    if (close == std::string_view::npos || text_[close] != text_[at_] || byte(close + 1) == text_[at_]) return {};
    return Scalar{text_.substr(at_ + 1, close - at_ - 1), close + 1};
  }

  std::optional<Scalar> scan_word(bool in_brackets) const {
    const std::string_view rest = text_.substr(at_);
    const bool begins = is_letter(byte(at_)) || (byte(at_) & 0x80) != 0 || rest.starts_with("./") ||
                        rest.starts_with("../") || (byte(at_) == '-' && is_letter(byte(at_ + 1)));
    if (!begins) return {};
    std::size_t end = at_; // behind the last byte that is not blank
    for (std::size_t at = at_; byte(at) != '\n' && !is_comment(at); ++at) {
      if (ends_key(at)) break;
      if (in_brackets) {
        if (byte(at) == ',' || byte(at) == ']' || byte(at) == '}') break;
        if (std::string_view("[{?").find(byte(at)) != std::string_view::npos) return {};
        if (byte(at) == ':' && !is_letter(byte(at + 1)) && byte(at + 1) != ':') return {};
      }
      if (byte(at) != ' ') end = at + 1;
    }
    const std::string_view value = text_.substr(at_, end - at_);
    if (value == "null" || value == "Null" || value == "NULL") return {};
    return Scalar{value, end};
  }

  void take(const Scalar& scalar) {
    const bool plain = text_[at_] != '"' && text_[at_] != '\'';
    builder_.scalar(at_, std::string(scalar.value), plain);
    at_ = scalar.end;
  }

  std::string_view text_;
  TreeBuilder& builder_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;   ///< where the line of the last block content begins
  int column_ = 0;         ///< of the next content; only where that begins a line
  int left_ = 0;           ///< where the key or dash stands that the outermost brackets belong to
  std::size_t pieces_ = 0; ///< in the outermost brackets
};

} // namespace

std::optional<YamlNode> read_plain_yaml(FileId file, std::string_view text) {
  if (text.find_first_of("\t\r") != std::string_view::npos) return std::nullopt;
  std::vector<Diagnostic> mistakes;
  TreeBuilder builder(file, text, mistakes);
  try {
    if (!PlainReader(text, builder).read() || !mistakes.empty()) return std::nullopt;
  } catch (const TreeBuilder::Stop&) { return std::nullopt; }
  return builder.take_root();
}

} // namespace director::dsl
