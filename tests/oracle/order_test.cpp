// SPDX-License-Identifier: MIT
#include "tests/oracle/order.hpp"
#include "tests/oracle/text.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::oracle;

/// Every task is requested at its first level, and held by the edge that is named for it.
class Held {
public:
  explicit Held(const char* text)
      : model_(model_of(text)),
        parts_(model_),
        facts_(model_),
        holders_(model_.groups.size()) {
    for (const EdgeId e : model_.edges.ids()) facts_.request[e] = Request{0, std::nullopt, e.value};
  }
  EdgeId edge(const std::string& name) const {
    for (const EdgeId e : model_.edges.ids()) {
      if (model_.edge_name(e) == name) return e;
    }
    throw std::runtime_error("no edge " + name);
  }
  void hold(const std::string& name) {
    const EdgeId e = edge(name);
    holders_[parts_.target(e)] = director::oracle::Held{e, true, false, false};
  }
  Chain chain(const std::string& name) const { return chain_of(parts_, holders_, edge(name)); }
  Order order() const { return Order(parts_, facts_); }
  Facts& facts() { return facts_; }

private:
  Model model_;
  Parts parts_;
  Facts facts_;
  Holders holders_;
};

constexpr auto family = R"(
behaviour: family
language: 1
roots: {A: {priority: 10}, B: {}}
groups:
  A: {tasks: {C: {optional: true}, D: {}, E: {}}}
  B: {tasks: {F: {}}}
  C: {}
  D: {tasks: {F: {}}}
  E: {}
  F: {}
)";

TEST_CASE("an ancestor goes before what is below it") {
  Held held(family);
  held.hold("root>A");
  CHECK(held.order().before(held.chain("root>A"), held.chain("A>C")));
  CHECK(!held.order().before(held.chain("A>C"), held.chain("root>A")));
}

TEST_CASE("optional tasks go after all mandatory ones, with any priority") {
  Held held(family);
  for (const char* name : {"root>A", "root>B", "A>D"}) held.hold(name);
  CHECK(held.order().before(held.chain("B>F"), held.chain("A>C")));
  CHECK(held.order().before(held.chain("D>F"), held.chain("B>F")));
}

TEST_CASE("siblings of one priority are equal, and in order by stamp, then by declaration") {
  Held held(family);
  held.hold("root>A");
  CHECK(held.order().equal(held.chain("A>D"), held.chain("A>E")));
  CHECK(held.order().first(held.chain("A>D"), held.chain("A>E")));
  held.facts().request[held.edge("A>D")]->stamp = 99;
  CHECK(held.order().first(held.chain("A>E"), held.chain("A>D")));
  held.facts().request[held.edge("A>E")].reset(); // younger than every request
  CHECK(held.order().first(held.chain("A>D"), held.chain("A>E")));
}

} // namespace
