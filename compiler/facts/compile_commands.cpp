// Header: compiler/facts/compile_commands.hpp. Test: tests/compiler/facts/flags_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/compile_commands.hpp"

#include "compiler/base/absolute_path.hpp"
#include "compiler/base/json.hpp"
#include "dsl/source/load_file.hpp"
#include "dsl/source/source_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>

namespace director::compiler {

namespace fs = std::filesystem;

std::vector<std::string> split_command(std::string_view line) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    const bool is_blank = letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
    if (quote == '\0' && is_blank) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (letter == quote) {
      quote = '\0';
    } else if (quote == '\0' && (letter == '"' || letter == '\'')) {
      quote = letter;
    } else if (letter == '\\' && quote != '\'' && i + 1 < line.size()) {
      const char next = line[++i];
      if (quote == '"' && next != '"' && next != '\\' && next != '$' && next != '`') words.back() += '\\';
      words.back() += next;
      // CMake writes a `$` as its build file needs it, `\$$` within quotes.
      if (quote == '"' && next == '$' && i + 1 < line.size() && line[i + 1] == '$') ++i;
    } else {
      words.back() += letter;
    }
  }
  return words;
}

namespace {

constexpr int deepest_response = 10; ///< a response file may include others, or itself
constexpr int most_responses = 2000; ///< of one command, as in g++

struct Responses {
  dsl::FileAccess& files;
  const std::string& directory;
  std::vector<std::string>& out;
  int left = most_responses;
};

void add_words(const std::vector<std::string>& words, int depth, Responses& all) {
  for (const std::string& word : words) {
    if (word.size() < 2 || word[0] != '@' || depth == deepest_response || all.left == 0) {
      all.out.push_back(word);
      continue;
    }
    const fs::path path = word.substr(1);
    const auto text = all.files.read((path.is_absolute() ? path : fs::path(all.directory) / path).string(),
                                     dsl::largest_file, dsl::Kinds::ordinary);
    if (text) {
      --all.left;
      add_words(split_command(text.value()), depth + 1, all);
    } else {
      all.out.push_back(word);
    }
  }
}

} // namespace

std::vector<std::string> with_response_files(const std::vector<std::string>& words, const std::string& directory,
                                             dsl::FileAccess& files) {
  std::vector<std::string> out;
  Responses all{files, directory, out};
  add_words(words, 0, all);
  return out;
}

dsl::Result<std::vector<CompileCommand>, CommandsFault> read_compile_commands(std::string_view text) {
  const std::optional<Json> json = parse_json(text);
  if (!json) return CommandsFault{"it is no JSON", fault_in_json(text)};
  if (!json->is_list()) return CommandsFault{"it is no JSON list", text.find_first_not_of(" \t\r\n")};
  std::vector<CompileCommand> out;
  for (const Json& entry : json->items()) {
    CompileCommand command;
    command.directory = entry["directory"].as_text();
    if (!command.directory.empty()) command.directory = absolute_path(command.directory).string();
    const fs::path file = entry["file"].as_text();
    command.file = (file.is_absolute() ? file : fs::path(command.directory) / file).lexically_normal().string();
    command.words = split_command(entry["command"].as_text());
    for (std::string& word : entry["arguments"].as_texts()) command.words.push_back(std::move(word));
    command.output = entry["output"].as_text();
    for (std::size_t i = 1; i < command.words.size() && command.output.empty(); ++i) {
      if (command.words[i - 1] == "-o") command.output = command.words[i];
    }
    if (file.empty() || command.directory.empty() || command.words.empty())
      return CommandsFault{
          fmt::format("its entry {} needs `directory`, `file`, and `command` or `arguments`", out.size() + 1)};
    out.push_back(std::move(command));
  }
  return out;
}

std::string fault_of_build(const std::string& build, const dsl::FileError& error, dsl::FileAccess& files) {
  const auto named = files.read(build, 0, dsl::Kinds::ordinary);
  if (named || named.error().kind == dsl::FileError::Kind::too_large)
    return fmt::format("`{}` is a file, and `-p` names the folder of a build", build);
  return fmt::format("cannot read `{}`: {}; CMake writes it with -D CMAKE_EXPORT_COMPILE_COMMANDS=ON",
                     (fs::path(build) / "compile_commands.json").string(), error.message);
}

LoadedCommands load_compile_commands(const std::string& build, dsl::FileAccess& files) {
  LoadedCommands out;
  out.path = (fs::path(build) / "compile_commands.json").string();
  const auto text = files.read(out.path, dsl::largest_file, dsl::Kinds::ordinary);
  if (!text) {
    out.was_read = false;
    out.fault = fault_of_build(build, text.error(), files);
    return out;
  }
  auto commands = read_compile_commands(text.value());
  if (commands) {
    out.commands = std::move(commands.value());
    for (CompileCommand& each : out.commands) each.words = with_response_files(each.words, each.directory, files);
  } else {
    const CommandsFault& fault = commands.error();
    std::string place = out.path;
    if (fault.offset) {
      const dsl::Place at = dsl::SourceFile(out.path, text.value()).place(static_cast<std::uint32_t>(*fault.offset));
      place += fmt::format(":{}:{}", at.line, at.column);
    }
    out.fault = fmt::format("`{}` is wrong: {}", place, fault.message);
  }
  return out;
}

LoadedCommands find_compile_commands(const std::string& folder, dsl::FileAccess& files) {
  for (fs::path at = folder; !at.empty(); at = at.parent_path()) {
    for (const fs::path& build : {at, at / "build"}) {
      LoadedCommands out = load_compile_commands(build.string(), files);
      if (out.was_read) return out;
    }
    if (at == at.root_path()) break;
  }
  return {{}, {}, fmt::format("no compile_commands.json can be read in `{}` or above it", folder), false};
}

} // namespace director::compiler
