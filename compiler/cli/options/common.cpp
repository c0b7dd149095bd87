// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/common.hpp"

#include "dsl/lexical/duration.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace director::compiler::cli {

namespace {

const std::map<std::string, Format> formats{
    {"text", Format::text}, {"json", Format::json},       {"sarif", Format::sarif}, {"dot", Format::dot},
    {"svg", Format::svg},   {"mermaid", Format::mermaid}, {"html", Format::html},   {"markdown", Format::markdown}};

} // namespace

Format format_called(const std::string& name) { return formats.at(name); }

CLI::Option* add_format(CLI::App& app, Format& format, const std::vector<std::string>& names) {
  return app
      .add_option_function<std::string>(
          "--format", [&format](const std::string& name) { format = format_called(name); },
          fmt::format("one of {}; without it {}", fmt::join(names, ", "), names.front()))
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
}

std::string format_by_ending(const std::string& file, const Endings& endings) {
  const std::string lower = CLI::detail::to_lower(file);
  for (const auto& [ending, name] : endings) {
    if (lower.ends_with(ending)) return name;
  }
  return {};
}

void add_selection(CLI::App& app, SelectionWords& words) {
  app.add_flag("--werror{*}", words.werror, "treat warnings as errors; with =ID, the warnings and lints of this check");
  app.add_flag("--lint{*}", words.lint, "report lints too; with =ID, those of this check");
  app.add_flag("--allow{*}", words.allow, "do not report what this check finds; an error is reported all the same");
}

checks::Selection selection_of(const SelectionWords& words) {
  checks::Selection out;
  for (const std::string& id : words.werror) {
    if (id == "*") {
      out.every_warning_is_error = true;
      continue;
    }
    out.warnings_as_errors.insert(id);
    const checks::Registered* check = checks::find_registered(id);
    if (check != nullptr && checks::level_of(*check) == dsl::Level::lint) out.lints.insert(id);
  }
  for (const std::string& id : words.lint) {
    if (id == "*") out.every_lint = true;
    if (id != "*") out.lints.insert(id);
  }
  out.allowed.insert(words.allow.begin(), words.allow.end());
  return out;
}

std::optional<Message> unknown_id(const SelectionWords& words) {
  std::vector<std::string> known;
  for (const checks::Registered& check : checks::registered()) known.emplace_back(check.id);
  for (const auto* list : {&words.werror, &words.lint, &words.allow}) {
    for (const std::string& id : *list) {
      const bool every = id == "*" && list != &words.allow;
      const checks::Registered* check = checks::find_registered(id);
      if (check != nullptr && list == &words.lint && checks::level_of(*check) != dsl::Level::lint)
        return Message{fmt::format("directorc: `{}` is no lint: it finds {}s, which are reported without `--lint`\n",
                                   id, dsl::name_of(checks::level_of(*check))),
                       true};
      if (every || check != nullptr) continue;
      if (id == "*")
        return Message{"directorc: --allow=ID needs the id of a check; `directorc checks` lists them\n", true};
      const std::optional<std::string> near = dsl::suggest(id, known);
      return Message{fmt::format("directorc: there is no check `{}`{}\n", id,
                                 near ? fmt::format("; did you mean `{}`?", *near) : std::string{}),
                     true};
    }
  }
  return {};
}

void add_cpp(CLI::App& app, CppSource& cpp) {
  CLI::Option* build =
      app.add_option("-p,--build", cpp.build,
                     "also check the types of the C++, with the flags in compile_commands.json of this build folder");
  build->type_name("FOLDER");
  app.add_option("--flags", cpp.flags, "the compiler and its flags, a word in each line, instead of a build folder")
      ->type_name("FILE")
      ->excludes(build);
}

void add_bound(CLI::App& app, std::size_t& bound, const std::string& without) {
  app.add_option("--bound", bound,
                        "end after N different states, a few hundred bytes each; without it " + without)
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4'000'000'000}));
}

CLI::Option* add_watch(CLI::App& app, bool& watch) {
  return app.add_flag("--watch", watch,
                      "run again whenever a file that was read changes, until Ctrl-C; without --format");
}

std::optional<Message> wrong_watch(bool watch, Format format) {
  if (!watch || format == Format::text) return {};
  return Message{"directorc: --watch prints text, run after run: leave out --format\n", true};
}

std::optional<Message> parse_time(const std::string& text, std::optional<std::int64_t>& time) {
  if (const std::optional<dsl::Duration> most = dsl::most_instead_of(text))
    return Message{fmt::format("directorc: `{}` is too long: at most {}\n", text, dsl::to_text(*most)), true};
  const std::optional<dsl::Duration> given = dsl::parse_duration(text);
  if (!given)
    return Message{fmt::format("directorc: `{}` is no time: a whole number and us, ms, s or min\n", text), true};
  time = given->microseconds();
  return {};
}

std::optional<Message> wrong_place(const std::string& option, const std::string& what, const std::string& place) {
  if (place != standard_output) return {};
  return Message{fmt::format("directorc: {} names {}, and `-` is the standard output: {} called so is `./-`\n", option,
                             what, what),
                 true};
}

void add_link(CLI::App& app, std::string& link) {
  app.add_option("--link", link, "address behind each box, arrow and place, with {file} and {line} in it")
      ->type_name("ADDRESS");
}

std::optional<Message> wrong_link(const std::string& link) {
  if (link.empty() || link.find("{file}") != std::string::npos) return {};
  return Message{"directorc: --link needs {file} in it, and {line}: --link='https://example.org/{file}#L{line}'\n",
                 true};
}

} // namespace director::compiler::cli
