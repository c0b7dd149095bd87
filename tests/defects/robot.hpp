#pragma once
// SPDX-License-Identifier: MIT
// A behaviour in the making: its files as documents, and what stands in them, so that a defect can be planted on
// purpose. Wherever a word begins with `@`, a finding is expected there; `render` takes the sign away.

#include "tests/defects/flow.hpp"
#include "tests/property/random.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace director::defects {

using property::Random;

struct File {
  std::string path;
  Node node;
};

enum class SenseKind { plain, number, sentinel, expiring, unset };

/// A state that the outside sets.
struct Sense {
  std::string name;
  SenseKind kind = SenseKind::plain;
  std::vector<std::string> values; ///< of a number none
};

/// A skill that can come to rest, and another one, on the same part, that waits for that.
struct Pair {
  std::string resting, delicate, part;
  std::string state, rest;
};

struct Planner {
  std::string name;
  std::vector<std::size_t> parts;
};

/// A path and a line, from 1.
struct Mark {
  std::string path;
  std::size_t line = 0;
  auto operator<=>(const Mark&) const = default;
};

using Texts = std::map<std::string, std::string>;

class Robot {
public:
  std::vector<File> files; ///< the first one is checked
  std::vector<std::string> parts;
  std::vector<bool> whole;                      ///< of each part: it has a left and a right one
  std::vector<std::vector<std::string>> skills; ///< of each part: those that never wait
  std::vector<std::string> choosing;            ///< those of them with several providers, the last one unconditional
  std::vector<Sense> senses;
  std::vector<Pair> pairs;
  std::vector<Planner> planners;
  std::vector<std::string> purposes;              ///< roots with several providers, the last one unconditional
  std::string owned, owner;                       ///< a state of a group
  std::string inner;                              ///< a state of the robot's own: first, second or never
  std::vector<std::function<void(Texts&)>> edits; ///< of the texts, for what is no document any more
  int block_depth = 6;

  explicit Robot(Random& random) : r(random) {}

  Random& r;

  /// A part of a file, such as `groups`.
  Node& section(std::size_t file, const std::string& key);
  Node* find(const std::string& section, const std::string& name);
  Node& group(const std::string& name);
  Node& state(const std::string& name);
  /// In one of the files.
  Node& add_group(const std::string& name, std::string_view text, const std::vector<std::string>& words = {});
  Node& add_state(const std::string& name, std::string_view text, const std::vector<std::string>& words = {});
  void add_root(const std::string& name, int priority);
  /// A priority above, or below, that of every root so far.
  int above() { return high_ += 10; }
  int below() { return low_ -= 10; }
  /// The providers of a group; the group itself where it writes the words of its only one.
  std::vector<Node*> providers(const std::string& group);
  /// Of a planner: with the packs that it has.
  Node& add_pack(const std::string& planner, const std::string& name);

  std::string name(const std::string& stem); ///< that nothing has so far
  std::string verb();
  std::string noun();
  const Sense& sense(SenseKind kind);
  std::size_t part() { return r.below(parts.size()); }
  std::size_t whole_part();   ///< one with a left and a right one
  std::size_t skilled_part(); ///< one with two skills at least
  /// A new part.
  std::string add_part();
  /// A new skill that needs and requests a group.
  std::string add_skill(const std::string& on);

  /// The texts, and where findings are expected.
  Texts render(std::vector<Mark>& marks) const;

private:
  std::vector<std::string> used_;
  int high_ = 200, low_ = -100;
};

/// Without defects, errors and warnings. `size` from 0, as small as it may be, to 4; below 0: two files and nothing
/// else.
void grow(Robot& robot, int size);

/// A condition that some values satisfy and others do not, without a finding.
std::string condition(Random& random, const Sense& sense);

} // namespace director::defects
