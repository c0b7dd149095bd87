// SPDX-License-Identifier: MIT
#include "compiler/play/data_slots.hpp"

#include <catch2/catch.hpp>

using director::Bodies;
using director::DataPlace;
using director::nil;
using director::compiler::DataSlots;

namespace {

DataSlots::Value data(const std::string& text) {
  director::dsl::Data out;
  out.text = text;
  return out;
}

} // namespace

TEST_CASE("data of an input go to the staging slot of its edge, then to the edge's own") {
  DataSlots slots(2, 3);
  const director::Index first = slots.wait_for_input(data("one")), second = slots.wait_for_input(data("two"));
  slots.move(Bodies::Data::accept, 1, second, 0);
  CHECK(slots.at({DataPlace::Slot::staging, 1}) == data("two"));
  CHECK(slots.at({DataPlace::Slot::edge, 1}) == DataSlots::Value{});
  slots.move(Bodies::Data::settle, 1, nil, 0);
  CHECK(slots.at({DataPlace::Slot::edge, 1}) == data("two"));
  slots.move(Bodies::Data::accept, 1, first, 0);
  slots.move(Bodies::Data::settle, 1, nil, 0);
  CHECK(slots.at({DataPlace::Slot::edge, 1}) == data("one"));
}

TEST_CASE("an input without data empties the slot") {
  DataSlots slots(2, 3);
  slots.stage(2, data("old"));
  slots.move(Bodies::Data::accept, 2, nil, 1);
  CHECK(slots.at({DataPlace::Slot::staging, 2}) == DataSlots::Value{});
}

TEST_CASE("a group keeps the data of a request that another one replaces") {
  DataSlots slots(2, 3);
  slots.stage(0, data("old"));
  slots.move(Bodies::Data::settle, 0, nil, 1);
  slots.stage(0, data("new"));
  slots.move(Bodies::Data::retain, 0, nil, 1);
  slots.move(Bodies::Data::settle, 0, nil, 1);
  CHECK(slots.at({DataPlace::Slot::group, 1}) == data("old"));
  CHECK(slots.at({DataPlace::Slot::edge, 0}) == data("new"));
}
