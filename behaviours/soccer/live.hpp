#pragma once
// SPDX-License-Identifier: MIT
// Shape: a browser that looks at the game, and the time that goes by there. Errors: in words; a program that was built
// without cpp-httplib or without Graphviz has nothing to look at.

#include "behaviours/soccer/arguments.hpp"

#ifdef SOCCER_WITH_LIVE_VIEW
#include "runtime/live/live_view.hpp"
#endif

#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#ifdef SOCCER_WITH_LIVE_VIEW
/// `html`: the page about the behaviour.
inline std::unique_ptr<director::LiveView> live_view(const Arguments& arguments, std::string_view html, std::string& error) {
  if (!arguments.live) return nullptr;
  auto out = std::make_unique<director::LiveView>(soccer::names::all(),
                                                  director::LiveView::Options{.html = html, .port = *arguments.live});
  error = out->error();
  return out;
}
#else
struct NoLiveView {
  void tell(const director::Event&) {}
  void show(const soccer::Behaviour&) {}
  std::string url() const { return {}; }
};
inline std::unique_ptr<NoLiveView> live_view(const Arguments& arguments, std::string_view, std::string& error) {
  if (arguments.live)
    error = "--live is not in this program: it takes cpp-httplib and Graphviz (libcpp-httplib-dev, pkgconf, graphviz); "
            "install them and build again";
  return nullptr;
}
#endif

/// Ctrl-C ends the game, a second one the program.
inline volatile std::sig_atomic_t& stopping() {
  static volatile std::sig_atomic_t stop = 0;
  return stop;
}

/// Waits until the world's time has come: `speed` times as fast as it does on the clock.
class Pace {
public:
  explicit Pace(std::optional<double> speed) : speed_(speed) {
    if (!speed) return;
    std::signal(SIGINT, [](int signal) {
      stopping() = 1;
      std::signal(signal, SIG_DFL);
    });
  }
  void wait_for(std::int64_t milliseconds) const {
    if (speed_) std::this_thread::sleep_until(begin_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(static_cast<double>(milliseconds) / *speed_)));
  }

private:
  using Clock = std::chrono::steady_clock;
  std::optional<double> speed_;
  Clock::time_point begin_ = Clock::now();
};
