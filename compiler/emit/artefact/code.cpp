// Header: compiler/emit/artefact/code.hpp. Test: tests/compiler/emit/artefact/code_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/code.hpp"

#include <algorithm>
#include <utility>

namespace director::compiler {

namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Whether a blank line after it would be superfluous; not after the beginning of a namespace.
bool is_opening(std::string_view text) { return text.ends_with('{') && !text.starts_with("namespace"); }

} // namespace

/// The UTF-8 of marks that change the direction of text begins with E2 80 AA..AE or E2 81 A6..A9.
std::string as_comment(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
    const bool turns = byte(i) == 0xE2 && ((byte(i + 1) == 0x80 && byte(i + 2) >= 0xAA && byte(i + 2) <= 0xAE) ||
                                           (byte(i + 1) == 0x81 && byte(i + 2) >= 0xA6 && byte(i + 2) <= 0xA9));
    if (turns) {
      i += 2;
    } else if (text[i] == '\n') {
      out += '\n';
    } else {
      out += byte(i) < 0x20 || byte(i) == 0x7F ? ' ' : text[i];
    }
  }
  return out;
}

void Code::line(std::string_view text) {
  const bool outside = text.empty() || text.starts_with('#'); // a preprocessor directive is in no block
  lines_.push_back({outside ? 0 : indent_, std::string(text), {}});
}

void Code::line(std::string_view text, const dsl::Span& from) { lines_.push_back({indent_, std::string(text), from}); }

void Code::blank() {
  if (lines_.empty() || lines_.back().text.empty() || is_opening(lines_.back().text)) return;
  lines_.push_back({});
}

void Code::open(std::string_view text) {
  line(text);
  ++indent_;
}

void Code::open(std::string_view text, const dsl::Span& from) {
  line(text, from);
  ++indent_;
}

void Code::close(std::string_view text) {
  --indent_;
  line(text);
}

void Code::outdented(std::string_view text) {
  --indent_;
  line(text);
  ++indent_;
}

void Code::comment(std::string_view text, std::string_view mark) {
  const std::string clean = as_comment(text);
  for (const std::string_view paragraph : split(clean, '\n')) {
    std::string current{mark};
    const auto finish = [&] {
      if (current.ends_with('\\')) current += '.'; // else it would join the line with the next
      line(current);
      current = mark;
    };
    for (const std::string_view word : split(paragraph, ' ')) {
      if (word.empty()) continue;
      if (current.size() > mark.size() && current.size() + 1 + word.size() > room()) finish();
      current += ' ';
      current += word;
    }
    finish();
  }
}

void Code::list(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
                const std::optional<dsl::Span>& from) {
  const std::size_t first = lines_.size();
  std::string all{head};
  for (const std::string& item : items) {
    if (&item != &items.front()) all += ", ";
    all += item;
  }
  all += tail;
  if (all.size() <= room()) {
    line(all);
  } else {
    line(head.substr(0, head.find_last_not_of(' ') + 1));
    indent_ += 2;
    list_below(items, tail);
    indent_ -= 2;
  }
  lines_[first].from = from;
}

/// Puts as many items on a line as fit.
void Code::list_below(const std::vector<std::string>& items, std::string_view tail) {
  std::string current;
  for (const std::string& item : items) {
    const bool last = &item == &items.back();
    const std::size_t size = item.size() + (last ? tail.size() : 1);
    if (!current.empty() && current.size() + 1 + size > room()) {
      line(current);
      current.clear();
    }
    if (!current.empty()) current += ' ';
    current += item;
    if (!last) current += ',';
  }
  current += tail;
  line(current);
}

void Code::open_list(std::string_view head, const std::vector<std::string>& items, std::string_view tail) {
  list(head, items, tail);
  ++indent_;
}

void Code::block(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  for (std::string_view each : split(text, '\n')) {
    const std::size_t blanks = std::min(each.find_first_not_of(' '), each.size());
    each.remove_prefix(blanks);
    line(each);
    if (!each.empty() && !each.starts_with('#')) lines_.back().indent += static_cast<std::uint32_t>(blanks / 2);
  }
}

void Code::append(const Code& other) {
  for (Line added : other.lines_) {
    if (!added.text.empty()) added.indent += indent_;
    lines_.push_back(std::move(added));
  }
}

std::string Code::text() const {
  std::string out;
  for (const Line& each : lines_) {
    out.append(2 * std::size_t{each.indent}, ' ');
    out += each.text;
    out += '\n';
  }
  return out;
}

} // namespace director::compiler
