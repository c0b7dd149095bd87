// SPDX-License-Identifier: MIT
// Where missing functions are inserted, and the report if that is impossible: whole programs before and after.
#include "compiler/stubs/merge.hpp"
#include "tests/compiler/stubs/cheap_cpp.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;
using namespace director::compiler::stubs;

namespace {

using Kind = WantedFunction::Kind;

/// One module with the functions.
Wanted wanted_with(std::vector<WantedFunction> functions) {
  return {"b", "b.hpp", "b", {{"legs", "b::Legs", "Legs", "legs", std::move(functions)}}, {}};
}

const WantedFunction walk{Kind::provide, "b::Walk::Default", {"(b.yaml:1)"}};
const WantedFunction stop{Kind::stop, "b::Walk::Stop", {"(b.yaml:2)"}};
const WantedFunction jump{Kind::provide, "b::Jump::Default", {"(b.yaml:3)"}};

/// As the cheap stand-in for Clang reads it, with a last change of what it has found.
template <class Change>
Merge merged(const Wanted& wanted, const Texts& texts, Change change) {
  Found found = read_cheaply(texts, wanted);
  change(found);
  return merge(wanted, found, texts);
}
Merge merged(const Wanted& wanted, const Texts& texts) {
  return merged(wanted, texts, [](Found&) {});
}

/// All files afterwards.
Texts after(const Merge& merge, Texts texts) {
  for (const std::vector<Insertion>& each : by_file(merge.insertions)) {
    std::string& text = texts.at(each.front().path);
    text = insert_into(text, each).text;
  }
  for (const auto& file : merge.sources) texts[file.path] = file.text;
  return texts;
}

std::vector<std::string> said(const std::vector<Remark>& remarks) {
  std::vector<std::string> out;
  for (const Remark& each : remarks)
    out.push_back(each.place.path + ":" + std::to_string(each.place.line) + ":" + std::to_string(each.place.column) +
                  ": " + each.message);
  return out;
}

using Said = std::vector<std::string>;

const std::string decl_walk = "  director::Outcome provide(b::Walk::Default& run) override;\n";
const std::string decl_stop = "  void stop(b::Walk::Stop& run) override;\n";
const std::string decl_jump = "  director::Outcome provide(b::Jump::Default& run) override;\n";
const std::string body_jump = "/// (b.yaml:3)\ndirector::Outcome Legs::provide(b::Jump::Default& run) {\n"
                              "  return run.keep(); // does nothing yet\n}\n";

} // namespace

TEST_CASE("a module that no class implements gets files of its own") {
  const Merge merge = merged(wanted_with({walk}), {{"/p/other.cpp", "class Legs {};\n"}});
  CHECK(merge == Merge{{0}, {}, {}, {}, {}});
}

TEST_CASE("a class that has everything gets nothing") {
  const Texts texts{{"/p/legs.hpp", "class Legs : public b::Legs {\n public:\n" + decl_walk + "};\n"},
                    {"/p/legs.cpp", "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n"}};
  CHECK(merged(wanted_with({walk}), texts) == Merge{});
}

TEST_CASE("a class of the same name in another file does not have what is missing here") {
  const std::string head = "class Legs : public b::Legs {\n public:\n";
  const std::string whole = "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n"
                            "director::Outcome Legs::provide(b::Jump::Default& run) { return {}; }\n";
  const Texts texts{{"/p/legs.cpp", head + decl_walk + "};\n" + whole.substr(0, whole.find('\n') + 1)},
                    {"/p/fake.cpp", head + decl_walk + decl_jump + "};\n" + whole}};
  const Texts changed = after(merged(wanted_with({walk, jump}), texts), texts);
  CHECK(changed.at("/p/fake.cpp") == texts.at("/p/fake.cpp"));
  CHECK(changed.at("/p/legs.cpp") ==
        head + decl_walk + decl_jump + "};\n" + whole.substr(0, whole.find('\n') + 1) + "\n" + body_jump);
}

TEST_CASE("what is missing goes behind what comes before it in the behaviour, declaration and definition") {
  const Texts texts{{"/p/legs.hpp", "class Legs : public b::Legs {\n public:\n" + decl_walk + decl_jump + "};\n"},
                    {"/p/legs.cpp", "director::Outcome Legs::provide(b::Jump::Default& run) { return {}; }\n"
                                    "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n"}};
  const Merge merge = merged(wanted_with({walk, stop, jump}), texts);
  CHECK(after(merge, texts) ==
        Texts{{"/p/legs.hpp", "class Legs : public b::Legs {\n public:\n" + decl_walk + decl_stop + decl_jump + "};\n"},
              {"/p/legs.cpp", "director::Outcome Legs::provide(b::Jump::Default& run) { return {}; }\n"
                              "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n\n"
                              "/// (b.yaml:2)\nvoid Legs::stop(b::Walk::Stop& run) {\n"
                              "  static_cast<void>(run); // does nothing yet\n}\n"}});
  CHECK(merge.obstacles.empty());
}

