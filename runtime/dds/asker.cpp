// Header: runtime/dds/asker.hpp. Test: tests/runtime/dds/request_test.cpp.
// SPDX-License-Identifier: MIT
//
// A request names the session of the robot that it is for. A robot that was restarted does not know its earlier
// requests, so it does not take a request to the session before: the asker gets that answer, and decides.
#include "runtime/dds/asker.hpp"

#include "runtime/dds/entity.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace director::dds {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto repeat_after = 200ms;

bool is_name(const std::string& text) { return !text.empty() && text.size() <= longest_name; }

/// The end of the patience from now on, limited to the range of the clock.
Clock::time_point end_of(std::chrono::milliseconds patience) {
  const auto now = Clock::now();
  if (patience.count() <= 0) return now;
  const auto most = std::chrono::floor<std::chrono::milliseconds>(Clock::time_point::max() - now);
  return patience < most ? now + patience : Clock::time_point::max();
}

} // namespace

struct Asker::Parts {
  Parts(std::string given, std::uint32_t domain)
      : name(std::move(given)),
        participant(join(domain)),
        members(make_reader<Member>(participant)),
        answers(make_reader<Answer>(participant)),
        requests(make_writer<Request>(participant)),
        waiting(dds_create_waitset(participant.get()), "a waitset") {
    for (const Entity* one : {&members, &answers})
      check(dds_waitset_attach(waiting.get(), one->get(), 0), "the waitset");
  }

  Reply send(const To& to, Request request, std::chrono::milliseconds patience);
  void take_members();
  std::optional<Reply> answer_to(std::uint64_t wanted);

  const std::string name;
  const std::uint64_t session = new_session();
  std::uint64_t number = 0;
  Entity participant, members, answers, requests, waiting;
  std::map<std::array<std::string, 2>, std::uint64_t> sessions;
};

void Asker::Parts::take_members() {
  take<Member>(members, [this](const Member& sample, const dds_sample_info_t& info) {
    const std::array<std::string, 2> key{sample.robot, sample.behaviour};
    if (info.valid_data) sessions[key] = sample.session;
    if (info.instance_state != DDS_IST_ALIVE) sessions.erase(key);
  });
}

std::optional<Reply> Asker::Parts::answer_to(std::uint64_t wanted) {
  std::optional<Reply> found;
  take<Answer>(answers, [&](const Answer& sample, const dds_sample_info_t& info) {
    if (info.valid_data && name == sample.asker && sample.asker_session == session && sample.number == wanted &&
        sample.reply < static_cast<std::uint8_t>(Reply::unanswered))
      found = static_cast<Reply>(sample.reply);
  });
  return found;
}

Reply Asker::Parts::send(const To& to, Request request, std::chrono::milliseconds patience) {
  const auto end = end_of(patience);
  const std::array<std::string, 2> key{to.robot, to.behaviour};
  request.robot = text(to.robot);
  request.behaviour = text(to.behaviour);
  request.asker = text(name);
  request.asker_session = session;
  request.number = ++number;
  auto next = Clock::now();
  for (auto at = next; at < end; at = Clock::now()) {
    take_members();
    if (const auto known = sessions.find(key); request.session == 0 && known != sessions.end())
      request.session = known->second;
    if (request.session != 0 && at >= next) {
      write(requests, request); // if the middleware does not take it, it is repeated
      next = at + repeat_after;
    }
    const auto until = request.session == 0 ? end : std::min(end, next);
    dds_waitset_wait(waiting.get(), nullptr, 0,
                     std::chrono::duration_cast<std::chrono::nanoseconds>(until - Clock::now()).count());
    if (const auto reply = answer_to(request.number)) return *reply;
  }
  return Reply::unanswered;
}

Asker::Asker(std::string name, std::uint32_t domain) {
  if (!is_name(name))
    throw Failure("dds: an asker's name has 1 to " + std::to_string(longest_name) + " bytes, this one has " +
                  std::to_string(name.size()));
  parts_ = std::make_unique<Parts>(std::move(name), domain);
}

Asker::~Asker() = default;

Reply Asker::request(const To& to, const std::string& task, std::chrono::milliseconds patience,
                     const std::string& level, std::span<const std::byte> data) {
  // A robot would not answer such a request.
  if (!is_name(task)) return Reply::unknown_task;
  if (level.size() > longest_name || data.size() > longest_data) return Reply::refused;
  Request request{};
  request.task = text(task);
  request.level = text(level);
  request.data._length = request.data._maximum = static_cast<std::uint32_t>(data.size());
  request.data._buffer = reinterpret_cast<std::uint8_t*>(const_cast<std::byte*>(data.data())); // it is only read
  return parts_->send(to, request, patience);
}

Reply Asker::cancel(const To& to, const std::string& task, std::chrono::milliseconds patience) {
  if (!is_name(task)) return Reply::unknown_task;
  const std::string none;
  Request request{};
  request.kind = 1;
  request.task = text(task);
  request.level = text(none);
  return parts_->send(to, request, patience);
}

const char* to_text(Reply reply) {
  switch (reply) {
  case Reply::taken: return "taken";
  case Reply::unknown_task: return "unknown task";
  case Reply::refused: return "refused";
  case Reply::too_old: return "too old";
  case Reply::another_session: return "meant for another session";
  case Reply::unanswered: return "unanswered";
  }
  return "";
}

} // namespace director::dds
