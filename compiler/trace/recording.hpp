#pragma once
// SPDX-License-Identifier: MIT
// A recording in the form that is embedded in a page: small, and read sequentially. compiler/page/web/embedded.ts is
// its other half. The bytes, before they are packed:
//
//   length        4 bytes, the lowest first
//   head          JSON of that length:
//     header        the first line of the trace
//     shapes        each event that differs in more than its time, once, as a line of the trace without its times. Runs
//                   and inputs begin a micro-step, and other events do not; those that differ from this have "begins"
//     texts         answers to why
//     held          of each answer {"group":…,"by":…}: what blocks, and the edge by which it is held; or null
//     begins        the time of the first event, in microseconds
//     events, changes   their numbers
//     why_until     from this event on, counted from 0, the reasons for waiting are unknown ...
//     why_ends      ... and why; absent: they are known everywhere
//   times         of each event, since the one before
//   shapes        of each event, its index
//   events        of each change, since the one before: from which event on
//   groups        of each change: the group whose answer changes
//   answers       of each change: index in the texts, plus 1; 0: it no longer waits
//
// Numbers behind the head have seven bits a byte, the lowest first, each byte but the last with its highest bit set.
// Events that nothing on the page needs are left out: answers and settings of bodies, and which timer was due. One is
// added for Waits::held, {"event":"held","group":…}, and likewise for Waits::stays, Waits::without_effect and
// Waits::in_force.

#include "compiler/base/json.hpp"
#include "compiler/trace/waits.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace director::compiler {

/// Takes events like any format. It has to get all of them, from the line behind the header on.
class Recording final : public TraceFormat {
public:
  /// `names` must have tables, and outlive this. `why_ends`: why nothing is known behind the end of `waits`.
  Recording(const director::Names& names, Waits waits, std::string why_ends);

  void begin(std::string&) override {}
  void event(const Event& event, std::string&) override;
  void dropped(std::uint64_t count, std::string&) override;

  std::size_t events() const { return events_; }
  Time begins() const { return begins_; } ///< of the first event
  Time ends() const { return now_; }      ///< of the last one

  /// The content for a page. `header`: the first line of the trace.
  std::string bytes(const Json& header) const;

private:
  void add(Time time, std::string shape);
  std::string_view begins(const Event& event);
  void add_derived();
  void add_derived(const char* event, const std::vector<Waits::Held>& all, std::size_t& next);
  void add_changes();

  const director::Names names_;
  const Waits waits_;
  const std::string why_ends_;
  std::unordered_map<std::string, std::size_t> shape_of_;
  std::vector<std::string> shapes_;
  std::string times_, places_, change_events_, change_groups_, change_answers_;
  std::optional<std::uint64_t> micro_step_; ///< of the last event that is not left out
  std::size_t line_ = 1, events_ = 0, held_ = 0, stays_ = 0, without_effect_ = 0, in_force_ = 0, changes_ = 0,
              change_event_ = 0, why_until_ = 0;
  Time begins_ = 0, now_ = 0;
};

} // namespace director::compiler
