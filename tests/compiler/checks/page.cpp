// SPDX-License-Identifier: MIT
#include "tests/compiler/checks/page.hpp"

#include <algorithm>
#include <optional>

namespace director::tests {

namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// The text behind `# word: `, and whether the comment is alone on its line.
std::optional<std::pair<std::string, bool>> comment(const std::string& line, const std::string& word,
                                                    const std::string& mark = "# ") {
  const std::string begin = mark + word + ": ";
  const std::size_t at = line.find(begin);
  if (at == std::string::npos) return std::nullopt;
  return std::pair{trimmed(line.substr(at + begin.size())), trimmed(line.substr(0, at)).empty()};
}

/// Removes the id of another check from the end of a message.
std::string split_id(std::string& message, const std::string& own) {
  const std::size_t at = message.rfind(" [");
  if (at == std::string::npos || message.back() != ']') return own;
  const std::string id = message.substr(at + 2, message.size() - at - 3);
  if (id.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") != std::string::npos) return own;
  message.erase(at);
  return id;
}

class SpecimenReader {
public:
  SpecimenReader(const std::string& id, std::uint32_t line, const std::vector<std::string>& lines) : id_(id) {
    specimen_.line = line;
    const auto first_end = std::find_if(lines.begin(), lines.end(),
                                        [](const std::string& text) { return comment(text, "file").has_value(); });
    const bool is_whole = std::any_of(lines.begin(), first_end, [](const std::string& text) {
      return text.rfind("behaviour:", 0) == 0 || text.rfind("language:", 0) == 0;
    });
    if (!is_whole) add("behaviour: example\nlanguage: 1\n", 2);
    for (const std::string& text : lines) read(text);
    end_file();
  }
  /// The C++ of a specimen.
  SpecimenReader(const std::string& id, Specimen specimen, const std::vector<std::string>& lines)
      : id_(id),
        specimen_(std::move(specimen)),
        file_("modules.cpp"),
        mark_("// ") {
    specimen_.has_code = true;
    for (const std::string& text : lines) read(text);
    end_file();
  }
  Specimen take() { return std::move(specimen_); }

private:
  void add(const std::string& text, std::uint32_t lines) {
    text_ += text;
    line_ += lines;
  }

  void end_file() {
    if (!text_.empty() || mark_ == "# ") specimen_.files[file_] = std::exchange(text_, {});
  }

  void read(const std::string& line) {
    if (const auto name = comment(line, "file", mark_)) {
      end_file();
      file_ = name->first;
      line_ = 0;
      return;
    }
    add(line + "\n", 1);
    const auto here = comment(line, "reported", mark_), above = comment(line, "reported above", mark_);
    const auto note = comment(line, "note", mark_), note_above = comment(line, "note above", mark_);
    const auto help = comment(line, "help", mark_);
    const bool alone = (above && above->second) || (note_above && note_above->second) || (help && help->second);
    if (!alone) last_ = line_;
    if (here) expect_finding(here->first, line_);
    if (above) expect_finding(above->first, last_);
    if (note) specimen_.notes.push_back({file_, line_, {}, note->first});
    if (note_above) specimen_.notes.push_back({file_, last_, {}, note_above->first});
    if (help) specimen_.helps.push_back(help->first);
  }

  void expect_finding(std::string message, std::uint32_t line) {
    const std::string id = split_id(message, id_);
    specimen_.findings.push_back({file_, line, id, message});
  }

  std::string id_;
  Specimen specimen_;
  std::string file_{main_file};
  std::string mark_ = "# ";
  std::string text_;
  std::uint32_t line_ = 0; ///< the last one that was read
  std::uint32_t last_ = 0; ///< the last one that is not a comment about the line above
};

} // namespace

Page read_page(std::string_view text) {
  Page page;
  std::vector<Specimen>* section = nullptr;
  std::optional<std::vector<std::string>> block;
  bool code = false;
  std::uint32_t number = 0, begin = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    if (block && line == "```") {
      if (section != nullptr && !code) section->push_back(SpecimenReader(page.title, begin, *block).take());
      if (section != nullptr && code && !section->empty())
        section->back() = SpecimenReader(page.title, std::move(section->back()), *block).take();
      block.reset();
    } else if (block) {
      block->push_back(line);
    } else if (line == "```yaml" || line == "```cpp") {
      block.emplace();
      code = line == "```cpp";
      begin = number;
    } else if (line.rfind("## ", 0) == 0) {
      section = line == "## Reported" ? &page.reported : line == "## Accepted" ? &page.accepted : nullptr;
    } else if (line.rfind("# ", 0) == 0 && page.title.empty()) {
      page.title = line.substr(2);
    }
  }
  return page;
}

} // namespace director::tests
