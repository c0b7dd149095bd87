// Header: compiler/play/data_slots.hpp. Test: tests/compiler/play/data_slots_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/data_slots.hpp"

#include <utility>

namespace director::compiler {

Index DataSlots::wait_for_input(Value value) {
  inputs_.push_back(std::move(value));
  return static_cast<Index>(inputs_.size() - 1);
}

void DataSlots::move(Bodies::Data what, Index edge, Index handle, Index target) {
  switch (what) {
  case Bodies::Data::accept: staging_[edge] = handle == nil ? Value{} : std::move(inputs_[handle]); break;
  case Bodies::Data::settle: edges_[edge] = std::move(staging_[edge]); break;
  case Bodies::Data::retain: groups_[target] = std::move(edges_[edge]); break;
  }
}

const DataSlots::Value& DataSlots::at(DataPlace place) const {
  switch (place.slot) {
  case DataPlace::Slot::edge: return edges_[place.index];
  case DataPlace::Slot::staging: return staging_[place.index];
  case DataPlace::Slot::group: break;
  }
  return groups_[place.index];
}

} // namespace director::compiler
