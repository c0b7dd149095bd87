// SPDX-License-Identifier: MIT
// The checks that read C++, with facts in the form of director-clang's: what can be tested without Clang.
#include "compiler/checks/code_check.hpp"
#include "compiler/pipeline.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::compiler;

const char* const behaviour = R"(behaviour: x
language: 1
roots: [Walk]
groups:
  Walk: {module: legs, realtime: true, tasks: {Leg: {}, Arm: {optional: true}}}
  Leg: {module: legs}
  Arm: {module: legs}
)";

std::string same_path(const std::string& path) { return path; }

struct Seen {
  std::string findings, unseen;
};

/// `functions`: of one file, in JSON; "BODY" stands for the key, name and context of the body of Walk.
/// `runs`: keys of bodies of which an object is made, in JSON.
Seen look(std::string functions, bool errors = false, const std::string& runs = {}) {
  const std::string body =
      R"("key": "walk", "name": "Legs::provide", "at": [0, 0, 1], "context": "x::Walk::Default", "class": "Legs")";
  for (std::size_t at = functions.find("BODY"); at != std::string::npos; at = functions.find("BODY"))
    functions.replace(at, 4, body);
  dsl::MemoryFiles files;
  files.add("x.yaml", behaviour);
  files.add("/legs.cpp", "0123456789");
  dsl::Sources sources;
  const Checked checked = check("x.yaml", files, sources);
  REQUIRE(checked.resolved);
  CodeFiles code_files(files, sources, same_path);
  CodeFacts code;
  const auto unit = parse_json(R"({"paths": ["/legs.cpp"], "errors": )" + std::string(errors ? "[{}]" : "[]") +
                               R"(, "runs": [)" + runs + R"(], "functions": [)" + functions + "]}");
  REQUIRE(unit);
  add_unit(code, *unit, code_files);
  const analysis::CodeInput input = analysis::look_below(checked.model, code);
  Seen out;
  for (const dsl::Diagnostic& each : checks::run_code_checks(input))
    out.findings += each.message + " [" + each.id + "]\n";
  for (const analysis::Body& each : input.bodies) {
    for (const analysis::Unseen& one : each.unseen)
      out.unseen += one.what + (one.carries ? " with the context\n" : "\n");
  }
  return out;
}

const std::string requests_leg =
    R"({"context": "x::Walk::Default", "word": "request", "tasks": ["x::Leg"], "at": [0, 1, 2]})";
const std::string requests_both =
    R"({"context": "x::Walk::Default", "word": "request", "tasks": ["x::Leg", "x::Arm"], "at": [0, 1, 2]})";
const std::string arm_is_missing = "no path of `Walk` requests `Arm` [task_never_requested]\n";

TEST_CASE("what a function below a body requests counts, at any depth, and in a cycle too") {
  CHECK(look(R"({BODY, "does": [)" + requests_leg + "]}").findings == arm_is_missing);
  CHECK(look(R"({BODY, "calls": [{"to": "a", "name": "a", "at": [0, 1, 2]}]},
                {"key": "a", "calls": [{"to": "b", "name": "b", "at": [0, 1, 2]}]},
                {"key": "b", "calls": [{"to": "a", "name": "a", "at": [0, 1, 2]}], "does": [)" +
             requests_both + "]}")
            .findings.empty());
}

TEST_CASE("what is requested in the context of another provider does not count") {
  CHECK(look(R"({BODY, "does": [)" + requests_leg +
             R"(, {"context": "x::Leg::Default", "word": "request", "tasks": ["x::Arm"], "at": [0, 1, 2]}]})")
            .findings == arm_is_missing);
}

TEST_CASE("no finding reports that something never happens if the context leaves the visible code") {
  const auto with = [](const std::string& more) {
    return look(R"({BODY, "does": [)" + requests_leg + "], " + more + "}");
  };
  CHECK(with(R"("hidden": [{"what": "a call through a pointer", "at": [0, 1, 2], "carries": true}])").findings.empty());
  CHECK(with(R"("hidden": [{"what": "a call through a pointer", "at": [0, 1, 2]}])").findings == arm_is_missing);
  const Seen library =
      with(R"("calls": [{"to": "l", "name": "lib::go", "at": [0, 1, 2], "declared": [0, 3, 4], "carries": true}])");
  CHECK(library.findings.empty());
  CHECK(library.unseen == "`lib::go` with the context\n");
  CHECK(look(R"({BODY, "does": [)" + requests_leg + "]}", true).findings.empty());
}

TEST_CASE("what a body never does counts only if those that override it do not do it either") {
  const auto with = [](const std::string& of_other, const std::string& runs = R"("own")") {
    return look(R"({BODY, "does": [)" + requests_leg + R"(]}, {"key": "own", "name": "Own::provide", "at": [0, 1, 2],
                "context": "x::Walk::Default", "class": "Own", "overrides": ["walk"], )" +
                    of_other + "}",
                false, runs)
        .findings;
  };
  CHECK(with(R"("does": [)" + requests_leg + "]") == arm_is_missing + arm_is_missing);
  CHECK(with(R"("does": [)" + requests_both + "]").empty());
  CHECK(with(R"("does": [], "hidden": [{"what": "a call through a pointer", "at": [0, 1, 2], "carries": true}])")
            .empty());
  // An object of the class itself is made too.
  CHECK(with(R"("does": [)" + requests_both + "]", R"("own", "walk")") == arm_is_missing);
}

