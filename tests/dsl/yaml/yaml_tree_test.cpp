// SPDX-License-Identifier: MIT
// Tests dsl/yaml/yaml_tree.hpp, dsl/yaml/tree_builder.hpp.
#include "dsl/yaml/tree_builder.hpp"
#include "dsl/yaml/yaml_tree.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace director::dsl;

namespace {

struct Tree {
  Sources sources;
  YamlNode root;
  std::vector<Diagnostic> diagnostics;

  explicit Tree(std::string text) {
    const FileId file = sources.add("a.yaml", std::move(text));
    root = read_yaml(file, sources[file].text(), diagnostics);
  }
  std::string findings() {
    sort_by_place(diagnostics);
    return findings_text(diagnostics, sources);
  }
  std::string place(const Span& span) const { return fmt::format("{}-{}", span.begin, span.end); }
  /// `{a 0-1: 3-4 'text'}`: kinds, places and texts.
  std::string shape(const YamlNode& node) const {
    std::string out = place(node.span);
    switch (node.kind) {
    case YamlNode::Kind::broken: return out + " broken";
    case YamlNode::Kind::null: return out + " null";
    case YamlNode::Kind::scalar: return out + (node.quoted() ? " \"" + node.text + "\"" : " " + node.text);
    case YamlNode::Kind::list:
      out += " [";
      for (const YamlNode& item : node.items) out += (out.back() == '[' ? "" : ", ") + shape(item);
      return out + "]";
    case YamlNode::Kind::mapping:
      out += " {";
      for (const YamlPair& pair : node.pairs)
        out += (out.back() == '{' ? "" : ", ") + pair.key.value + " " + place(pair.key.span) + ": " + shape(pair.value);
      return out + "}";
    }
    return out;
  }
};

} // namespace

TEST_CASE("Keys and values know where they begin and end") {
  struct Row {
    const char* text;
    const char* shape;
  };
  for (const Row& row : {
           Row{"a: 1\n", "0-4 {a 0-1: 3-4 1}"},
           Row{"a: [x, \"y z\"] # c\n", "0-13 {a 0-1: 3-13 [4-5 x, 7-12 \"y z\"]}"},
           Row{"a: [ x , # ]\n 'y' ]\n", "0-19 {a 0-1: 3-19 [5-6 x, 14-17 \"y\"]}"},
           Row{"a: {b: c, d: {}}\n", "0-16 {a 0-1: 3-16 {b 4-5: 7-8 c, d 10-11: 13-15 {}}}"},
           Row{"a:\n  b: 1\n  c:\n  - x\n  - y\n\n# c\nd: 2",
               "0-36 {a 0-1: 5-26 {b 5-6: 8-9 1, c 12-13: 17-26 [19-20 x, 25-26 "
               "y]}, d 32-33: 35-36 2}"},
           Row{"[a: 1, b]", "0-9 [1-5 {a 1-2: 4-5 1}, 7-8 b]"},
           Row{"a: one\n  two # c\nb: 3", "0-21 {a 0-1: 3-12 one two, b 17-18: 20-21 3}"},
           Row{"a: 'it''s'", "0-10 {a 0-1: 3-10 \"it's\"}"},
           Row{"a: \"x\\\"y\\n\" \n", "0-11 {a 0-1: 3-11 \"x\"y\n\"}"},
           Row{"\"a b\" : 1", "0-9 {a b 0-5: 8-9 1}"},
           Row{"a: |\n  x\n\n  y\n\nb: 1", "0-19 {a 0-1: 3-13 \"x\n\ny\n\", b 15-16: 18-19 1}"},
           Row{"a: |2-\n    x\n  y\nb: >+\n z\n\n", "0-25 {a 0-1: 3-16 \"  x\ny\", b 17-18: 20-25 \"z\n\n\"}"},
           Row{"a: |\nb: 1", "0-9 {a 0-1: 3-4 \"\", b 5-6: 8-9 1}"},
           Row{"- |\n x\n- y", "0-10 [2-6 \"x\n\", 9-10 y]"},
           Row{"a: 1\r\nb: |\r\n  x\r\nc: 2\r\n", "0-21 {a 0-1: 3-4 1, b 6-7: 9-15 \"x\n\", c 17-18: 20-21 2}"},
           Row{"---\na: 1\n...\n", "4-8 {a 4-5: 7-8 1}"},
           Row{"%YAML 1.2\n---\na: 1\n", "14-18 {a 14-15: 17-18 1}"},
           Row{"ä: ö", "0-6 {ä 0-2: 4-6 ö}"},
           Row{"[[],{},[ ] , {x: [y]}]", "0-22 [1-3 [], 4-6 {}, 7-10 [], 13-21 {x 14-15: 17-20 [18-19 y]}]"},
           Row{"a: b:c\n? d\n: e", "0-14 {a 0-1: 3-6 b:c, d 9-10: 13-14 e}"},
           Row{"", "0-0 null"},
           Row{"# nothing\n", "9-9 null"},
       }) {
    CAPTURE(row.text);
    Tree tree(row.text);
    CHECK(tree.findings() == "");
    CHECK(tree.shape(tree.root) == row.shape);
  }
}