TEST_CASE("a body goes to the source where those of the class are, also if all of them are left over") {
  const Texts texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk + decl_stop + "};\n"},
                    {"/p/legs.cpp", "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n"
                                    "void Legs::stop(b::Walk::Stop& run) {}\nint other;\n"}};
  const auto renamed = [](Found& found) {
    for (FoundFunction& each : found.functions) each.known = false;
  };
  CHECK(after(merged(wanted_with({jump}), texts, renamed), texts) ==
        Texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk + decl_stop + decl_jump + "};\n"},
              {"/p/legs.cpp", "director::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n"
                              "void Legs::stop(b::Walk::Stop& run) {}\n\n" +
                                  body_jump + "int other;\n"}});
}

TEST_CASE("an empty class that hides what it has gets a label") {
  const Texts texts{{"/p/legs.cpp", "class Legs : public b::Legs {};\n"}};
  CHECK(after(merged(wanted_with({walk}), texts), texts).at("/p/legs.cpp") ==
        "class Legs : public b::Legs {\npublic:\n  /// (b.yaml:1)\n"
        "  director::Outcome provide(b::Walk::Default& run) override {\n"
        "    return run.keep(); // does nothing yet\n  }\n};\n");
}

TEST_CASE("the result is called as the user calls it") {
  const Texts texts{{"/p/legs.cpp",
                     "struct Legs : public b::Legs {\n  Outcome provide(b::Walk::Default& r) override { return {}; }\n"
                     "};\n"}};
  CHECK(after(merged(wanted_with({walk, jump}), texts), texts).at("/p/legs.cpp") ==
        "struct Legs : public b::Legs {\n  Outcome provide(b::Walk::Default& r) override { return {}; }\n"
        "  /// (b.yaml:3)\n  Outcome provide(b::Jump::Default& run) override {\n"
        "    return run.keep(); // does nothing yet\n  }\n};\n");
}

TEST_CASE("where the behaviour's namespace is hidden, names are written from outside") {
  const Texts texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk + "};\n"},
                    {"/p/legs.cpp", "director::Outcome Legs::provide(::b::Walk::Default& run) { return {}; }\n"}};
  const auto hidden = [](Found& found) {
    found.classes.front().hides = true;
    for (FoundFunction& each : found.functions) each.context = walk.context, each.known = true;
  };
  const Texts changed = after(merged(wanted_with({walk, jump}), texts, hidden), texts);
  CHECK(changed.at("/p/legs.hpp") == "struct Legs : public b::Legs {\n" + decl_walk +
                                         "  director::Outcome provide(::b::Jump::Default& run) override;\n};\n");
  CHECK(changed.at("/p/legs.cpp") ==
        texts.at("/p/legs.cpp") + "\n/// (b.yaml:3)\ndirector::Outcome Legs::provide(::b::Jump::Default& run) {\n"
                                  "  return run.keep(); // does nothing yet\n}\n");
}

TEST_CASE("what is declared and nowhere defined goes to the source beside the header, with the line breaks it has") {
  Texts texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_jump + "};\n"},
              {"/p/legs.cc", "#include \"legs.hpp\"\r\nint legs;\r\n"},
              {"/p/legs.cxx", ""}};
  std::string expected = "\r\n" + body_jump;
  for (std::size_t at = 2; (at = expected.find('\n', at)) != std::string::npos; at += 2) expected.insert(at, "\r");
  CHECK(after(merged(wanted_with({jump}), texts), texts).at("/p/legs.cc") ==
        "#include \"legs.hpp\"\r\nint legs;\r\n" + expected);
  texts.erase("/p/legs.cc");
  CHECK(after(merged(wanted_with({jump}), texts), texts).at("/p/legs.cxx") == "\n" + body_jump);
  texts.erase("/p/legs.cxx");
  CHECK(after(merged(wanted_with({jump}), texts), texts).at("/p/legs.cpp") == "#include \"legs.hpp\"\n\n" + body_jump);
}

TEST_CASE("a namespace without a name is left out if a definition is outside of it") {
  const Texts texts{
      {"/p/legs.hpp", "namespace team { namespace {\nstruct Legs : public b::Legs {\n" + decl_jump + "};\n} }\n"}};
  const Merge merge = merged(wanted_with({jump}), texts);
  REQUIRE(merge.sources.size() == 1);
  CHECK(merge.sources[0].text.find("director::Outcome team::Legs::provide(b::Jump::Default& run) {\n") !=
        std::string::npos);
}

TEST_CASE("nothing is inserted behind what is under an #if of its own") {
  const Texts texts{
      {"/p/legs.hpp", "struct Legs : public b::Legs {\n#if 1\n" + decl_walk + "#endif\n  int count = 0;\n};\n"}};
  CHECK(after(merged(wanted_with({walk, jump}), texts,
                     [](Found& found) {
                       FoundFunction body = found.functions.front(); // defined elsewhere
                       body.within = false, body.defines = true, body.place.path = "/elsewhere/legs.cpp";
                       found.functions.push_back(body);
                     }),
              texts)
            .at("/p/legs.hpp") == "struct Legs : public b::Legs {\n#if 1\n" + decl_walk +
                                      "#endif\n  int count = 0;\n  /// (b.yaml:3)\n"
                                      "  director::Outcome provide(b::Jump::Default& run) override {\n"
                                      "    return run.keep(); // does nothing yet\n  }\n};\n");
}

