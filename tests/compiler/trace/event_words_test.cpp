// SPDX-License-Identifier: MIT
// Tests compiler/trace/event_words.cpp: every event has a text, and different events have different ones.
#include "compiler/trace/event_words.hpp"
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/recorded_names.hpp"
#include "runtime/core/api/event_names.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <string>
#include <utility>

using namespace director::compiler;

namespace {

const std::string words_header =
    R"({"director_trace":1,"behaviour":"b","fingerprint":"0000000000000000","groups":[{"name":"A","providers":["x","y"]},{"name":"B","providers":["default"]}],)"
    R"("edges":[{"name":"root>A","target":"A","levels":["","fast"]},{"name":"A>B","target":"B","levels":[""]}],"states":[{"name":"S","values":["on","off"]}],)"
    R"("triggers":["T"],"conditions":["S == on","S == off"]})";

class WordsReader {
public:
  explicit WordsReader(const std::string& header = words_header) {
    std::string problem;
    recorded_ = RecordedNames::read(parse_json(header).value(), problem);
    REQUIRE(recorded_);
    names_ = recorded_->names();
  }
  director::Event event(const std::string& members) const {
    const Lookup::Found found = Lookup(names_).event(parse_json("{" + members + "}").value());
    INFO(members);
    REQUIRE(found.problem.empty());
    return found.event;
  }
  std::string words(const std::string& members) const { return words_of(event(members), names_); }
  std::pair<std::string, std::string> both(const std::string& one, const std::string& other) const {
    return words_of_both(event(one), names_, event(other), names_);
  }

private:
  std::optional<RecordedNames> recorded_;
  director::Names names_;
};

} // namespace

TEST_CASE("events that simulate does not print have words too") {
  const WordsReader reader;
  const auto words = [&](const std::string& members) { return reader.words(R"("t":1500000,"n":3,)" + members); };
  CHECK(words(R"("event":"run","group":"A","provider":"x","reasons":["new_task"])") == "run A.x new_task");
  CHECK(words(R"("event":"grant","edge":"root>A","provider":"x")") == "grant root>A in A.x");
  CHECK(words(R"("event":"grant","edge":"A>B","provider":"default")") == "grant A>B");
  CHECK(words(R"("event":"grant","group":"B","edge":"limbo","provider":"default")") ==
        "hold B for what comes after it");
  CHECK(words(R"("event":"grant","edge":"A>B","from":"root>A","provider":"default")") ==
        "hand over B from root>A to A>B");
  CHECK(words(R"("event":"grant","edge":"A>B","from":"limbo","provider":"default")") == "grant A>B");
  CHECK(words(R"("event":"lose","group":"B","from":"A>B")") == "lose B, held for A>B");
  CHECK(words(R"("event":"lose","group":"B","from":"limbo")") == "lose B, held for what comes after it");
  CHECK(words(R"("event":"ask","edge":"A>B")") == "ask A>B");
  CHECK(words(R"("event":"keep","edge":"A>B")") == "keep A>B");
  CHECK(words(R"("event":"withdraw","edge":"A>B")") == "withdraw A>B");
  CHECK(words(R"("event":"wait","group":"A","due":2500000)") == "wait A: until 2.500000 s");
  CHECK(words(R"("event":"wait","group":"A")") == "wait A: for no time");
  CHECK(words(R"("event":"answer","group":"A","provider":"x","answer":"pack")") == "answer A.x: pack 1 of its list");
  CHECK(words(R"("event":"answer","group":"A","provider":"x","answer":"done")") == "answer A.x: done");
  CHECK(words(R"("event":"assign","group":"A","provider":"x","state":"S","value":"off")") == "assign S off");
  CHECK(words(R"("event":"given","state":"S","value":null)") == "given S no value");
  CHECK(words(R"("event":"begin")") == "begin");
  CHECK(words(R"("event":"input","input":"cancel")") == "> cancel all");
  CHECK(words(R"("event":"input","input":"expire","state":"S")") == "> expire S");
  CHECK(words(R"("event":"input","input":"wait","group":"A")") == "> wait A");
  CHECK(words(R"("event":"input","input":"every","group":"A","provider":"y")") == "> every A.y");
}

TEST_CASE("the text of an event has all of its names, however long they are") {
  const std::string group(1024, 'A'), provider(1024, 'x');
  std::string header = words_header;
  header.replace(header.find(R"("A","providers":["x")"), 20, fmt::format(R"("{}","providers":["{}")", group, provider));
  for (std::size_t at; (at = header.find(R"("target":"A")")) != std::string::npos;)
    header.replace(at, 12, fmt::format(R"("target":"{}")", group));
  for (const auto& [of, name] : {std::pair("root>A", "root>" + group), std::pair("A>B", group + ">B")}) {
    const std::string quoted = fmt::format("\"{}\"", of);
    header.replace(header.find(quoted), quoted.size(), fmt::format("\"{}\"", name));
  }
  const WordsReader reader(header);
  CHECK(reader.words(fmt::format(R"("t":1,"n":3,"event":"run","group":"{}","provider":"{}","reasons":["new_task"])",
                                 group, provider)) == fmt::format("run {}.{} new_task", group, provider));
}

TEST_CASE("if two events have equal texts, the difference is added") {
  const WordsReader reader;
  using Both = std::pair<std::string, std::string>;
  const std::string done = R"("event":"done","group":"A")";
  CHECK(reader.both(R"("t":1,"n":3,)" + done, R"("t":2,"n":4,)" + done) ==
        Both("done A, at 0.000001 s", "done A, at 0.000002 s"));
  CHECK(reader.both(R"("t":1,"n":3,)" + done, R"("t":1,"n":4,)" + done) ==
        Both("done A, in micro-step 3", "done A, in micro-step 4"));
  CHECK(reader.both(R"("t":1,"until":5,"n":3,)" + done, R"("t":1,"n":3,)" + done) ==
        Both("done A, in the step of 0.000005 s", "done A, in the step of 0.000001 s"));
  CHECK(reader.both(R"("t":1,"n":3,"event":"ask","edge":"root>A")",
                    R"("t":2,"n":3,"event":"ask","edge":"root>A","level":"fast")") ==
        Both("ask root>A, level 1 of its list", "ask root>A, level fast"));
  CHECK(reader.both(R"("t":1,"n":3,"event":"assign","group":"A","provider":"x","state":"S","value":"on")",
                    R"("t":1,"n":3,"event":"assign","group":"A","state":"S","value":"on")") ==
        Both("assign S on, by x", "assign S on, by a handler"));
  CHECK(reader.both(R"("t":1,"n":3,"event":"push","edge":"A>B","group":"A","provider":"x","condition":"S == on")",
                    R"("t":1,"n":3,"event":"push","edge":"A>B","group":"A","provider":"x","condition":"S == off")") ==
        Both("push A.x for A>B, for S == on", "push A.x for A>B, for S == off"));
  CHECK(reader.both(R"("t":1,"n":3,"event":"grant","edge":"A>B","from":"limbo","provider":"default")",
                    R"("t":1,"n":3,"event":"grant","edge":"A>B","provider":"default")") ==
        Both("grant A>B, before for what comes after it", "grant A>B, before for no task"));
}