TEST_CASE("The place of a null is its word, or the key or dash before it") {
  Tree tree("a: null\nb: ~\nc:\nd: [ , ~]\ne:\n  -\n  - Null\nf: nullable\ng: \"null\"");
  CHECK(tree.findings() == "");
  CHECK(tree.shape(tree.root) ==
        "0-63 {a 0-1: 3-7 null, b 8-9: 11-12 null, c 13-14: 13-14 null, d 16-17: 19-25 [21-22 null, "
        "23-24 null], e 26-27: 31-41 [31-32 null, 37-41 null], f 42-43: 45-53 nullable, g 54-55: "
        "57-63 \"null\"}");
}

TEST_CASE("What the language does not have of YAML is refused, and the rest is read") {
  for (const Case& c : {
           Case{"a: &x b\nc: *x\n",
                "1:4 `&x` yaml_syntax: anchors are not part of the language (write the value wherever it "
                "is needed)\n"
                "2:4 `*x` yaml_syntax: aliases are not part of the language (write the value itself)\n"},
           Case{"a: !foo b\nc: !!str d\n",
                "1:4 `!foo` yaml_syntax: tags are not part of the language (leave it out)\n"
                "2:4 `!!str` yaml_syntax: tags are not part of the language (leave it out)\n"},
           Case{"&x a: b\n",
                "1:1 `&x` yaml_syntax: anchors are not part of the language (write the value wherever it is "
                "needed)\n"},
           Case{"a: {<<: {b: 1}, \"<<\": 2}\n",
                "1:5 `<<` yaml_syntax: merge keys are not part of the language (write the keys themselves)\n"},
           Case{"a: 1\nb: 2\na: 3\n\"a\": 4\n", "3:1 `a` duplicate_key: the key `a` stands here twice (leave one of "
                                                "them out, or put into one what both say)\n"
                                                "  1:1 `a` the first one is here\n"
                                                "4:1 `\"a\"` duplicate_key: the key `a` stands here twice (leave one "
                                                "of them out, or put into one what both say)\n"
                                                "  1:1 `a` the first one is here\n"},
           Case{"foo: bar\nnot-a-key\n", "2:1 `not-a-key` yaml_syntax: expected `:` behind `not-a-key`\n"},
           Case{"a: 1\nb:[c]\n",
                "2:1 `b:` yaml_syntax: expected a blank behind `b:` (a key and its value are written `key: value`; a "
                "text goes on in a line of its own only with `|` or in quotes)\n"},
           Case{"a: {every:10 ms, b: 1}\n",
                "1:5 `every:` yaml_syntax: expected a blank behind `every:` (a key and its value are written `key: "
                "value`; a text goes on in a line of its own only with `|` or in quotes)\n"},
           Case{"a: {b::c, d: 1}\n", "1:5 `b::c` yaml_syntax: expected `:` behind `b::c`\n"},
           Case{"Null: 1\n",
                "1:1 `Null` wrong_node_kind: a key is a word, found `Null`, which YAML reads as nothing (put it in "
                "quotes)\n"},
           Case{"a: {b, c: 1}\n", "1:5 `b` yaml_syntax: expected `:` behind `b`\n"},
           Case{"? [a]\n: b\n? {c: d}\n: e\n: f\n",
                "1:3 `[a]` wrong_node_kind: a key is a word, found a list (put a word before the `:`)\n"
                "3:3 `{c: d}` wrong_node_kind: a key is a word, found a mapping (put a word before the `:`)\n"
                "5:1 `:` wrong_node_kind: a key is a word, found nothing (put a word before the `:`)\n"},
           Case{"\ta\n", "1:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
           Case{"a: [\n\tb,\n\tc]\n", "2:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"
                                      "3:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
       }) {
    CAPTURE(c.text);
    Tree tree(c.text);
    CHECK(tree.root.kind != YamlNode::Kind::broken);
    CHECK(tree.findings() == c.findings);
  }
}

TEST_CASE("A tab in a text, behind a value or before a comment is no indentation") {
  for (const char* text : {"a: \"b\n\tc\"\n", "a: b\t# c\n\t\n\t# d\ne: |\n  x\n  \ty\n", "a:\tb\n"}) {
    CAPTURE(text);
    CHECK(Tree(text).findings() == "");
  }
}

TEST_CASE("A merge conflict that is not resolved is reported, and nothing that follows from it") {
  const std::string finding =
      "yaml_syntax: a merge conflict is not resolved (keep one side, and leave out the lines that "
      "begin with `<<<<<<<`, `|||||||`, `=======` or `>>>>>>>`)\n";
  CHECK(Tree("a:\n<<<<<<< HEAD\n  b: 1\n=======\n  b: 2\n>>>>>>> other\n").findings() == "2:1 `<<<<<<<` " + finding);
  CHECK(Tree("a: |\n  x\n<<<<<<< HEAD\n  y\n=======\n  z\n>>>>>>> other\n").findings() == "3:1 `<<<<<<<` " + finding);
  CHECK(Tree("a: 1\n||||||| base\nb: 2\n").findings() == "2:1 `|||||||` " + finding);
  CHECK(Tree("a: 1\n=======\r\nb: 2\n").findings() == "2:1 `=======` " + finding);
  CHECK(Tree("a: 1\n>>>>>>> other").findings() == "2:1 `>>>>>>>` " + finding);
  CHECK(Tree("a: \"\n<<<<<<< x\n\"\n# =======\n").findings() == "");
  CHECK(Tree("a: 1\n======== x\n").findings().find("conflict") == std::string::npos);
}

TEST_CASE("If the text is no YAML the place and the likely reason are reported") {
  for (
      const Case& c : {
          Case{"a: \"un\nb: 1\n", "1:4 `\"` yaml_syntax: this quote is never closed (close it with `\"`)\n"},
          Case{"a: ['x', 'un\nb: 1\n", "1:10 `'` yaml_syntax: this quote is never closed (close it with `'`)\n"},
          Case{"a: it's # don't\nb: \"un\n", "2:4 `\"` yaml_syntax: this quote is never closed (close it with `\"`)\n"},
          Case{"- a\nb: 1\n",
               "2:1 `b` yaml_syntax: text behind the end of the document (is the line indented as it should "
               "be?)\n"},
          Case{"{a: 1} garbage\n",
               "1:8 `g` yaml_syntax: text behind the end of the document (is the line indented as it "
               "should be?)\n"},
          Case{",",
               "1:1 `,` yaml_syntax: text behind the end of the document (is the line indented as it should be?)\n"},
          Case{"a: 1\n---\nb: 2\n", "2:1 `---` yaml_syntax: a second document; a file has one (leave out the `---`, or "
                                    "move what follows into a file of its own)\n"},
          Case{"x:\n\ta: 1\n", "2:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
          Case{"\ta: 1\n", "1:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
          Case{"a:\n  - b\n\t- c\n", "3:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
          Case{"a: |\n\tx\n", "2:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n"},
          Case{"a: [b\nc: d\n",
               "2:2 `:` yaml_syntax: expected `,` or `]` here (close what is opened there, or put the text in quotes)\n"
               "  1:4 `[` opened here\n"},
          Case{
              "a: {b: \"c\"d}\n",
              "1:11 `d` yaml_syntax: expected `,` or `}` here (close what is opened there, or put the text in quotes)\n"
              "  1:4 `{` opened here\n"},
          Case{"[a, b\n",
               "1:6 `` yaml_syntax: expected `,` or `]` here (close what is opened there, or put the text in quotes)\n"
               "  1:1 `[` opened here\n"},
          Case{"a: b # c\n  d\n", "2:3 `d` yaml_syntax: expected another key, or the end of this mapping (is the line "
                                  "indented as it should be?)\n"},
          Case{"x: 1\n y: 2\n",
               "2:3 `:` yaml_syntax: a `:` that belongs to no key (is the line indented as it should be? A "
               "text with `: ` in it needs quotes)\n"},
          Case{"a: - b\n",
               "1:4 `-` yaml_syntax: a `- ` that may not stand here (a list begins in a line of its own, or is "
               "written [a, b])\n"},
          Case{"a: [b}\n",
               "1:6 `}` yaml_syntax: expected `,` or `]` here (close what is opened there, or put the text in quotes)\n"
               "  1:4 `[` opened here\n"},
          Case{"%YAML 3.0\n---\na: b\n", "1:1 `%` yaml_syntax: this is YAML 1 (leave the line out)\n"},
          Case{"a: ]\n", "1:4 `]` yaml_syntax: a closing bracket that nothing opened (leave it out, or open it)\n"},
          Case{"a: @x\n", "1:4 `@` yaml_syntax: no word begins with this character (put the text in quotes)\n"},
          Case{"a: *\n", "1:5 `` yaml_syntax: aliases are not part of the language (a text that begins with `*` needs "
                         "quotes)\n"},
          Case{"a: *b\n", "1:4 `*` yaml_syntax: aliases are not part of the language (write the value itself)\n"},
          Case{"a: \"\\q\"\n",
               "1:7 `\"` yaml_syntax: unknown escape character: q (in single quotes a backslash stands for itself)\n"},
          Case{"\xEF\xBB\xBF"
               "a: 1\n",
               "1:1 `\xEF\xBB\xBF` yaml_syntax: the file begins with a byte order mark (save the file as UTF-8 "
               "without a byte "
               "order mark)\n"},
          Case{"a: \xFF\n",
               "1:4 `\xFF` yaml_syntax: the byte 0xFF is not UTF-8 (save the file as UTF-8 without a byte order "
               "mark)\n"},
          Case{"a: \x04\n", "1:4 `\x04` yaml_syntax: the byte 0x04 may not stand in a text (leave it out)\n"},
      }) {
    CAPTURE(c.text);
    Tree tree(c.text);
    CHECK(tree.root.kind == YamlNode::Kind::broken);
    CHECK(tree.findings() == c.findings);
  }
}

TEST_CASE("A blank that is missing before a bracket is named where it should be") {
  constexpr const char* help =
      " (a key and its value are written `key: value`; a text goes on in a line of its own only "
      "with `|` or in quotes)\n";
  struct Row {
    const char *text, *place, *blank;
  };
  for (const Row& row : {
           Row{"groups:\n  W:{needs: [L]}\n  L: {}\n", "2:3 `W:`", "a blank behind `W:`"},
           Row{"groups:\n  W {needs: [L]}\n  L: {}\n", "2:3 `W`", "`:` behind `W`"},
           Row{"groups:{W: {}}\n", "1:1 `groups:`", "a blank behind `groups:`"},
           Row{"groups:\n  W:{providers: [{name: a}]}\n", "2:3 `W:`", "a blank behind `W:`"},
           Row{"groups:\n  W:{tasks: [L], needs: [L]}\n", "2:3 `W:`", "a blank behind `W:`"},
           Row{"W: {tasks:[L]}\n", "1:5 `tasks:`", "a blank behind `tasks:`"},
           Row{"W: {needs: [L], tasks:[L], uses: [L]}\n", "1:17 `tasks:`", "a blank behind `tasks:`"},
           Row{"W: {tasks:{L: {}}}\n", "1:5 `tasks:`", "a blank behind `tasks:`"},
       }) {
    CAPTURE(row.text);
    CHECK(Tree(row.text).findings() == fmt::format("{} yaml_syntax: expected {}{}", row.place, row.blank, help));
  }
}

TEST_CASE("The help for a text that is in quotes, or in a block, is none that asks for quotes") {
  const std::string single = " (in single quotes a backslash stands for itself)\n";
  const std::string block =
      " (behind it may stand `+`, `-`, an indentation from 1 to 9, and a comment; the text begins "
      "in the next line)\n";
  const std::string number =
      "yaml_syntax: no character has the number behind this backslash (write the character itself)\n";
  const std::string hex = "yaml_syntax: expected hexadecimal digits behind the backslash and its letter" + single;
  CHECK(Tree("a: \"\\ud800\"\n").findings() == "1:11 `\"` " + number);
  CHECK(Tree("a: \"\\U00110000\"\n").findings() == "1:15 `\"` " + number);
  CHECK(Tree("a: \"\\x\"\n").findings() == "1:8 `` " + hex);
  CHECK(Tree("a: |0\n").findings() == "1:6 `` yaml_syntax: a block text cannot be indented by 0" + block);
  CHECK(Tree("a: |x\n").findings() == "1:5 `x` yaml_syntax: expected the end of the line behind `|` or `>`" + block);
  CHECK(Tree("a: &a &b x\n").findings() == "1:7 `&` yaml_syntax: anchors are not part of the language (leave them "
                                           "out)\n");
}

TEST_CASE("A key that is longer than YAML lets it be is named, in a line of its own and between brackets") {
  const std::string longest(1024, 'a'), longer = longest + "a";
  const auto said = [](const std::string& place, const std::string& key) {
    return place + " `" + key +
           "` input_limit: a key of more than 1024 bytes (choose a shorter name: YAML has no longer keys)\n";
  };
  CHECK(Tree(longest + ": b\n").findings() == "");
  CHECK(Tree("{" + longest + ": b}\n").findings() == "");
  CHECK(Tree(longer + ": b\n").findings() == said("1:1", longer));
  CHECK(Tree("a:\n  b: c\n  " + longer + ":\n    d: e\n").findings() == said("3:3", longer));
  CHECK(Tree("{" + longer + ": b}\n").findings() == said("1:2", longer));
  CHECK(Tree("{\"" + longer + "\": b}\n").findings() == said("1:2", '"' + longer + '"'));
  CHECK(Tree("a: {b: c, " + longer + ": d}\n").findings() == said("1:11", longer));
}

TEST_CASE("64 levels are read, and one more is refused") {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  CHECK(Tree(nested(deepest_nesting)).findings() == "");
  CHECK(Tree(nested(deepest_nesting + 1)).findings() ==
        "1:65 `[` input_limit: nested deeper than 64 levels (the language needs ten at most: leave out what nests the "
        "others)\n");
  CHECK(Tree(nested(400'000)).findings() == "1:65 `[` input_limit: nested deeper than 64 levels (the language needs "
                                            "ten at most: leave out what nests the others)\n");
}

TEST_CASE("A file of too many values is refused") {
  std::string text = "k: [a";
  while (text.size() < 2 * most_values) text += ",a";
  Tree tree(text + "]");
  CHECK(tree.findings() == "1:3999999 `a` input_limit: the file has more than 2000000 keys and values (divide it into "
                           "files that import one another)\n");
}
