// SPDX-License-Identifier: MIT
#include "compiler/base/json.hpp"
#include "compiler/checks/check.hpp"
#include "tests/compiler/checks/page.hpp"
#include "tests/compiler/clang/workshop.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace director;
using namespace director::tests;
using compiler::Json;

std::string lines(std::vector<Expected> list) {
  std::sort(list.begin(), list.end());
  std::string out;
  for (const Expected& one : list)
    out += one.file + ":" + std::to_string(one.line) + ": " + one.message +
           (one.id.empty() ? "" : " [" + one.id + "]") + "\n";
  return out;
}

std::string lines(std::vector<std::string> list) {
  std::sort(list.begin(), list.end());
  std::string out;
  for (const std::string& one : list) out += one + "\n";
  return out;
}

struct Said {
  std::vector<Expected> findings, notes;
  std::vector<std::string> helps;
  std::string levels;
};

Expected place(const Workshop& work, const Json& at, std::string id) {
  std::string file = std::filesystem::path(at["file"].as_text()).lexically_relative(work.path()).string();
  if (file.empty() || file.starts_with(".."))
    file = std::filesystem::absolute(at["file"].as_text()).lexically_relative(work.path()).string();
  return {file, static_cast<std::uint32_t>(at["line"].as_number()), std::move(id), at["message"].as_text()};
}

Said words_of(const Workshop& work, const std::string& text) {
  Said out;
  const std::optional<Json> json = compiler::parse_json(text);
  REQUIRE(json);
  for (const Json& finding : (*json)["findings"].items()) {
    out.findings.push_back(place(work, finding, finding["id"].as_text()));
    for (const Json& note : finding["notes"].items()) out.notes.push_back(place(work, note, {}));
    if (!finding["help"].is_null()) out.helps.push_back(finding["help"].as_text());
  }
  return out;
}

/// The findings of `check` with the program's flags; if there are none, those of `verify` about its C++.
Said try_out(const Specimen& specimen, const std::string& name) {
  const Workshop work(name);
  std::vector<std::string> files;
  for (const auto& [path, text] : specimen.files) {
    work.write(path, text);
    if (path.ends_with(".cpp")) files.push_back(work.path(path));
  }
  const bool has_bodies = !files.empty();
  if (!has_bodies) files.push_back(work.path("modules.cpp"));
  work.write_commands(files, {"-std=c++20", "-Wall", "-fno-var-tracking", "-I" + source_folder(),
                              "-I" + work.path("generated"), "-I" + work.path()});
  const std::string behaviour = work.path("example.yaml");
  const Worked checked = work.directorc({"check", behaviour, "-p", work.path(), "--format=json"});
  INFO(checked.err);
  Said said = words_of(work, checked.out);
  if (checked.status != 0 || !has_bodies) return said;
  if (specimen.files.count("generated/example.hpp") == 0) {
    const Worked generated = work.directorc({"generate", behaviour, "-o", work.path("generated")});
    INFO(generated.err);
    CHECK(generated.status == 0);
  }
  const Worked verified = work.directorc({"verify", behaviour, "-p", work.path(), "--format=json"});
  INFO(verified.err);
  Said more = words_of(work, verified.out.empty() ? "{}" : verified.out);
  CHECK(verified.err == "");
  said.findings.insert(said.findings.end(), more.findings.begin(), more.findings.end());
  said.notes.insert(said.notes.end(), more.notes.begin(), more.notes.end());
  said.helps.insert(said.helps.end(), more.helps.begin(), more.helps.end());
  return said;
}

TEST_CASE("the findings of every page with C++ are those on the page") {
  for (const checks::Registered& check : checks::registered()) {
    const Page page = read_page(check.page);
    std::size_t number = 0;
    for (const auto* section : {&page.reported, &page.accepted}) {
      for (const Specimen& specimen : *section) {
        if (!specimen.has_code) continue;
        DYNAMIC_SECTION(check.id << " " << ++number) {
          INFO(check.id << ".md:" << specimen.line);
          const Said said = try_out(specimen, std::string(check.id) + std::to_string(number));
          CHECK(lines(said.findings) == lines(specimen.findings));
          if (!specimen.notes.empty()) CHECK(lines(said.notes) == lines(specimen.notes));
          if (!specimen.helps.empty()) CHECK(lines(said.helps) == lines(specimen.helps));
          CHECK(said.helps.size() == said.findings.size());
          if (section == &page.accepted) CHECK(specimen.findings.empty());
        }
      }
    }
  }
}

} // namespace
