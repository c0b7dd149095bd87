// SPDX-License-Identifier: MIT
#include "compiler/graph/components.hpp"
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using namespace director;
using namespace director::compiler;

/// "A B | C": the groups of each component.
std::string components_of(const std::string& text) {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\n" + text);
  const IdTable<GroupId, std::uint32_t> found = find_components(compiled.model);
  const Lowered lowered = lower(compiled.model);
  std::vector<std::string> parts;
  for (const GroupId group : compiled.model.groups.ids()) {
    CHECK(lowered.groups[group.value].component == found[group]);
    if (found[group] == parts.size()) parts.emplace_back();
    std::string& part = parts.at(found[group]);
    part += (part.empty() ? "" : " ") + compiled.model.groups[group].name.value;
  }
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : " | ") + part;
  return out;
}

TEST_CASE("requests and needs join groups into one component") {
  CHECK(components_of("roots: [A, B, C]\ngroups:\n  A: {tasks: [D]}\n  B: {needs: [E]}\n  C: {needs: [E]}\n"
                      "  D: {}\n  E: {}\n") == "A D | B C E");
}

TEST_CASE("a promise joins its group with those that wait for it, by `when` or by `stay`") {
  const std::string states = "states: {Door: {values: [shut, ajar, open], initial: shut, external: true}}\n"
                             "roots: [Open, Enter, Look, Wait]\ngroups:\n  Open: {causing: [Door == open]}\n"
                             "  Enter: {when: [Door >= ajar]}\n  Look: {when: [Door == shut]}\n";
  CHECK(components_of(states + "  Wait: {}\n") == "Open Enter | Look | Wait");
  CHECK(components_of(states + "  Wait: {when: [Door == shut], stay: [Door != ajar]}\n") == "Open Enter Wait | Look");
}

} // namespace
