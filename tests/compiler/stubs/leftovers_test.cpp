// SPDX-License-Identifier: MIT
// The reports about code without a purpose, and the cases without one.
#include "compiler/stubs/leftovers.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler::stubs;

namespace {

using Kind = WantedFunction::Kind;
using Said = std::vector<std::string>;

const Wanted two_modules{"robot",
                         "robot.hpp",
                         "b",
                         {{"legs", "b::Legs", "Legs", "legs", {{Kind::provide, "b::Walk::Default", {}}}},
                          {"eyes", "b::Eyes", "Eyes", "eyes", {{Kind::provide, "b::Look::Default", {}}}}},
                         {}};

FoundFunction function(const std::string& of, const std::string& name, const std::string& context, bool known) {
  FoundFunction out;
  out.of = of;
  out.name = name;
  out.context = context;
  out.place = {"/p/legs.hpp", 7, 9};
  out.known = known;
  out.within = true;
  out.class_place = {"/p/legs.hpp", of == "Legs" ? 3U : 5U, 7};
  return out;
}

/// Beside a class Legs, which implements b::Legs.
Said said(const FoundFunction& row) {
  Found found;
  found.classes = {{"Legs", {"b::Legs"}, {}, {"/p/legs.hpp", 3, 7}, 0, unconditional, true, false, false, {}}};
  found.functions = {row};
  Said out;
  for (const Remark& each : leftovers(two_modules, found)) {
    CHECK(each.place == row.place);
    out.push_back(each.message);
  }
  return out;
}

} // namespace

TEST_CASE("a body that its module requests is no leftover") {
  CHECK(said(function("Legs", "provide", "b::Walk::Default", true)) == Said{});
}

TEST_CASE("a body in a template that any module may be a base of is a leftover only if nothing requests it") {
  FoundFunction row = function("WithWalk", "provide", "b::Walk::Default", true);
  row.overrides = row.for_any = true;
  CHECK(said(row) == Said{});
  row.context = "b::Run::Default";
  row.known = false;
  CHECK(said(row) ==
        Said{"`provide(b::Run::Default&)` of `WithWalk` is left over: robot has no such provider or handler"});
}

TEST_CASE("a body whose provider or handler is gone is a leftover") {
  CHECK(said(function("Legs", "provide", "b::Hop::Default", false)) ==
        Said{"`provide(b::Hop::Default&)` of `Legs` is left over: robot has no such provider or handler"});
  CHECK(said(function("Legs", "start", "b::Walk::Default", true)) ==
        Said{"`start(b::Walk::Default&)` of `Legs` is left over: robot has no such provider or handler"});
}

TEST_CASE("a body whose group belongs to another module now is a leftover, and the module is reported") {
  CHECK(said(function("Legs", "provide", "b::Look::Default", true)) ==
        Said{"`provide(b::Look::Default&)` of `Legs` is left over: it belongs to the module eyes, `b::Eyes`"});
}

TEST_CASE("a function of an implementing class with another parameter is ignored") {
  CHECK(said(function("Legs", "start", "int", true)) == Said{});
  CHECK(said(function("Legs", "stop", "other::Walk::Stop", true)) == Said{});
}

TEST_CASE("a body in a class whose interface is gone is a leftover if it overrides or is outside of its class") {
  FoundFunction row = function("Arms", "provide", "::b::Wave::Default", false);
  CHECK(said(row) == Said{}); // possibly another class
  row.overrides = true;
  const Said expected{"`provide(::b::Wave::Default&)` of `Arms` is left over: robot has no such provider or handler"};
  CHECK(said(row) == expected);
  row.overrides = row.within = false;
  CHECK(said(row) == expected);
  row.context = "c::Wave::Default"; // of another behaviour
  CHECK(said(row) == Said{});
}
