// Tests dsl/plain_yaml.hpp: against yaml-cpp, which reads the same texts.
#include "dsl/plain_yaml.hpp"
#include "dsl/yaml_scan.hpp"
#include "dsl/yaml_tree.hpp"
#include "tests/dsl/mutations.hpp"
#include "tests/dsl/yaml_shape.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace director::dsl;

namespace {

/// Whether it was read; what was must be what yaml-cpp reads.
bool is_read(const std::string& text) {
  const std::optional<YamlNode> plain = read_plain_yaml({}, text);
  if (!plain) return false;
  std::vector<Diagnostic> mistakes;
  const YamlNode any = read_any_yaml({}, text, mistakes);
  CHECK(mistakes.empty());
  CHECK(shape_of(*plain) == shape_of(any));
  return true;
}

} // namespace

TEST_CASE("Ordinary YAML is read as yaml-cpp reads it") {
  for (const char* text : {
           "a: 1\n",
           "a: 1",
           "\n# c\na: 1 # d\n\n  # e\nb: 2\n#f",
           "a:\n  b: c\n  d:\n    e: f\ng: h\n",
           "a:\n- x\n- y\nb: z\n",
           "a:\n  - x\n  - y: 1\n    z: 2\n  -\n    u: 3\n  -\n    - v\nb: z\n",
           "- a\n- b: c\n  d: e\n-   f: g\n    h: [i]\n",
           "a: [x, y z , 'u', \"v, w\"]\nb: {c: [d, {e: f}], g: {}, h: []}\n",
           "a: [x, # one\n    y,\n\n    # two\n    z\n   ]\nb: c\n",
           "a: Goes on, [sic] {so} it's & * ! | > ? - % @ ` done: no\n",
           "a: |\n  b\n   c\n\n\n  d \n\ne: |-\n    f: [\n# c\ng: >\n h i\n j\n\n k\nl:\n  - >-\n    m\n  - n\n",
           "when: [Phase == ready|set, Charge >= -1, soccer::Phase != x]\n",
           "'a b': x\n\"c\": y\nd: -1\ne: ./f.yaml\ng: a:b\nh: a#b\ni: \xc3\xa4 \xe2\x82\xac\n",
       }) {
    CAPTURE(text);
    CHECK(is_read(text) == (std::string_view(text).find("done: no") == std::string_view::npos));
  }
}

TEST_CASE("What is out of the ordinary, or wrong, is left to yaml-cpp") {
  for (const char* text : {"",
                           "a",
                           "[a]\n",
                           "- - a\n",
                           "a: |+\n  b\n",
                           "a: >2\n   b\n",
                           "a: b\n  c\n",
                           "a: |\n\n  b\n",
                           "a: |\nb: c\n",
                           "a:\n  b: |\n    c\n   d\n",
                           "a: >\n  b\n   c\n",
                           "a: &x b\n",
                           "a: *x\n",
                           "a: !t b\n",
                           "a: 'b''c'\n",
                           "a: \"\\n\"\n",
                           "a: 'b\n  c'\n",
                           "a: ~\n",
                           "a:\n",
                           "a: null\n",
                           "- \n- a\n",
                           "a: [b, ]\n",
                           "a: [b: c]\n",
                           "a: {b}\n",
                           "a: {b: }\n",
                           "a: [,]\n",
                           "a:\tb\n",
                           "a: b\r\n",
                           "? a\n: b\n",
                           "a : b\n",
                           " a: b\n",
                           "a: b\n b: c\n",
                           "a: b: c\n",
                           "a: [b\nc]\n",
                           "a: [b] c\n",
                           "a: 'b' c\n",
                           "a: [b}\n",
                           "a: {b: c]\n",
                           "a: [b\n",
                           "a: 'b\n",
                           "---\na: b\n",
                           "a: b\n...\n",
                           "a: 1\na: 2\n",
                           "<<: {a: b}\n",
                           "a: {b:c}\n",
                           "a: [b?]\n",
                           "a:\n  b: 1\n c: 2\n",
                           "a:\n  - b\n  c: d\n"}) {
    CAPTURE(text);
    CHECK_FALSE(is_read(text));
  }
  CHECK_FALSE(is_read(std::string(2000, 'k') + ": a\n"));
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "[";
  CHECK_FALSE(is_read("a: " + deep + "\n"));
}

TEST_CASE("The behaviours of this repository are ordinary, and read as yaml-cpp reads them") {
  std::size_t count = 0;
  for (const char* folder : {"behaviours", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(director::tests::source_dir() / folder)) {
      if (entry.path().extension() != ".yaml") continue;
      CAPTURE(entry.path().string());
      const std::string text = director::tests::read_file(entry.path());
      if (yaml_scan::forbidden_bytes(text)) continue;
      const bool read = is_read(text);
      const bool ordinary =
          folder == std::string_view("behaviours") && entry.path().string().find(".scenario.") == std::string::npos;
      if (ordinary) CHECK(read);
      count += ordinary;
    }
  }
  CHECK(count > 10);
}

TEST_CASE("Whatever is changed in an ordinary text, what is still read is what yaml-cpp reads") {
  Mutations mutations(R"(behaviour: soccer
language: 1
imports: [b.yaml] # more
states:
  Stability: {values: [unknown, 'fallen', standing], unordered: [unknown], initial: unknown}
groups:
  Striker:
    doc: Plays, and "kicks" [sometimes].
    because: |
      It is asked
        for.

      Now.
    providers:
      - name: playing
        when: [Stability == fallen|standing, "Charge >= -1"]
        packs:
          attack: {Kick: {priority: 20},
                   Look: {optional: true}}
          rest: {}
      - {name: idle}
    tasks:
    - Left
    -  Right: {priority: -1}
       Third: x y
assertions:
  - soft: {from: Walk, to: Kick}
)",
                      4);
  std::size_t read = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = mutations.next();
    CAPTURE(i, text);
    if (!yaml_scan::forbidden_bytes(text)) read += is_read(text);
  }
  CHECK(read > 2'000);
}
