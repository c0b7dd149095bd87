// Header: tests/defects/flow.hpp. Test: tests/defects/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/flow.hpp"

#include <stdexcept>

namespace director::defects {

namespace {

class Parser {
public:
  explicit Parser(std::string_view text) : text_(text) {}

  Node whole() {
    Node out = value();
    skip();
    if (at_ != text_.size()) wrong();
    return out;
  }

private:
  [[noreturn]] void wrong() const {
    throw std::logic_error("not in flow style at " + std::to_string(at_) + ": " + std::string(text_));
  }
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string until(std::string_view ends) {
    skip();
    const std::size_t end = std::min(text_.find_first_of(ends, at_), text_.size());
    std::string out(text_.substr(at_, end - at_));
    at_ = end;
    while (!out.empty() && (out.back() == ' ' || out.back() == '\n')) out.pop_back();
    if (out.empty()) wrong();
    return out;
  }

  Node value() {
    if (take('{')) return mapping();
    if (take('[')) return list();
    return until(",]}");
  }
  Node mapping() {
    Node out;
    while (!take('}')) {
      std::string key = until(":,]}");
      if (!take(':')) wrong();
      out.add(std::move(key), value());
      if (!take(',') && (at_ == text_.size() || text_[at_] != '}')) wrong();
    }
    return out;
  }
  Node list() {
    Node out = Node::list();
    while (!take(']')) {
      out.add(value());
      if (!take(',') && (at_ == text_.size() || text_[at_] != ']')) wrong();
    }
    return out;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

} // namespace

std::string fill(std::string_view text, const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '$') {
      out += words.at(static_cast<std::size_t>(text[++i] - '0'));
    } else {
      out += text[i];
    }
  }
  return out;
}

Node flow(std::string_view text, const std::vector<std::string>& words) { return Parser(fill(text, words)).whole(); }

} // namespace director::defects
