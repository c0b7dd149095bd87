#pragma once
// SPDX-License-Identifier: MIT
// A small case, done by Director or by hand; workloads of users are in workload.hpp. Used by the benchmark, which
// measures time, and by count_instructions, which counts.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bench {

class Case {
public:
  virtual ~Case() = default;
  virtual void run(std::size_t times) = 0;
  virtual std::uint64_t calls() const = 0; ///< provider calls so far
};

/// `It` has once() and calls().
template <class It>
class Repeated final : public Case {
public:
  template <class... Given>
  explicit Repeated(Given... given) : it_(given...) {}
  void run(std::size_t times) override {
    for (; times > 0; --times) {
      it_.once();
      asm volatile("" ::: "memory");
    }
  }
  std::uint64_t calls() const override { return it_.calls(); }

private:
  It it_;
};

struct Entry {
  std::string name;           ///< `trees/1000`
  std::string title;          ///< for the report
  std::string aim;            ///< ns, or a limit of growth; empty: none
  std::size_t counted = 1000; ///< repetitions in count_instructions; 0: it takes too long there
  std::unique_ptr<Case> (*director)(std::size_t size) = nullptr;
  std::unique_ptr<Case> (*by_hand)(std::size_t size) = nullptr;
  std::size_t size = 0;   ///< of a case that grows
  std::string grows_from; ///< the entry with which it is compared
};

/// All cases, in the order of the page.
const std::vector<Entry>& entries();

template <class It>
std::unique_ptr<Case> make(std::size_t) {
  return std::make_unique<Repeated<It>>();
}
template <class It>
std::unique_ptr<Case> make_sized(std::size_t size) {
  return std::make_unique<Repeated<It>>(size);
}

} // namespace bench
