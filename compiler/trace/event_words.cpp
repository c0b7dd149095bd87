// Header: compiler/trace/event_words.hpp. Test: tests/compiler/trace/event_words_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/event_words.hpp"

#include "compiler/base/seconds.hpp"
#include "runtime/core/api/event_names.hpp"
#include "runtime/hosted/trace/event_text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace director::compiler {

namespace {

using Kind = Event::Kind;

class Words {
public:
  Words(const Event& event, const director::Names& names) : e_(event), n_(names) {}

  std::string all() const {
    const std::string text = to_text(e_, n_);
    return text.empty() ? rest() : text;
  }

  std::string time() const { return fmt::format(", at {} s", in_seconds(e_.time)); }
  std::string step_time() const { return fmt::format(", in the step of {} s", in_seconds(e_.until)); }
  std::string micro_step() const { return fmt::format(", in micro-step {}", e_.micro_step); }
  std::string level() const {
    if (e_.level == nil || is_limbo(e_.edge)) return {};
    const std::string_view name = n_.level(n_.self, e_.level);
    if (!name.empty()) return fmt::format(", level {}", name);
    return fmt::format(", level {} of its list", e_.level - n_.tables->edges[e_.edge].levels.begin + 1);
  }
  std::string provider() const {
    return e_.provider == nil ? ", by a handler" : fmt::format(", by {}", n_.provider(n_.self, e_.provider));
  }
  std::string edge() const { return e_.edge == nil ? ", for no task" : ", for " + task(e_.edge); }
  std::string other() const { return e_.other == nil ? ", before for no task" : ", before for " + task(e_.other); }
  std::string condition() const {
    return e_.condition == nil ? ", for no condition" : fmt::format(", for {}", n_.condition(n_.self, e_.condition));
  }

private:
  bool is_limbo(Index edge) const { return edge >= n_.tables->edges.size(); }
  std::string task(Index edge) const { return is_limbo(edge) ? "what comes after it" : n_.edge(n_.self, edge); }
  std::string group() const { return e_.group == nil ? "" : n_.group(n_.self, e_.group); }
  /// `Drive.rolling`; without the provider if it is the group's direct one.
  std::string full() const {
    const std::string_view provider = e_.provider == nil ? "" : n_.provider(n_.self, e_.provider);
    return provider.empty() || provider == "default" ? group() : fmt::format("{}.{}", group(), provider);
  }
  std::string value() const {
    if (e_.value == unset) return "no value";
    const std::string_view name = n_.value(n_.self, e_.state, e_.value);
    return name.empty() ? std::to_string(e_.value) : std::string(name);
  }

  /// The text of events that `simulate` does not print.
  std::string rest() const {
    switch (e_.kind) {
    case Kind::grant: return grant();
    case Kind::lose:
      return e_.other == nil ? "lose " + group() : fmt::format("lose {}, held for {}", group(), task(e_.other));
    case Kind::ask:
    case Kind::keep:
    case Kind::withdraw: return fmt::format("{} {}", name_of(e_.kind), task(e_.edge));
    case Kind::wait:
      if (e_.due == never) return fmt::format("wait {}: for no time", group());
      return fmt::format("wait {}: until {} s", group(), in_seconds(e_.due));
    case Kind::answer:
      if (e_.outcome == Outcome::Kind::pack) return fmt::format("answer {}: pack {} of its list", full(), e_.pack + 1);
      return fmt::format("answer {}: {}", full(), name_of(e_.outcome));
    case Kind::assign:
    case Kind::given: return fmt::format("{} {} {}", name_of(e_.kind), n_.state(n_.self, e_.state), value());
    case Kind::input: return input();
    default: return name_of(e_.kind);
    }
  }

  std::string grant() const {
    if (is_limbo(e_.edge)) return fmt::format("hold {} for what comes after it", group());
    const std::string in = full() == group() ? "" : " in " + full();
    if (e_.other == nil || is_limbo(e_.other)) return fmt::format("grant {}{}", task(e_.edge), in);
    return fmt::format("hand over {} from {} to {}{}", group(), task(e_.other), task(e_.edge), in);
  }

  std::string input() const {
    if (e_.input == Event::Input::cancel) return "> cancel all";
    if (e_.input == Event::Input::expire) return fmt::format("> expire {}", n_.state(n_.self, e_.state));
    return fmt::format("> {} {}", name_of(e_.input), full());
  }

  const Event& e_;
  const director::Names& n_;
};

} // namespace

std::string words_of(const Event& event, const director::Names& names) { return Words(event, names).all(); }

std::pair<std::string, std::string> words_of_both(const Event& one, const director::Names& names_of_one,
                                                  const Event& other, const director::Names& names_of_other) {
  const Words a(one, names_of_one), b(other, names_of_other);
  std::pair<std::string, std::string> out(a.all(), b.all());
  if (out.first != out.second) return out;
  // The time of a step, only if nothing else distinguishes the two: it differs with everything that comes later.
  using Part = std::string (Words::*)() const;
  for (const Part part : {&Words::level, &Words::provider, &Words::edge, &Words::other, &Words::condition, &Words::time,
                          &Words::micro_step, &Words::step_time}) {
    const std::string of_one = (a.*part)(), of_other = (b.*part)();
    if (of_one == of_other) continue;
    out.first += of_one;
    out.second += of_other;
    return out;
  }
  return out;
}

} // namespace director::compiler
