// Header: tests/browser/CMakeLists.txt. Test: tests/browser/live.mjs.
// SPDX-License-Identifier: MIT
//
// live_program [flood | unshown | hang]: a courier that never gets through the door, so that it waits as long as
// somebody looks. `flood`: more happens than its queue has place for. `unshown`: the program shows no moment, and its
// first events are not kept. `hang`: it soon takes no step any more. Ends with its standard input.
#include "courier_page.hpp"
#include "runtime/live/live_view.hpp"
#include "tests/system/api/office.hpp"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

int main(int count, char** values) {
  using namespace director::tests;
  using namespace std::chrono_literals;
  const bool flood = count > 1 && std::string_view(values[1]) == "flood";
  const bool unshown = count > 1 && std::string_view(values[1]) == "unshown";
  director::LiveView::Options options{.html = director::pages::courier(), .queue = flood ? 256U : 65'536U};
  const bool hangs = count > 1 && std::string_view(values[1]) == "hang";
  if (unshown) options.memory = 1;
  director::LiveView view{courier::names::all(), options};
  if (!view.good()) {
    std::fprintf(stderr, "live_program: %s\n", view.error().c_str());
    return EXIT_FAILURE;
  }
  Plans plans;
  plans.deliver = [](courier::Deliver::Default& run) { return run.enter(courier::Open{}, courier::Walk{{}}); };
  plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Walk{{}}, courier::Sing{}); };
  Skills skills;
  courier::Behaviour behaviour{plans, skills, view.observer()};
  view.allow_commands(behaviour.post());
  behaviour.request<courier::Rest>();
  behaviour.request(courier::Deliver{{}});
  (void)behaviour.enable<courier::Open::Unlocking>(false);
  pollfd end{STDIN_FILENO, POLLIN, 0};
  const auto begin = std::chrono::steady_clock::now();
  for (int turn = 0; poll(&end, 1, 10) == 0; ++turn) {
    if (turn == (unshown ? 50 : 0)) {
      std::printf("%s\n", view.url().c_str());
      std::fflush(stdout);
    }
    if (hangs && turn > 200) continue;
    const int bells = flood && turn % 200 == 199 ? 5000 : turn % 10 == 0 ? 1 : 0;
    for (int i = 0; i < bells; ++i) {
      (void)behaviour.fire<courier::Bell>();
      behaviour.step(std::chrono::steady_clock::now() - begin);
    }
    behaviour.step(std::chrono::steady_clock::now() - begin);
    if (!unshown) view.show(behaviour);
  }
}
