// SPDX-License-Identifier: MIT
#include "tests/compiler/clang/workshop.hpp"

#include "compiler/base/json.hpp"
#include "compiler/cli/options/parse.hpp"
#include "tests/support/golden.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace director::tests {

namespace fs = std::filesystem;

std::string source_folder() { return source_dir().string(); }

Workshop::Workshop(const std::string& name) : folder_((binary_dir() / "tests/clang-work" / name).string()) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

std::string Workshop::path(const std::string& file) const { return (fs::path(folder_) / file).string(); }

void Workshop::write(const std::string& file, const std::string& text) const {
  fs::create_directories(fs::path(path(file)).parent_path());
  std::ofstream(path(file), std::ios::binary) << text;
}

void Workshop::write_commands(const std::vector<std::string>& files, const std::vector<std::string>& flags) const {
  using compiler::Json;
  Json commands = Json::list({});
  for (const std::string& file : files) {
    Json words = Json::list({Json::text("g++")});
    for (const std::string& flag : flags) words.add(Json::text(flag));
    for (const char* word : {"-c", "-o", "x.o"}) words.add(Json::text(word));
    words.add(Json::text(file));
    commands.add(Json::object(
        {{"directory", Json::text(folder_)}, {"file", Json::text(file)}, {"arguments", std::move(words)}}));
  }
  write("compile_commands.json", to_lines(commands));
}

Worked Workshop::directorc(const std::vector<std::string>& words) const {
  dsl::DiskFiles files;
  compiler::cli::DiskOutputs outputs;
  compiler::cli::ChildPrograms programs;
  std::ostringstream out, err;
  compiler::cli::Console console{out,   err,     false,    false,
                                 files, outputs, programs, (binary_dir() / "bin/director-clang").string()};
  const compiler::cli::Request request = compiler::cli::parse(words);
  Worked worked;
  worked.status = std::visit([&](const auto& command) { return run(command, console); }, request);
  worked.out = out.str();
  worked.err = err.str();
  return worked;
}

} // namespace director::tests
