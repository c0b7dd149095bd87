#pragma once
// SPDX-License-Identifier: MIT
// Strong ids of the things of a Model, and tables with a typed index. An id is the place in declaration order, which is
// also the order that decides ties at run time.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace director::compiler {

template <class Tag>
struct Id {
  std::uint32_t value = 0;
  auto operator<=>(const Id&) const = default;
};

using GroupId = Id<struct GroupTag>;
using ProviderId = Id<struct ProviderTag>;
using StateId = Id<struct StateTag>;
using ConditionId = Id<struct ConditionTag>;
using EdgeId = Id<struct EdgeTag>;
using TriggerId = Id<struct TriggerTag>;
using ModuleId = Id<struct ModuleTag>;
using LayerId = Id<struct LayerTag>;

/// A vector whose index is an id.
template <class IdType, class T>
class IdTable {
public:
  IdTable() = default;
  explicit IdTable(std::size_t count) : rows_(count) {}
  IdTable(std::size_t count, const T& value) : rows_(count, value) {}

  IdType add(T row) {
    rows_.push_back(std::move(row));
    return IdType{static_cast<std::uint32_t>(rows_.size() - 1)};
  }
  T& operator[](IdType id) { return rows_[id.value]; }
  const T& operator[](IdType id) const { return rows_[id.value]; }
  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  auto begin() { return rows_.begin(); }
  auto end() { return rows_.end(); }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }
  /// Every id of the table, in order: `for (GroupId g : model.groups.ids())`.
  std::vector<IdType> ids() const {
    std::vector<IdType> out;
    out.reserve(rows_.size());
    for (std::uint32_t i = 0; i < rows_.size(); ++i) out.push_back(IdType{i});
    return out;
  }
  bool operator==(const IdTable&) const = default;

private:
  std::vector<T> rows_;
};

/// Some of the ids of a table.
template <class IdType>
class IdSet {
public:
  IdSet() = default;
  explicit IdSet(std::size_t count) : has_(count, false) {}

  bool contains(IdType id) const { return has_[id.value]; }
  /// True if it was not in the set before.
  bool add(IdType id) {
    if (has_[id.value]) return false;
    has_[id.value] = true;
    return true;
  }
  bool operator==(const IdSet&) const = default;

private:
  std::vector<bool> has_;
};

} // namespace director::compiler

template <class Tag>
struct std::hash<director::compiler::Id<Tag>> {
  std::size_t operator()(director::compiler::Id<Tag> id) const noexcept { return id.value; }
};
