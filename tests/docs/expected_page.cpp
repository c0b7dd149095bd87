// Header: tests/docs/expected_page.hpp. Test: tests/docs/expected_page_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/docs/expected_page.hpp"

#include "tests/docs/comment.hpp"
#include "tests/docs/shortened.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <algorithm>
#include <fstream>

namespace director::tests {

namespace {

Lines without_common_indent(Lines lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines) indent = std::min(indent, line.find_first_not_of(' '));
  for (std::string& line : lines) line = line.substr(std::min(indent, line.size()));
  return lines;
}

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

class BlockTexts {
public:
  BlockTexts(const std::string& path, std::vector<std::string>& faults) : path_(path), faults_(faults) {}

  /// `block` as it should be; `checked` is the one before, if `findings` are those of it.
  Lines expected_block(const Block& block, const Block* checked, bool has_findings) {
    block_ = &block;
    comment_ = read_comment(block.comment);
    const std::string& word = comment_.word;
    if (word == "file") return shortened(from_file(), block.lines);
    if (word == "run") return shortened(run(comment_.argument), block.lines);
    if (word == "session") return session();
    if (word == "output") return shortened(script(), block.lines);
    if (word == "check") return has_findings ? block.lines : clean();
    if (word == "findings")
      return checked != nullptr ? findings(*checked) : fault("there is no block before that is checked");
    if (word == "not run") return comment_.argument.empty() ? fault("say why it is not run") : block.lines;
    return fault(word.empty() ? "no comment says where this block comes from"
                              : "nobody knows the comment `" + word + "`");
  }

private:
  Lines fault(const std::string& what) {
    faults_.push_back(path_ + ":" + std::to_string(block_->line + 1) + ": " + what);
    return block_->lines;
  }

  Lines from_file() {
    if (!std::filesystem::is_regular_file(source_dir() / comment_.argument))
      return fault("there is no file " + comment_.argument);
    const Lines all = lines_of(read_file(source_dir() / comment_.argument));
    const auto find = [&](const std::string& option, auto from) {
      const std::string& wanted = comment_.options[option];
      const auto found = std::find_if(from, all.end(),
                                      [&](const std::string& line) { return line.find(wanted) != std::string::npos; });
      if (found == all.end()) fault("no line of " + comment_.argument + " holds " + wanted);
      return found;
    };
    auto first = all.begin(), after = all.begin();
    if (comment_.options.contains("from")) first = find("from", all.begin());
    if (first != all.end()) after = comment_.options.contains("from") ? first + 1 : first;
    auto last = all.end();
    if (comment_.options.contains("to")) last = find("to", after);
    if (last != all.end()) ++last;
    if (comment_.options.contains("before")) last = find("before", after);
    while (first != last && first->empty()) ++first;
    while (first != last && (last - 1)->empty()) --last;
    return without_common_indent({first, last});
  }

  Lines run(const std::string& command) {
    const std::filesystem::path folder = source_dir() / comment_.options["in"];
    if (!std::filesystem::is_directory(folder)) {
      fault("there is no folder " + comment_.options["in"]);
      return {};
    }
    const Ran ran = run_command(command, folder);
    const std::string expected = comment_.options.contains("exit") ? comment_.options["exit"] : "0";
    if (std::to_string(ran.status) != expected)
      fault(command + " ends with " + std::to_string(ran.status) + ":\n" + ran.output);
    return lines_of(ran.output);
  }

  Lines session() {
    Lines lines;
    for (const std::string& line : block_->lines) {
      if (!line.starts_with("$ ")) continue;
      lines.push_back(line);
      const Lines printed = run(line.substr(2));
      lines.insert(lines.end(), printed.begin(), printed.end());
    }
    return lines.empty() ? fault("there is no command, a line that begins with $") : shortened(lines, block_->lines);
  }

  /// A script at the root prints its actions in lines `step '...'`; the output between them comes from programs.
  Lines script() {
    static const std::map<std::string, std::map<std::string, std::string>> programs{
        {"./start",
         {{"Checking behaviours/soccer/soccer.yaml", "directorc check behaviours/soccer/soccer.yaml"},
          {"Playing", "soccer"}}}};
    const auto steps = programs.find(comment_.argument);
    if (steps == programs.end()) return fault("nobody knows what " + comment_.argument + " prints");
    Lines lines;
    std::size_t met = 0;
    for (const std::string& line : lines_of(read_file(source_dir() / comment_.argument))) {
      if (!line.starts_with("step '")) continue;
      const std::string name = line.substr(6, line.size() - 7);
      lines.push_back("== " + name);
      const auto program = steps->second.find(name);
      if (program == steps->second.end()) continue;
      ++met;
      const Lines printed = run(program->second);
      lines.insert(lines.end(), printed.begin(), printed.end());
    }
    return met == steps->second.size() ? lines : fault(comment_.argument + " has other steps now");
  }

  Ran check(const Block& block, const Comment& comment) {
    const TemporaryFolder folder;
    std::string text = text_of(block.lines);
    if (!text.starts_with("behaviour:") && text.find("\nbehaviour:") == std::string::npos) {
      const std::string imports = comment.rest.empty() ? "" : "imports: [beside.yaml]\n";
      text = "behaviour: example\nlanguage: 1\n" + imports + text;
    }
    if (!comment.rest.empty())
      write(folder.path() / "beside.yaml", "behaviour: beside\nlanguage: 1\n" + comment.rest + "\n");
    write(folder.path() / "example.yaml", text);
    return run_command("directorc check example.yaml", folder.path());
  }

  Lines clean() {
    const Ran ran = check(*block_, comment_);
    return ran.status == 0 && ran.output.empty() ? block_->lines : fault("this is not clean:\n" + ran.output);
  }

  Lines findings(const Block& checked) {
    const Lines lines = lines_of(check(checked, read_comment(checked.comment)).output);
    return lines.empty() ? fault("nothing is found in the block before") : shortened(lines, block_->lines);
  }

  const std::string& path_;
  std::vector<std::string>& faults_;
  const Block* block_ = nullptr;
  Comment comment_;
};

} // namespace

ExpectedPage expected_page(const std::string& path, const Markdown& page) {
  ExpectedPage result;
  BlockTexts texts(path, result.faults);
  std::vector<Lines> blocks;
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const auto is = [&](std::size_t at, const char* word) {
      return at < page.blocks.size() && read_comment(page.blocks[at].comment).word == word;
    };
    const Block* before = i > 0 && is(i - 1, "check") ? &page.blocks[i - 1] : nullptr;
    blocks.push_back(texts.expected_block(page.blocks[i], before, is(i + 1, "findings")));
  }
  result.text = with_blocks(page, blocks);
  return result;
}

} // namespace director::tests
