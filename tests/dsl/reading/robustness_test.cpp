// SPDX-License-Identifier: MIT
// No input crashes, hangs or exhausts memory: mutations of real files, and texts that are made to be hard.
#include "dsl/reading/print_spec.hpp"
#include "dsl/source/render.hpp"
#include "tests/dsl/reading/reading.hpp"
#include "tests/dsl/reading/without_places.hpp"

#include <catch2/catch.hpp>

#include <ctime>
#include <random>

using namespace director::dsl;

namespace {

constexpr const char* behaviour = R"(behaviour: soccer
language: 1
imports: [b.yaml]
cpp: {namespace: soccer, headers: [soccer/messages.hpp]}
states:
  Stability: {values: [unknown, fallen, standing], unordered: [unknown], initial: unknown, external: true}
  Charge: {range: [0, 100], expires: {after: 500 ms, to: 3}}
triggers: [Sensors]
roots:
  Striker: {priority: {normal: 10, urgent: 80}, allow: [equal_priority], because: "Both 'may'."}
groups:
  Striker:
    doc: |
      Plays when the game
      is on.
    providers:
      - name: playing
        when: [Stability == fallen|standing, 'Charge >= -1']
        packs:
          attack: {Kick: {priority: 20}, Look: {optional: true}}
          rest: {}
  Walk:
    stop: {sets: [Stability == unknown]}
    causing: [Stability == standing within 2 s]
    tasks: [LeftLeg,   # left
            RightLeg]
assertions:
  - soft: {from: Walk, to: Kick}
)";

constexpr const char* scenario = R"(scenario: a kick
behaviour: walker.yaml
given: {Arm: folded}
script:
  Walk.walking: {set: {Pose: moving}, tasks: [Legs: {data: 3}]}
  Kick:
    - {reason: subtask_done, uses: {Legs: done}, done: true}
steps:
  - request: {Kick: {level: urgent, data: [1, {x: 2.5}]}}
    expect: |
      run Walk.halting pushed

      stop Walk
  - advance: 100 ms
  - inputs: [{request: A}, {enable: A.b}]
)";

/// Meaningful texts, to be inserted anywhere.
constexpr const char* pieces[] = {"\n",          " ",  "  ",   "\t", ":",    ": ",   "- ",      "[",
                                  "]",           "{",  "}",    ",",  "\"",   "'",    "|\n",     ">-\n",
                                  "&a ",         "*a", "!t ",  "? ", "<<: ", "# ",   "---\n",   "...\n",
                                  "%YAML 1.2\n", "~",  "null", "==", "|",    "\r\n", "\xC3",    "\xEF\xBB\xBF",
                                  "ä",           "\\", "@",    "0",  "-",    "yes",  "groups:", "when: "};

class Mutations {
public:
  Mutations(std::string text, std::uint32_t seed) : text_(std::move(text)), random_(seed) {}

  std::string next() {
    std::string out = text_;
    for (std::size_t i = 0, count = 1 + below(4); i < count; ++i) mutate(out);
    return out;
  }

private:
  // Not the library's distributions: they differ between libraries.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size() + 1), size = below(std::min<std::size_t>(text.size() - at, 12) + 1);
    switch (below(6)) {
    case 0: text.erase(at, size); break;
    case 1: text.insert(at, pieces[below(std::size(pieces))]); break;
    case 2: text.insert(below(text.size() + 1), text.substr(at, below(60))); break;
    case 3: text.resize(at); break;
    case 4: text.insert(at, 1, static_cast<char>(below(256))); break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(below(256));
    }
  }

  std::string text_;
  std::mt19937 random_;
};

/// Every place must be in its text, and every finding printable.
void check_places(const std::vector<Diagnostic>& diagnostics, const Sources& sources) {
  for (const Diagnostic& d : diagnostics) {
    const std::size_t size = sources[d.span.file].text().size();
    if (d.span.begin > d.span.end || d.span.end > size || d.message.empty() || d.id.empty()) FAIL(d.message);
  }
  (void)render(diagnostics, sources);
}

/// Processor time, which does not depend on the load of a machine.
double seconds(const std::string& text) {
  const std::clock_t begin = std::clock();
  const Read read = read_text(text);
  check_places(read.result.diagnostics, read.sources);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

std::string repeated(std::string_view part, std::size_t bytes) {
  std::string out;
  while (out.size() < bytes) out += part;
  return out;
}

} // namespace

TEST_CASE("Mutations of a behaviour are read or refused, and what is read comes back") {
  Mutations mutations(behaviour, 1);
  std::size_t read_well = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = mutations.next();
    CAPTURE(i, text);
    Read read;
    read.files.add("main.yaml", text);
    read.files.add("b.yaml", "behaviour: b\nlanguage: 1\n");
    read.result = read_behaviour("main.yaml", read.files, read.sources);
    check_places(read.result.diagnostics, read.sources);
    if (has_errors(read.result.diagnostics)) continue;
    ++read_well;
    Read again;
    for (const BehaviourSpec& file : read.result.spec.files)
      again.files.add(read.sources[file.file].path(), print_file(file));
    again.result = read_behaviour("main.yaml", again.files, again.sources);
    if (!(without_places(again.result.spec) == without_places(read.result.spec))) FAIL(print_file(read.file()));
  }
  CHECK(read_well > 100);
}

TEST_CASE("Mutations of a scenario are read or refused") {
  Mutations mutations(scenario, 2);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutations.next();
    CAPTURE(i, text);
    MemoryFiles files;
    Sources sources;
    files.add("a.yaml", text);
    check_places(read_scenario("a.yaml", files, sources).diagnostics, sources);
  }
  SUCCEED();
}

TEST_CASE("Bytes without any sense are refused") {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (std::size_t j = 0, size = random() % 60; j < size; ++j)
      text += random() % 2 ? std::string(1, static_cast<char>(random() % 256)) : pieces[random() % std::size(pieces)];
    CAPTURE(i, text);
    check_places(read_text(text).result.diagnostics, read_text(text).sources);
  }
  SUCCEED();
}

TEST_CASE("Fifty kilobytes of anything cost a processor a moment") {
  constexpr std::size_t size = 50'000;
  for (const char* part :
       {"[",       "{",           "]",     "- ",    "? ",    ": ",    "a: ",  "a",     "a ",    "a\n",
        " ",       "\n",          "\t",    "\"",    "'",     "\"\" ", ",",    "[],",   "#",     "# \n",
        "|",       "- |\n a\n",   ">\n",   "&a ",   "!a ",   "*a ",   "<<: ", "---\n", "...\n", "%a\n",
        "a: 1\n",  "a: {b: 1}\n", "ä",     "\\",    "- a\n", "[a, ",  "{a: ", "\r\n",  "a:\n ", "- - - a\n",
        "\"a\": ", "~\n",         "- ~\n", "{a,b,", "a==b|", "[a,\n"}) {
    CAPTURE(part);
    CHECK(seconds(repeated(part, size)) < 20);
    CHECK(seconds("behaviour: b\nlanguage: 1\nlayers: [" + repeated(part, size)) < 20);
    CHECK(seconds("behaviour: b\nlanguage: 1\nlayers: [a" + repeated(std::string(",") + part, size) + "]") < 20);
  }
}

TEST_CASE("What the parser reads ahead is limited") {
  const std::string text = "layers: [[" + repeated("a,\n", 4'000'000) + "]]\n";
  CHECK(read_text(text).findings() ==
        "1:10 `[` input_limit: a piece of text with more than 1000000 brackets, commas and quotes (write lists and "
        "mappings in lines of their own instead of in brackets)\n");
}
