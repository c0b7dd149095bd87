// SPDX-License-Identifier: MIT
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"
#include "tests/support/golden.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace director;
using namespace director::compiler;
using director::tests::compile;
using director::tests::Compiled;

namespace {

struct Lowering {
  explicit Lowering(const std::string& text)
      : compiled(compile("behaviour: traits\nlanguage: 1\n" + text)),
        lowered(lower(compiled.model)) {}

  const director::Group& group(const std::string& name) const { return lowered.groups[compiled.group(name).value]; }
  const director::Component& component(const std::string& name) const {
    return lowered.components[group(name).component];
  }

  Compiled compiled;
  Lowered lowered;
};

/// Of two tasks of one group, by what they are written as, whose groups have these lines.
bool equals(const std::string& tasks, const std::string& below = "{}") {
  const Lowering it("roots: [Boss]\ngroups:\n  Boss: {tasks: " + tasks + "}\n  A: " + below + "\n  B: {}\n  C: {}\n");
  return it.component("Boss").equals;
}

// The traits once more, pair by pair, as they are defined: of edges of one requester, of levels, of groups.

bool is_simple(const Tables& t, Index group) {
  const director::Group& row = t.groups[group];
  return row.providers.size() == 1 && t.providers[row.providers.begin].needs.empty();
}

bool is_conditional(const Tables& t, Index group) {
  bool any = false;
  for (const director::Provider& row : t.providers)
    any = any || (row.group == group && (!row.when.empty() || !row.stay.empty()));
  return any;
}

std::vector<Index> urgencies(const Tables& t, Index edge) {
  std::vector<Index> out{t.edges[edge].need_urgency};
  for (Index level = t.edges[edge].levels.begin; level != t.edges[edge].levels.end; ++level)
    out.push_back(t.levels[level].urgency);
  return out;
}

bool may_be_equal(const Tables& t, Index a, Index b) {
  if (a == b || t.edges[a].requester != t.edges[b].requester) return false;
  const auto component = [&](Index edge) { return t.groups[t.edges[edge].target].component; };
  const auto leads_on = [&](Index edge) { return !t.groups[t.edges[edge].target].edges.empty(); };
  if (component(a) != component(b) || (!leads_on(a) && !leads_on(b))) return false;
  const std::vector<Index> of_a = urgencies(t, a), of_b = urgencies(t, b);
  return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

bool has_equals(const Tables& t, Index component) {
  for (Index a = 0; a < t.edges.size(); ++a) {
    if (t.groups[t.edges[a].target].component != component) continue;
    for (Index b = 0; b < a; ++b) {
      if (may_be_equal(t, a, b)) return true;
    }
  }
  return false;
}

bool has_slots(const Tables& t, Index component) {
  for (const director::Group& group : t.groups) {
    if (group.component == component && !group.slots.empty()) return true;
  }
  return false;
}

} // namespace

TEST_CASE("a group is simple with one provider that needs nothing") {
  const Lowering it(R"(
roots: [One, Two, Needs]
groups:
  One: {}
  Two: {providers: [{name: here}, {name: there}]}
  Needs: {needs: [One]}
)");
  CHECK(it.group("One").simple);
  CHECK(!it.group("Two").simple);
  CHECK(!it.group("Needs").simple);
}

TEST_CASE("a group is conditional where a provider has `when` or `stay`") {
  const Lowering it(R"(
states:
  Door: {values: [open, closed], external: true}
roots: [Always, Sometimes, Stays]
groups:
  Always: {}
  Sometimes: {providers: [{name: here, when: [Door == open]}, {name: there}]}
  Stays: {providers: [{name: here}, {name: there, when: [Door == open], stay: [Door == closed]}]}
)");
  CHECK(!it.group("Always").conditional);
  CHECK(it.group("Sometimes").conditional);
  CHECK(it.group("Stays").conditional);
}

TEST_CASE("edges can be equal where a requester has two of one priority and something is below one") {
  CHECK(equals("[A, B]", "{needs: [C]}"));
  CHECK(!equals("[A, B]"));                                               // they lead to two groups and no further
  CHECK(!equals("{A: {priority: 1}, B: {priority: 2}}", "{needs: [C]}")); // one goes first
  CHECK(equals("{A: {levels: {low: {priority: 1}, high: {priority: 2}}}, B: {priority: 2}}",
               "{needs: [C]}")); // at one level
}

TEST_CASE("roots can be equal, and roots of two components cannot") {
  const Lowering it(R"(
roots: {A: {priority: 1}, B: {priority: 1}, Apart: {priority: 1}}
groups:
  A: {needs: [Shared]}
  B: {needs: [Shared]}
  Apart: {needs: [Own]}
  Shared: {}
  Own: {}
)");
  CHECK(it.component("A").equals);
  CHECK(!it.component("Apart").equals);
}

TEST_CASE("a component has alternatives where a plan has to pick a provider") {
  const auto alternatives = [](const std::string& leg) {
    const Lowering it("roots: [Walk]\ngroups:\n  Walk: {needs: [Leg]}\n  Leg: " + leg + "\n");
    return it.component("Walk").alternatives;
  };
  CHECK(!alternatives("{}"));
  CHECK(alternatives("{providers: [{name: left}, {name: right}]}"));
}

TEST_CASE("the traits of all behaviours of the project are those of their definitions") {
  std::size_t files = 0, with_equals = 0;
  for (const char* folder : {"tests/conformance", "behaviours"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(director::tests::source_dir() / folder)) {
      const std::string path = entry.path().string();
      if (!path.ends_with(".yaml") || path.find(".scenario.") != std::string::npos) continue;
      dsl::DiskFiles disk;
      dsl::Sources sources;
      const dsl::ReadResult read = dsl::read_behaviour(path, disk, sources);
      if (dsl::has_errors(read.diagnostics)) continue; // a part of another, or made to be refused
      const Resolved resolved = resolve(read.spec, sources);
      if (dsl::has_errors(resolved.findings)) continue;
      INFO(path);
      const Lowered lowered = lower(resolved.model);
      const Tables t = lowered.view();
      ++files;
      for (Index g = 0; g < t.groups.size(); ++g) {
        INFO(resolved.model.groups[GroupId{g}].name.value);
        CHECK(t.groups[g].simple == is_simple(t, g));
        CHECK(t.groups[g].conditional == is_conditional(t, g));
      }
      for (Index c = 0; c < t.components.size(); ++c) {
        INFO("component " << c);
        CHECK(t.components[c].equals == has_equals(t, c));
        CHECK(t.components[c].alternatives == has_slots(t, c));
        with_equals += t.components[c].equals ? 1 : 0;
      }
    }
  }
  CHECK(files >= 30);
  CHECK(with_equals >= 5);
}
