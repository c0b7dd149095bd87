#pragma once
// SPDX-License-Identifier: MIT
// Random orders of events in the life of a program: its behaviour is edited, its C++ is edited, stubs are written. Each
// order depends on its number alone, and so does each of its steps: if some are left out, the others are unchanged.

#include "compiler/stubs/insertion.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/wanted.hpp"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace director::tests {

class Order {
public:
  /// The program as it is at first.
  explicit Order(unsigned number);

  /// An edit by the user of the behaviour or of the C++, a step of its own.
  void edit(int step);
  /// The steps after the beginning: 1, 2 ...
  const std::vector<int>& steps() const { return steps_; }

  const compiler::stubs::Wanted& wanted() const { return wanted_; }
  const compiler::stubs::Texts& texts() const { return texts_; }
  std::string yaml() const;
  /// The program, from now on.
  void adopt(compiler::stubs::Texts texts) { texts_ = std::move(texts); }

  /// Continues like `directorc stubs` with what was found; a text for each fault: a byte of the user's that is gone or
  /// has moved, an existing file that is written anew.
  std::vector<std::string> carry_out(const compiler::stubs::Merge& merge);

private:
  struct Group {
    std::string name;
    int module = 0;
    bool start = false, stop = false;
    std::vector<std::string> providers; ///< none: one without a name
  };

  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool chance(int percent) { return pick(100) < percent; }
  std::string fresh_name(const char* prefix) { return prefix + std::to_string(++names_); }

  void edit_behaviour();
  void edit_code();
  void write_module_by_hand();
  std::string noise();
  std::string layout(std::string text);
  void edit_function(std::string& text, const compiler::stubs::FoundFunction& row);
  void put_noise(const std::string& path);
  void move_definition(const compiler::stubs::FoundFunction& row);
  void renew_wanted();

  unsigned number_;
  std::mt19937 random_;
  std::vector<int> steps_;
  int names_ = 0;
  std::vector<Group> groups_;
  compiler::stubs::Wanted wanted_;
  compiler::stubs::Texts texts_;
};

/// A minimal failing set of the steps: each is left out if the rest still fails.
std::vector<int> shrunk(std::vector<int> steps, const std::function<bool(const std::vector<int>&)>& fails);

/// The behaviour and the C++ of an order, for debugging.
std::string to_text(const Order& order);

/// A minimal header, equivalent to the generated one for these tests.
std::string small_header(const compiler::stubs::Wanted& wanted);

} // namespace director::tests