TEST_CASE("no body goes behind one that is under an #if of its own") {
  const Texts texts{
      {"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk + "};\n"},
      {"/p/legs.cpp", "#if 1\ndirector::Outcome Legs::provide(b::Walk::Default& run) { return {}; }\n#endif\n"}};
  CHECK(after(merged(wanted_with({walk, jump}), texts), texts) ==
        Texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk +
                                  "  /// (b.yaml:3)\n  director::Outcome provide(b::Jump::Default& run) override {\n"
                                  "    return run.keep(); // does nothing yet\n  }\n};\n"},
              {"/p/legs.cpp", texts.at("/p/legs.cpp")}});
}

TEST_CASE("a class that implements two modules gets one label for what both miss") {
  Wanted wanted = wanted_with({walk});
  wanted.modules.push_back({"eyes", "b::Eyes", "Eyes", "eyes", {jump}});
  const Texts texts{{"/p/both.hpp", "class Both : public b::Legs, public b::Eyes {\n};\n"}};
  const Merge merge = merged(wanted, texts, [](Found& found) {
    found.classes = {
        {"Both", {"b::Eyes", "b::Legs"}, {}, {"/p/both.hpp", 1, 7}, 46, unconditional, false, false, false, {}}};
  });
  CHECK(merge.fresh.empty());
  const std::string text = after(merge, texts).at("/p/both.hpp");
  CHECK(text == "class Both : public b::Legs, public b::Eyes {\npublic:\n  /// (b.yaml:1)\n"
                "  director::Outcome provide(b::Walk::Default& run) override {\n"
                "    return run.keep(); // does nothing yet\n  }\n  /// (b.yaml:3)\n"
                "  director::Outcome provide(b::Jump::Default& run) override {\n"
                "    return run.keep(); // does nothing yet\n  }\n};\n");
}

TEST_CASE("of classes below one another only the last gets what none of them has") {
  const std::string text = "struct Some : public b::Legs {\n" + decl_walk + "};\nstruct Rest : public Some {\n};\n";
  const Texts texts{{"/p/legs.hpp", text}};
  const Merge merge = merged(wanted_with({walk, jump}), texts, [&](Found& found) {
    found.functions.front().defines = true;
    const std::size_t end = text.rfind("};");
    found.classes.push_back({"Rest",
                             {"b::Legs"},
                             {{"/p/legs.hpp", 1, 8}},
                             {"/p/legs.hpp", 4, 8},
                             end,
                             unconditional,
                             true,
                             false,
                             false,
                             {}});
  });
  REQUIRE(merge.insertions.size() == 1);
  CHECK(merge.insertions[0].offset == text.rfind("};"));
  CHECK(merge.insertions[0].text == "  /// (b.yaml:3)\n  director::Outcome provide(b::Jump::Default& run) override {\n"
                                    "    return run.keep(); // does nothing yet\n  }\n");
}

TEST_CASE("what cannot be added is reported at the class, with the reason") {
  const Texts texts{{"/p/legs.hpp", "struct Legs : public b::Legs {\n" + decl_walk + "};\n"}};
  const auto obstacles = [&](auto change) {
    const Merge merge = merged(wanted_with({walk, jump}), texts, change);
    CHECK(merge.sources.empty());
    return said(merge.obstacles);
  };
  const std::string jumps = "/p/legs.hpp:1:8: `Outcome provide(b::Jump::Default& run)` of `Legs` is missing and cannot "
                            "be added: ";
  const std::string walks = "/p/legs.hpp:1:8: `Outcome provide(b::Walk::Default& run)` of `Legs` is missing and cannot "
                            "be added: ";
  const auto defined = [](Found& found) { found.functions.front().defines = true; };
  CHECK(obstacles([&](Found& found) {
          defined(found);
          found.classes.front().in_macro = true;
        }) == Said{jumps + "the class ends in a macro"});
  CHECK(obstacles([&](Found& found) { found.classes.front().only_inline = true; }) ==
        Said{walks + "it is declared in a template or a local class, without a body"});

  const auto elsewhere = [&](bool with_body) {
    Found found = read_cheaply(texts, wanted_with({walk, jump}));
    found.functions.front().defines = with_body;
    return said(merge(wanted_with({walk, jump}), found, {}).obstacles);
  };
  CHECK(elsewhere(true) == Said{jumps + "the class is outside of the folder"});
  CHECK(elsewhere(false) ==
        Said{jumps + "the class is outside of the folder", walks + "the class is outside of the folder"});
}

TEST_CASE("headers are known by their names") {
  for (const char* const path :
       {"a.hpp", "a.h", "/x/a.hh", "a.hxx", "a.h++", "a.ipp", "a.inl", "a.tpp", "a.tcc", "a.txx", "a.cuh"})
    CHECK(is_header(path));
  for (const char* const path : {"a.cpp", "hpp", ".hpp", "a.hpp.in", ""}) CHECK_FALSE(is_header(path));
}
