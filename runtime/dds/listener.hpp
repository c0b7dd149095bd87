#pragma once
// SPDX-License-Identifier: MIT
// The receiving half of a bridge: a thread takes the samples of others, posts the states in the plan and new requests,
// and answers the requests.

#include "runtime/dds/entity.hpp"
#include "runtime/dds/notes.hpp"
#include "runtime/dds/once.hpp"
#include "runtime/dds/plan.hpp"
#include "runtime/dds/reply.hpp"

#include <atomic>
#include <deque>
#include <thread>

namespace director::dds {

class Listener {
public:
  Listener(const Entity& participant, const SettingsView& settings, const Plug& plug, const Plan& plan, Notes& notes,
           std::uint64_t session);
  ~Listener();

private:
  void listen();
  void report_incompatible(const Entity& reader, const char* what);
  void receive_member(const Member& sample, const dds_sample_info_t& info);
  void receive_state(const State& sample, const dds_sample_info_t& info);
  void post_value(const State& sample, const Taken& taken);
  void post(const Taken& taken, std::int32_t value, std::string_view robot);
  void receive_request(const Request& sample, const dds_sample_info_t& info);
  Reply carry_out(const Request& sample);
  void answer(const Request& sample, Reply reply);
  void report_bad(std::string_view robot, const std::string& what);

  struct Known {
    std::deque<std::uint64_t> sessions; ///< heard so far, the latest that came new last
    bool there = false;
  };

  const SettingsView& settings_;
  const Plug& plug_;
  const Plan& plan_;
  Notes& notes_;
  const std::uint64_t session_;
  const std::string specification_;
  Entity members_, states_, requests_; // readers
  Entity answers_;                     // a writer
  Entity waiting_, stop_;
  std::map<std::array<std::string, 2>, Known> known_;
  Once once_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

} // namespace director::dds
