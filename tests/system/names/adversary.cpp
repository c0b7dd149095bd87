// Header: tests/system/names/adversary.hpp. Test: tests/system/names/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/system/names/adversary.hpp"

#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <array>
#include <random>

namespace director::tests {

const char* const adversary_types = R"(struct Speed { int value; };
struct Row { int value; };
struct Task { int value; };
struct Facts { int value; };
struct Given { int value; };
struct Behaviour { int value; };
enum class Table { a, b };
enum class Module { a, b };
namespace types {
struct Speed { int value; };
struct Task { int value; };
enum class Phase { a, b };
template <class T> struct Box { T value; };
} // namespace types
)";

namespace {

constexpr std::array data{"int",
                          "Speed",
                          "Row",
                          "Task",
                          "Facts",
                          "Given",
                          "Behaviour",
                          "::types::Speed",
                          "::types::Task",
                          "::types::Box<Speed>",
                          "std::array<int, 3>",
                          "const char*",
                          "::types::Box<const Row*>"};
constexpr std::array enums{"Table", "Module", "::types::Phase"};

bool is_refused(const std::string& word) {
  return dsl::is_cpp_keyword(word) || dsl::is_reserved_in_cpp(word) || dsl::is_cpp_macro(word);
}

class Adversary {
public:
  Adversary(std::uint32_t number, const std::vector<std::string>& words)
      : number_(number),
        random_(number),
        words_(words) {
    // With many colliding names one would certainly be refused: most are harmless, so that the others are tested.
    for (std::uint32_t i = below(3); i < 3; ++i) evil_.insert(evil_.end(), below(places));
  }

  std::string text() {
    std::string name_space = fmt::format("t{}", number_);
    if (below(4) == 0) name_space += "::" + word();
    if (below(6) == 0) name_space = outermost() + "::" + name_space;
    const std::string state = name("State"), range = name("range"), typed = name("Typed"), trigger = name("trigger");
    const std::string value = name("one"), walk = name("walk"), legs = name("Legs"), arms = name("Arms");
    const std::string fast = name("fast"), slow = name("Slow"), pack = name("attack"), other = name("Retreat");
    const std::string level = name("low"), urgent = name("High"), module = name("motion"), limbs = name("Limbs");
    return fmt::format(R"(behaviour: b{}
language: 1
cpp: {{namespace: "{}"}}
states:
  {}: {{values: [{}, other], initial: other, external: true}}
  {}: {{range: [0, 9], initial: 0}}
  {}: {{type: "{}", values: [a, b], initial: a, external: true}}
triggers: [{}]
roots: {{{}: {{priority: {{{}: 1, {}: 2}}}}}}
groups:
  {}:
    module: {}
    data: "{}"
    start: {{sets: [{}]}}
    stop: true
    uses: [{}]
    providers:
      - name: {}
        when: [{} == {}]
        triggers: [{}]
        sets: [{}]
        packs: {{{}: {{{}: {{}}, {}: {{optional: true}}}}, {}: {{}}}}
      - {{name: {}, every: 1 s, tasks: [{}]}}
  {}: {{module: {}, data: "{}"}}
  {}: {{module: {}}}
)",
                       number_, name_space, state, value, range, typed, pick(enums), trigger, walk, level, urgent, walk,
                       module, pick(data), range, legs, fast, state, value, trigger, range, pack, legs, arms, other,
                       slow, legs, legs, limbs, pick(data), arms, module);
  }

private:
  static constexpr std::uint32_t places = 16;

  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
  template <class All>
  std::string pick(const All& all) {
    return all[below(static_cast<std::uint32_t>(all.size()))];
  }
  /// With its first letter unchanged, or in the other case.
  std::string word() {
    // Most words are refused at any place; the others test more.
    std::string out = pick(words_);
    for (int tries = below(8) == 0 ? 0 : 50; tries > 0 && is_refused(out); --tries) out = pick(words_);
    if (below(3) == 0 && out[0] >= 'A' && out[0] <= 'Z') out[0] = static_cast<char>(out[0] - 'A' + 'a');
    return out;
  }
  /// Without the names of the existing types.
  /// Not `wait`: behaviours may be called so, although sys/wait.h declares it (compiler/checks/reserved_name.md).
  std::string outermost() {
    std::string out = word();
    while (out == "wait" || std::string_view(adversary_types).find(" " + out + " {") != std::string_view::npos)
      out = word();
    return out;
  }
  std::string name(const std::string& harmless) {
    const std::uint32_t at = at_++;
    for (const std::uint32_t evil : evil_) {
      if (evil != at) continue;
      // Sometimes the name of another one.
      last_ = !last_.empty() && below(3) == 0 ? last_ : word();
      return last_;
    }
    return harmless;
  }

  std::uint32_t number_, at_ = 0;
  std::mt19937 random_;
  const std::vector<std::string>& words_;
  std::vector<std::uint32_t> evil_;
  std::string last_;
};

} // namespace

std::string adversarial_behaviour(std::uint32_t number, const std::vector<std::string>& words) {
  return Adversary(number, words).text();
}

} // namespace director::tests
