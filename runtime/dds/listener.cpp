// Header: runtime/dds/listener.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/listener.hpp"

#include <algorithm>

namespace director::dds {

namespace {

// Far more than a team has, so that invented names cannot fill the memory.
constexpr std::size_t most_members = 256;
constexpr std::size_t most_sessions = 16; // of one member

bool is_name(const char* text) {
  const std::string_view name(text);
  return !name.empty() && name.size() <= longest_name;
}

} // namespace

Listener::Listener(const Entity& participant, const SettingsView& settings, const Plug& plug, const Plan& plan,
                   Notes& notes, std::uint64_t session)
    : settings_(settings),
      plug_(plug),
      plan_(plan),
      notes_(notes),
      session_(session),
      specification_(specification_of(plug)),
      members_(make_reader<Member>(participant)),
      states_(make_reader<State>(participant)),
      requests_(make_reader<Request>(participant)),
      answers_(make_writer<Answer>(participant)),
      waiting_(dds_create_waitset(participant.get()), "a waitset"),
      stop_(dds_create_guardcondition(participant.get()), "a guard condition") {
  for (const Entity* one : {&members_, &states_, &requests_, &stop_})
    check(dds_waitset_attach(waiting_.get(), one->get(), 0), "the waitset");
  thread_ = started([this] { listen(); });
}

Listener::~Listener() {
  stopping_ = true;
  dds_set_guardcondition(stop_.get(), true);
  thread_.join();
}

void Listener::listen() {
  while (!stopping_) {
    dds_waitset_wait(waiting_.get(), nullptr, 0, DDS_INFINITY);
    take<Member>(members_, [this](const Member& sample, const auto& info) { receive_member(sample, info); });
    take<State>(states_, [this](const State& sample, const auto& info) { receive_state(sample, info); });
    take<Request>(requests_, [this](const Request& sample, const auto& info) { receive_request(sample, info); });
    report_incompatible(members_, "members");
    report_incompatible(states_, "states");
    report_incompatible(requests_, "requests");
  }
}

void Listener::report_incompatible(const Entity& reader, const char* what) {
  dds_requested_incompatible_qos_status_t status{};
  dds_get_requested_incompatible_qos_status(reader.get(), &status);
  if (status.total_count_change != 0)
    notes_.report_once(Notice::Kind::incompatible, "",
                       std::string("somebody says ") + what +
                           " with a quality of service that is not enough, and is not heard (policy " +
                           std::to_string(status.last_policy_id) + ")");
}

void Listener::report_bad(std::string_view robot, const std::string& what) {
  notes_.count(&Counts::bad_samples);
  notes_.report_once(Notice::Kind::bad_sample, robot, what);
}

void Listener::receive_member(const Member& sample, const dds_sample_info_t& info) {
  if (!is_name(sample.robot) || !is_name(sample.behaviour))
    return report_bad(sample.robot, "a member without a proper name");
  const std::array<std::string, 2> key{sample.robot, sample.behaviour};
  if (known_.size() >= most_members && !known_.contains(key)) return report_bad(sample.robot, "one member too many");
  Known& known = known_[key];
  const std::string what = "the behaviour " + shown(sample.behaviour);
  if (info.valid_data) {
    // Members are repeated, also by two processes with one name in turn: only what is new is reported.
    const bool first = known.sessions.empty();
    const bool is_new = std::ranges::find(known.sessions, sample.session) == known.sessions.end();
    if (is_new) known.sessions.push_back(sample.session);
    if (known.sessions.size() > most_sessions) known.sessions.pop_front();
    if (is_new && plug_.behaviour == sample.behaviour && settings_.robot == sample.robot && sample.session != session_)
      notes_.report(Notice::Kind::twin, sample.robot,
                    "another process says that it is this robot with " + what + "; both are heard as one");
    if (first) {
      notes_.report(Notice::Kind::joined, sample.robot, what + " is there");
    } else if (is_new) {
      notes_.report(Notice::Kind::restarted, sample.robot, what + " was started again");
    } else if (!known.there) {
      notes_.report(Notice::Kind::joined, sample.robot, what + " is heard again");
    }
    if (is_new && plug_.behaviour == sample.behaviour && specification_ != sample.specification)
      notes_.report(Notice::Kind::other_specification, sample.robot,
                    what + " decides otherwise there: its specification is " + shown(sample.specification) +
                        ", here it is " + specification_);
    known.there = true;
  }
  if (info.instance_state == DDS_IST_ALIVE || !known.there) return;
  known.there = false;
  const bool goodbye = info.instance_state == DDS_IST_NOT_ALIVE_DISPOSED;
  notes_.report(goodbye ? Notice::Kind::gone : Notice::Kind::lost, sample.robot,
                what + (goodbye ? " said goodbye" : " is not heard any more"));
}

void Listener::receive_state(const State& sample, const dds_sample_info_t& info) {
  if (!is_name(sample.robot) || !is_name(sample.behaviour) || !is_name(sample.state))
    return report_bad(sample.robot, "a state without a proper name");
  const auto found = plan_.taken.find({sample.robot, sample.behaviour, sample.state});
  if (found == plan_.taken.end()) return;
  for (const Taken& taken : found->second) {
    if (info.valid_data) post_value(sample, taken);
    // A disposed state has its value after `expires` immediately.
    // One of a process that is not heard any more keeps its value until `expires`.
    if (info.instance_state == DDS_IST_NOT_ALIVE_DISPOSED && taken.silent != unset)
      post(taken, taken.silent, sample.robot);
  }
}

void Listener::post_value(const State& sample, const Taken& taken) {
  std::optional<std::int32_t> value;
  switch (sample.kind) {
  case 0: return; // no value: the state here changes only by its `expires`
  case 1: value = number_of(taken, std::string_view(sample.name)); break;
  case 2: value = number_of(taken, sample.number); break;
  default:
    return report_bad(sample.robot,
                      "the state " + shown(sample.state) + " comes as something that is neither a name nor a number");
  }
  if (value) return post(taken, *value, sample.robot);
  notes_.count(&Counts::unknown_values);
  notes_.report_once(Notice::Kind::unknown_value, sample.robot,
                     "the state " + shown(sample.state) + " is " +
                         (sample.kind == 1 ? shown(sample.name) : std::to_string(sample.number)) + ", a value that " +
                         plug_.names.state(taken.state) + " does not have; it stays as it is");
}

/// If the inbox is full, the value waits in the state's overflow slot, where it may replace one that no step has taken.
void Listener::post(const Taken& taken, std::int32_t value, std::string_view robot) {
  const std::uint32_t lost = plug_.engine->lost();
  if (plug_.set(taken.state, value)) notes_.count(&Counts::states_heard);
  if (plug_.engine->lost() == lost) return;
  notes_.count(&Counts::inbox_full);
  notes_.report_once(Notice::Kind::inbox_full, robot,
                     std::string("inputs were lost, because the inbox had no room, as ") +
                         plug_.names.state(taken.state) + " arrived" + ": is the behaviour stepped often enough?");
}

void Listener::receive_request(const Request& sample, const dds_sample_info_t& info) {
  if (!info.valid_data || settings_.robot != sample.robot || plug_.behaviour != sample.behaviour) return;
  if (!is_name(sample.asker) || sample.asker_session == 0 || sample.number == 0 || sample.kind > 1 ||
      !is_name(sample.task) || std::string_view(sample.level).size() > longest_name ||
      sample.data._length > longest_data)
    return report_bad(sample.asker, "a request that cannot be meant");
  if (sample.session != 0 && sample.session != session_) return answer(sample, Reply::another_session);
  const Once::Seen seen = once_.look(sample.asker_session, sample.number);
  switch (seen.verdict) {
  case Once::Verdict::too_old: return answer(sample, Reply::too_old);
  case Once::Verdict::repeated:
    notes_.count(&Counts::requests_repeated);
    return answer(sample, static_cast<Reply>(seen.answer));
  case Once::Verdict::first: break;
  }
  const Reply reply = carry_out(sample);
  once_.note(sample.asker_session, sample.number, static_cast<std::uint8_t>(reply));
  notes_.count(reply == Reply::taken ? &Counts::requests_taken : &Counts::requests_refused);
  if (reply != Reply::taken)
    notes_.report_once(Notice::Kind::refused, sample.asker,
                       (sample.kind == 1 ? "cancel " : "request ") + shown(sample.task) + ": " + to_text(reply));
  answer(sample, reply);
}

Reply Listener::carry_out(const Request& sample) {
  const auto found = plan_.offered.find(std::string_view(sample.task));
  if (found == plan_.offered.end()) return Reply::unknown_task;
  const Offered& offered = found->second;
  const bool cancel = sample.kind == 1;
  bool taken = false;
  if (offered.take) {
    const auto* data = reinterpret_cast<const std::byte*>(sample.data._buffer);
    try {
      taken = offered.take(
          {.asker = sample.asker, .cancel = cancel, .level = sample.level, .data = {data, sample.data._length}});
    } catch (...) { // an exception of the program's function must not leave this thread, which is the bridge's
    }
  } else if (cancel) {
    taken = plug_.cancel(offered.edge);
  } else if (*sample.level == 0 && sample.data._length == 0) {
    taken = plug_.request(offered.edge, plug_.tables().edges[offered.edge].levels.begin);
  }
  return taken ? Reply::taken : Reply::refused;
}

void Listener::answer(const Request& sample, Reply reply) {
  const Answer answer{.asker = sample.asker,
                      .asker_session = sample.asker_session,
                      .number = sample.number,
                      .robot = text(settings_.robot),
                      .behaviour = text(plug_.behaviour),
                      .session = session_,
                      .reply = static_cast<std::uint8_t>(reply)};
  if (!write(answers_, answer)) notes_.count(&Counts::not_written);
}

} // namespace director::dds