TEST_CASE("what nobody can see may use a context that was stored before") {
  const std::string unseen = R"("hidden": [{"what": "a call of a `std::function`", "at": [0, 1, 2], "if_stored": true}],
      "calls": [{"to": "l", "name": "lib::go", "at": [0, 1, 2], "declared": [0, 3, 4]},
                {"to": "v", "name": "Base::go", "at": [0, 1, 2], "virtual": true}])";
  const auto with = [&](const std::string& more) {
    return look(R"({BODY, "does": [)" + requests_leg + "], " + more + unseen + "}");
  };
  CHECK(with("").findings == arm_is_missing);
  CHECK(with("").unseen == "`lib::go`\n`Base::go`, which is virtual\n");
  CHECK(with(R"("stores": true, )").findings.empty());
  CHECK(with(R"("stores": true, )").unseen ==
        "a call of a `std::function` with the context\n`lib::go` with the context\n`Base::go`, which is virtual\n");
}

TEST_CASE("an answer that Clang may have dropped, as it does not understand the file, is not missing") {
  const std::string body = R"({BODY, "open_end": [0, 8, 8], "does": [)" + requests_both + "]}";
  CHECK(look(body).findings == "`Walk` may end here without an answer [missing_answer]\n");
  CHECK(look(body, true).findings.empty());
}

TEST_CASE("calls of a virtual function lead to all its overriders, and to functions that are not visible") {
  const Seen seen = look(R"({BODY, "calls": [{"to": "base", "name": "Base::go", "at": [0, 1, 2], "virtual": true}]},
                            {"key": "derived", "name": "Derived::go", "overrides": ["base"],
                             "blocks": [{"name": "usleep", "why": "sleeps", "at": [0, 2, 3]}], "does": [)" +
                         requests_leg + "]}");
  CHECK(seen.findings == arm_is_missing + "`usleep` sleeps, and `Walk` is `realtime` [blocking_call]\n");
  CHECK(seen.unseen == "`Base::go`, which is virtual\n");
}

TEST_CASE("a lambda that may be called later does not block the body that makes it") {
  const std::string sleeper = R"({"key": "s", "blocks": [{"name": "usleep", "why": "sleeps", "at": [0, 2, 3]}]})";
  CHECK(look(R"({BODY, "does": [)" + requests_both +
             R"(], "calls": [{"to": "s", "name": "s", "at": [0, 1, 2], "maybe": true}]}, )" + sleeper)
            .findings.empty());
  CHECK(look(R"({BODY, "does": [)" + requests_both + R"(], "calls": [{"to": "s", "name": "s", "at": [0, 1, 2]}]}, )" +
             sleeper)
            .findings == "`usleep` sleeps, and `Walk` is `realtime` [blocking_call]\n");
}

} // namespace
