#pragma once
// SPDX-License-Identifier: MIT
// A list of limited size, in place: a pass makes some dozens of them, and allocating each one would take longer than
// filling it.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>

namespace director::analysis {

template <class T, std::size_t most>
class Few {
public:
  Few() = default;
  Few(std::initializer_list<T> all) : size_(all.size()) {
    assert(size_ <= most);
    std::copy(all.begin(), all.end(), all_.begin());
  }

  void push_back(const T& one) {
    assert(size_ < most);
    all_[size_++] = one;
  }
  void erase(T* at) {
    std::copy(at + 1, end(), at);
    --size_;
  }
  void clear() { size_ = 0; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return all_[i]; }
  const T& operator[](std::size_t i) const { return all_[i]; }
  const T& front() const { return all_[0]; }
  const T& back() const { return all_[size_ - 1]; }
  bool operator<(const Few& other) const {
    return std::lexicographical_compare(begin(), end(), other.begin(), other.end());
  }
  T* begin() { return all_.data(); }
  T* end() { return all_.data() + size_; }
  const T* begin() const { return all_.data(); }
  const T* end() const { return all_.data() + size_; }

private:
  std::array<T, most> all_; ///< of which only the used part was ever written
  std::size_t size_ = 0;
};

} // namespace director::analysis
