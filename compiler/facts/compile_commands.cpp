// Door: compiler/facts/compile_commands.hpp. Test: tests/compiler/facts/flags_test.cpp.
#include "compiler/facts/compile_commands.hpp"

#include "compiler/emit/json.hpp"
#include "dsl/load_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace director::compiler {

namespace fs = std::filesystem;

std::vector<std::string> split_command(std::string_view line) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    const bool is_blank = letter == ' ' || letter == '\t' || letter == '\n';
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
    } else {
      words.back() += letter;
    }
  }
  return words;
}

dsl::Result<std::vector<CompileCommand>, std::string> read_compile_commands(std::string_view text) {
  const std::optional<Json> json = parse_json(text);
  if (!json || !json->is_list()) return std::string("it is no JSON list");
  std::vector<CompileCommand> out;
  for (const Json& entry : json->items()) {
    CompileCommand command;
    command.directory = entry["directory"].as_text();
    const fs::path file = entry["file"].as_text();
    command.file = (file.is_absolute() ? file : fs::path(command.directory) / file).lexically_normal().string();
    command.words = split_command(entry["command"].as_text());
    for (std::string& word : entry["arguments"].as_texts()) command.words.push_back(std::move(word));
    if (file.empty() || command.directory.empty() || command.words.empty())
      return std::string("an entry needs `directory`, `file`, and `command` or `arguments`");
    out.push_back(std::move(command));
  }
  return out;
}

LoadedCommands load_compile_commands(const std::string& build, dsl::FileAccess& files) {
  LoadedCommands out;
  out.path = (fs::path(build) / "compile_commands.json").string();
  const auto text = files.read(out.path, dsl::largest_file);
  if (!text) {
    out.was_read = false;
    out.fault = fmt::format("cannot read `{}`: {}", out.path, text.error().message);
    return out;
  }
  auto commands = read_compile_commands(text.value());
  if (commands) {
    out.commands = std::move(commands.value());
  } else {
    out.fault = fmt::format("`{}` is wrong: {}", out.path, commands.error());
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
