// Header: tests/bench/grown_cases.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/grown_cases.hpp"

#include "tests/bench/by_hand.hpp"
#include "tests/bench/table_robot.hpp"
#include "tests/bench/texts.hpp"

#include <stdexcept>

namespace bench {

using director::Index;

namespace {

void expect(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

class Waiting {
public:
  explicit Waiting(std::size_t tasks) : robot_(compile_text(waiting(tasks)), 64) {
    for (std::size_t i = 1; i <= tasks; ++i) {
      robot_.post(robot_.request(robot_.root("Waiting_" + std::to_string(i))));
      robot_.step();
    }
    low_ = high_ = robot_.request(robot_.root("Left"));
    ++high_.value;
    robot_.post(low_);
    robot_.post(robot_.request(robot_.root("Right")));
    robot_.step();
    once();
    const std::uint64_t before = calls();
    once();
    expect(calls() == before + 2, "a steal is two runs");
  }
  void once() {
    is_high_ = !is_high_;
    robot_.post(is_high_ ? high_ : low_);
    robot_.step();
  }
  std::uint64_t calls() const { return robot_.calls(); }

private:
  TableRobot robot_;
  director::Input low_, high_;
  bool is_high_ = false;
};

class Apart {
public:
  explicit Apart(std::size_t groups) : robot_(compile_text(apart(groups)), 1024) {
    for (std::size_t i = 1; i <= groups; ++i) {
      all_.push_back(robot_.request(robot_.root("Task_" + std::to_string(i))));
      all_.back().more = i < groups;
    }
    once();
    expect(calls() == groups, "each runs once");
  }
  void once() {
    robot_.post(all_);
    robot_.step();
  }
  std::uint64_t calls() const { return robot_.calls(); }

private:
  TableRobot robot_;
  std::vector<director::Input> all_;
};

class Together {
public:
  explicit Together(std::size_t groups) : robot_(compile_text(together(groups)), 64) {
    all_ = robot_.request(robot_.root("All"));
    once();
    expect(calls() == groups + 1, "each runs once");
  }
  void once() {
    robot_.post(all_);
    robot_.step();
  }
  std::uint64_t calls() const { return robot_.calls(); }

private:
  TableRobot robot_;
  director::Input all_;
};

template <Input input>
class ByHand {
public:
  explicit ByHand(std::size_t providers) : robot_(build_by_hand(providers)) {}
  void once() {
    which_ ^= 1;
    take(robot_, input, which_);
  }
  std::uint64_t calls() const { return robot_.calls; }

private:
  std::size_t which_ = 0;
  Robot robot_;
};

class AllAndOne : public ByHand<Input::all> {
public:
  explicit AllAndOne(std::size_t groups) : ByHand(groups + 1) {}
};

} // namespace

void add_grown_cases(std::vector<Entry>& entries) {
  struct Size {
    std::size_t size;
    const char* aim = "linear";
  };
  const auto add = [&](const std::string& family, const char* title, std::initializer_list<Size> sizes,
                       std::size_t counted, auto director, auto by_hand) {
    const std::size_t smallest = sizes.begin()->size;
    for (const auto& [size, aim] : sizes) {
      Entry entry;
      entry.name = family + "/" + std::to_string(size);
      entry.title = title + (": " + std::to_string(size));
      if (size != smallest) entry.aim = aim;
      entry.counted = counted;
      entry.director = director;
      entry.by_hand = by_hand;
      entry.size = size;
      if (size != smallest) entry.grows_from = family + "/" + std::to_string(smallest);
      entries.push_back(entry);
    }
  };
  add("waiting", "steal of a group, tasks that wait for it", {{1}, {10}, {1'000, "5,000"}}, 10, make_sized<Waiting>,
      [](std::size_t) -> std::unique_ptr<Case> {
        return std::make_unique<Repeated<ByHand<Input::steal>>>(std::size_t{3});
      });
  add("apart", "root tasks, all requested at once", {{10}, {100}, {1'000}}, 20, make_sized<Apart>,
      make_sized<ByHand<Input::all>>);
  add("together", "tasks of one provider, all requested at once", {{10}, {100}, {1'000}}, 20, make_sized<Together>,
      make_sized<AllAndOne>);
}

} // namespace bench
