// Header: runtime/hosted/decision_printer.hpp. Test: tests/runtime/hosted/decision_printer_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/hosted/decision_printer.hpp"

#include "runtime/core/api/event_names.hpp"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstring>
#include <string_view>
#include <utility>

namespace director {

namespace {

constexpr std::int64_t per_second = 1'000'000;
constexpr std::size_t written_at_once = 1000; ///< most lines are shorter

class Line {
public:
  /// Cut off if it does not fit.
  explicit Line(std::span<char> buffer) : buffer_(buffer) { buffer_[0] = '\0'; }
  /// Written to `out` whenever the buffer is full. `beginning` comes first, unless nothing follows.
  Line(std::span<char> buffer, std::FILE* out, std::string_view beginning) : Line(buffer) {
    out_ = out;
    beginning_ = beginning;
  }

  Line& operator<<(std::string_view text) {
    if (!text.empty() && !beginning_.empty()) *this << std::exchange(beginning_, {});
    while (!text.empty()) {
      const std::size_t size = std::min(text.size(), buffer_.size() - 1 - size_);
      std::copy_n(text.data(), size, buffer_.data() + size_);
      size_ += size;
      buffer_[size_] = '\0';
      text.remove_prefix(size);
      if (!text.empty() && out_ == nullptr) break;
      if (!text.empty()) write();
    }
    return *this;
  }
  Line& operator<<(std::int32_t number) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%" PRId32, number);
    return *this << std::string_view(text.data());
  }

  void write() {
    std::fwrite(buffer_.data(), 1, size_, out_);
    size_ = 0;
  }
  bool is_empty() const { return size_ == 0; }

private:
  std::span<char> buffer_;
  std::size_t size_ = 0;
  std::FILE* out_ = nullptr;
  std::string_view beginning_{};
};

class EventText {
public:
  EventText(const Event& event, const Names& names, Line& line) : e_(event), n_(names), line_(line) {}

  void write() {
    switch (e_.kind) {
    case Event::Kind::input: return input();
    case Event::Kind::run: return run();
    case Event::Kind::start:
    case Event::Kind::stop:
    case Event::Kind::done:
    case Event::Kind::failed:
    case Event::Kind::release: line_ << name_of(e_.kind) << " " << n_.group(n_.self, e_.group); return;
    case Event::Kind::broken: named("broken ").short_name(); return;
    case Event::Kind::queue: queue(); return;
    case Event::Kind::push:
      named("push ").long_name();
      line_ << " for " << n_.edge(n_.self, e_.edge);
      return;
    case Event::Kind::set:
      if (e_.value == unset) {
        line_ << "unset " << n_.state(n_.self, e_.state);
      } else {
        line_ << "set " << n_.state(n_.self, e_.state) << " ";
        value();
      }
      return;
    case Event::Kind::refused: // a scenario ends here; a robot continues
      line_ << "refused " << n_.state(n_.self, e_.state) << " ";
      value();
      return;
    case Event::Kind::fault: named("fault ").long_name(); return;
    case Event::Kind::exhausted: line_ << "budget_exhausted"; return;
    case Event::Kind::lost: // a scenario loses none
      line_ << "lost " << static_cast<std::int32_t>(e_.count < 0x7fffffff ? e_.count : 0x7fffffff)
            << (e_.count == 1 ? " input" : " inputs");
      return;
    case Event::Kind::grant:
    case Event::Kind::lose:
    case Event::Kind::ask:
    case Event::Kind::keep:
    case Event::Kind::withdraw:
    case Event::Kind::wait:
    case Event::Kind::answer:
    case Event::Kind::assign:
    case Event::Kind::begin:
    case Event::Kind::given: return;
    }
  }

private:
  EventText& named(std::string_view word) {
    line_ << word;
    return *this;
  }

  /// `Drive.braking`; a handler's group alone.
  void long_name() {
    line_ << n_.group(n_.self, e_.group);
    if (e_.provider != nil) line_ << "." << n_.provider(n_.self, e_.provider);
  }

  /// Without the provider if the group declares it directly.
  void short_name() {
    line_ << n_.group(n_.self, e_.group);
    const char* provider = n_.provider(n_.self, e_.provider);
    if (std::strcmp(provider, "default") != 0) line_ << "." << provider;
  }

  void value() {
    const std::string_view name = n_.value(n_.self, e_.state, e_.value);
    if (name.empty())
      line_ << e_.value;
    else
      line_ << name;
  }

  void run() {
    named("run ").short_name();
    std::string_view between = " ";
    for (const Reason reason : all_reasons) {
      if (!e_.reasons.has(reason)) continue;
      line_ << between << name_of(reason);
      between = "+";
    }
  }

  void queue() {
    line_ << "queue " << n_.edge(n_.self, e_.edge) << ": " << name_of(e_.why);
    if (e_.why == Why::waiting && e_.condition != nil) line_ << " for " << n_.condition(n_.self, e_.condition);
  }

  /// The first level, that of a request without a level, is not printed.
  void request() {
    const bool is_first = n_.tables != nullptr && e_.level != nil && n_.tables->edges[e_.edge].levels.begin == e_.level;
    const char* const level = n_.level == nullptr || e_.level == nil || is_first ? "" : n_.level(n_.self, e_.level);
    line_ << "> request ";
    if (*level == '\0')
      line_ << n_.group(n_.self, e_.group);
    else
      line_ << "{" << n_.group(n_.self, e_.group) << ": {level: " << level << "}}";
  }

  void input() {
    switch (e_.input) {
    case Event::Input::request: request(); return;
    case Event::Input::cancel:
      if (e_.group == nil) return; // a cancel of all: one event for each follows
      line_ << "> " << name_of(e_.input) << " " << n_.group(n_.self, e_.group);
      return;
    case Event::Input::set:
      line_ << "> set {" << n_.state(n_.self, e_.state) << ": ";
      value();
      line_ << "}";
      return;
    case Event::Input::fire: line_ << "> trigger " << n_.trigger(n_.self, e_.trigger); return;
    case Event::Input::enable:
    case Event::Input::disable:
      line_ << "> " << name_of(e_.input) << " ";
      long_name();
      return;
    case Event::Input::none:
    case Event::Input::expire:
    case Event::Input::wait:
    case Event::Input::within:
    case Event::Input::every: return; // time passed: the events that follow are printed
    }
  }

  const Event& e_;
  const Names& n_;
  Line& line_;
};

} // namespace

const char* to_text(const Event& event, const Names& names, std::span<char> buffer) {
  Line line(buffer);
  EventText(event, names, line).write();
  return buffer.data();
}

const char* time_text(Time time, std::span<char> buffer) {
  const std::uint64_t size = time < 0 ? 0 - static_cast<std::uint64_t>(time) : static_cast<std::uint64_t>(time);
  const std::uint64_t second = per_second;
  std::array<char, 24> seconds{};
  std::snprintf(seconds.data(), seconds.size(), "%s%" PRIu64, time < 0 ? "-" : "", size / second);
  std::snprintf(buffer.data(), buffer.size(), "[%5s.%06" PRIu64 "] ", seconds.data(), size % second);
  return buffer.data();
}

Observer DecisionPrinter::observer() {
  return {[](void* self, const Event& event) { static_cast<DecisionPrinter*>(self)->tell(event); }, this};
}

void DecisionPrinter::tell(const Event& event) {
  std::array<char, 40> time{};
  std::array<char, written_at_once> buffer{};
  Line line(buffer, out_, times_ == Times::yes ? time_text(event.time, time) : "");
  EventText(event, names_, line).write();
  if (line.is_empty()) return;
  line << "\n";
  line.write();
}

} // namespace director
