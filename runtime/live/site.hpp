#pragma once
// SPDX-License-Identifier: MIT
// The addresses behind the token: `/` is the page, `/events` all events, `/why` the reasons why groups wait;
// `/request`, `/cancel`, `/cancel_all` and `/set` take commands by POST. Every error says what to do.

#include "runtime/core/inspect/why.hpp"
#include "runtime/live/commands.hpp"
#include "runtime/live/http.hpp"
#include "runtime/live/moments.hpp"
#include "runtime/live/page.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::live {

class Site {
public:
  /// `names`: those of this computer.
  Site(const Names& names, std::optional<Page> page, std::string token, std::vector<std::string> own_names);

  /// `moment`: the newest one; `until`: the time up to which it lasted, which is that of the answers to `why`.
  Reply answer(const Request& request, const Moment& moment, Time until) const;

  /// May be called from any thread.
  void allow(Commands commands);

private:
  Reply look(std::string_view what, const Request& request, const Moment& moment, Time until) const;
  Reply why(const Request& request, const Moment& moment, Time until) const;
  Reply command(std::string_view what, const Request& request) const;
  Reply request_task(const Request& request) const;
  Reply cancel_task(const Request& request) const;
  Reply set_state(const Request& request) const;
  std::optional<Index> root_edge(const Request& request, Reply& problem) const;

  const Names names_;
  std::shared_ptr<const std::string> page_; ///< null: there is no page
  std::string policy_, token_;
  std::vector<std::string> own_names_;
  mutable std::mutex mutex_;
  Commands commands_;
};

} // namespace director::live
