// SPDX-License-Identifier: MIT
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"
#include "tests/support/golden.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
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

// The traits computed pair by pair from their definition: of edges of one requester, of levels, of groups.

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
  const std::vector<Index> of_a = urgencies(t, a), of_b = urgencies(t, b);
  return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

/// The target of the edge, and all below it.
std::set<Index> led_to(const Tables& t, Index edge) {
  std::set<Index> out{t.edges[edge].target};
  for (std::size_t before = 0; before != out.size();) {
    before = out.size();
    for (const director::Edge& row : t.edges) {
      if (row.requester != nil && out.contains(row.requester)) out.insert(row.target);
    }
  }
  return out;
}

/// The groups that both of two possibly equal edges lead to.
std::set<Index> of_equals(const Tables& t) {
  std::set<Index> out;
  for (Index a = 0; a < t.edges.size(); ++a) {
    for (Index b = 0; b < a; ++b) {
      if (!may_be_equal(t, a, b)) continue;
      const std::set<Index> by_a = led_to(t, a), by_b = led_to(t, b);
      std::set_intersection(by_a.begin(), by_a.end(), by_b.begin(), by_b.end(), std::inserter(out, out.end()));
    }
  }
  std::erase_if(out, [&](Index group) { return t.groups[group].requesters.size() < 2; }); // they are one edge
  return out;
}

/// One of these, or a group that needs one, transitively.
bool needs_one_of(const Tables& t, Index group, const std::set<Index>& groups, std::set<Index> above = {}) {
  if (groups.contains(group)) return true;
  above.insert(group);
  const director::Group& row = t.groups[group];
  for (Index p = row.providers.begin; p != row.providers.end; ++p) {
    for (const Index need : t.list(t.providers[p].needs)) {
      const Index below = t.edges[need].target;
      if (!above.contains(below) && needs_one_of(t, below, groups, above)) return true;
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

TEST_CASE("a group has equals where two tasks of one requester and one priority lead to it") {
  const auto has_equals = [](const std::string& tasks, const std::string& b = "{needs: [Shared]}") {
    const Lowering it("roots: [Boss]\ngroups:\n  Boss: {tasks: " + tasks + "}\n  A: {tasks: [Shared, Own]}\n  B: " + b +
                      "\n  Shared: {tasks: [Below]}\n" + "  Own: {}\n  Below: {}\n");
    CHECK(!it.group("Boss").equals);
    CHECK(!it.group("A").equals);
    CHECK(!it.group("Own").equals);
    CHECK(!it.group("Below").equals);                           // only Shared requests it
    CHECK(it.group("B").deniable == it.group("Shared").equals); // needs it
    CHECK(!it.group("A").deniable);                             // only requests it
    return it.group("Shared").equals;
  };
  CHECK(has_equals("[A, B]"));
  CHECK(!has_equals("{A: {priority: 1}, B: {priority: 2}}"));                                      // one goes first
  CHECK(has_equals("{A: {levels: {low: {priority: 1}, high: {priority: 2}}}, B: {priority: 2}}")); // at one level
}

TEST_CASE("a group that is requested directly, and by way of a task of the same priority, has equals") {
  const Lowering it("roots: [Boss]\ngroups:\n  Boss: {tasks: [A, Shared]}\n  A: {needs: [Shared]}\n  Shared: {}\n");
  CHECK(it.group("Shared").equals);
  CHECK(it.group("A").deniable);
}

TEST_CASE("two tasks of one priority that lead to nothing in common make no equals") {
  const Lowering it("roots: [Boss]\ngroups:\n  Boss: {tasks: [A, B]}\n  A: {needs: [C]}\n  B: {}\n  C: {}\n");
  for (const director::Group& group : it.lowered.groups) CHECK_FALSE((group.equals || group.deniable));
}

TEST_CASE("roots can be equal, also if a cycle of requests is below them") {
  const Lowering it(R"(
roots: {A: {priority: 1}, B: {priority: 1}, Apart: {priority: 1}}
groups:
  A: {tasks: [Shared]}
  B: {tasks: [Shared]}
  Apart: {needs: [Own]}
  Shared: {tasks: {B: {priority: 1}, Last: {priority: 2}}}
  Own: {}
  Last: {}
)");
  CHECK(!it.group("A").equals);
  CHECK(it.group("B").equals);
  CHECK(it.group("Shared").equals);
  CHECK(!it.group("Last").equals); // only Shared requests it
  CHECK(!it.group("Apart").deniable);
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
      if (dsl::has_errors(read.diagnostics)) continue; // a part of another file, or made to be refused
      const Resolved resolved = resolve(read.spec, sources);
      if (dsl::has_errors(resolved.findings)) continue;
      INFO(path);
      const Lowered lowered = lower(resolved.model);
      const Tables t = lowered.view();
      ++files;
      const std::set<Index> equals = of_equals(t);
      with_equals += equals.empty() ? 0 : 1;
      for (Index g = 0; g < t.groups.size(); ++g) {
        INFO(resolved.model.groups[GroupId{g}].name.value);
        CHECK(t.groups[g].simple == is_simple(t, g));
        CHECK(t.groups[g].conditional == is_conditional(t, g));
        CHECK(t.groups[g].equals == equals.contains(g));
        CHECK(t.groups[g].deniable == needs_one_of(t, g, equals));
      }
      for (Index c = 0; c < t.components.size(); ++c) {
        INFO("component " << c);
        CHECK(t.components[c].alternatives == has_slots(t, c));
      }
    }
  }
  CHECK(files >= 30);
  CHECK(with_equals >= 5);
}
