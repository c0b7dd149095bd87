// Header: runtime/dds/entity.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/entity.hpp"

#include "runtime/dds/qualities.hpp"

#include <chrono>
#include <random>

namespace director::dds {

namespace {

struct Topic {
  const char* name; ///< the name that ROS 2 gives to /director/...
  const dds_topic_descriptor_t* type;
};
template <class Sample>
constexpr Topic topic_of{};
template <>
constexpr Topic topic_of<Member>{"rt/director/member", &director_msgs_msg_dds__Member__desc};
template <>
constexpr Topic topic_of<State>{"rt/director/state", &director_msgs_msg_dds__State__desc};
template <>
constexpr Topic topic_of<DecisionSample>{"rt/director/decision", &director_msgs_msg_dds__Decision__desc};
template <>
constexpr Topic topic_of<PromiseSample>{"rt/director/promise", &director_msgs_msg_dds__Promise__desc};
template <>
constexpr Topic topic_of<Request>{"rt/director/request", &director_msgs_msg_dds__Request__desc};
template <>
constexpr Topic topic_of<Answer>{"rt/director/answer", &director_msgs_msg_dds__Answer__desc};

/// Deleted with its participant.
template <class Sample>
dds_entity_t make_topic(const Entity& participant) {
  constexpr Topic topic = topic_of<Sample>;
  const dds_entity_t made = dds_create_topic(participant.get(), topic.type, topic.name, nullptr, nullptr);
  check(made, std::string("the topic ") + topic.name);
  return made;
}

} // namespace

Entity::Entity(dds_entity_t handle, const std::string& what) : handle_(handle) {
  if (handle < 0) check(std::exchange(handle_, 0), what);
}

Entity::~Entity() {
  if (handle_ > 0) dds_delete(handle_);
}

void check(dds_return_t answer, const std::string& what) {
  if (answer < 0) throw Failure("dds: " + what + " cannot be had: " + dds_strretcode(answer));
}

Entity join(std::uint32_t domain) {
  constexpr std::uint32_t highest = 232; // its ports are the last that exist
  if (domain > highest)
    throw Failure("dds: there is no domain " + std::to_string(domain) + "; the highest is " + std::to_string(highest));
  dds_entity_t handle =
      0; // made in a background thread, because the library's own threads are like that which starts them
  started([&] { handle = dds_create_participant(domain, nullptr, nullptr); }).join();
  if (handle < 0)
    throw Failure("dds: no way into domain " + std::to_string(domain) + ": " + dds_strretcode(handle) +
                  ". Is the network there that CYCLONEDDS_URI names, and not every participant's port taken?");
  return {handle, "a participant"};
}

template <class Sample>
Entity make_writer(const Entity& participant, std::chrono::milliseconds say_again) {
  const Quality quality = writer_quality<Sample>(say_again);
  return {dds_create_writer(participant.get(), make_topic<Sample>(participant), quality.get(), nullptr),
          std::string("a writer of ") + topic_of<Sample>.name};
}

template <class Sample>
Entity make_reader(const Entity& participant) {
  const Quality quality = reader_quality<Sample>();
  Entity reader{dds_create_reader(participant.get(), make_topic<Sample>(participant), quality.get(), nullptr),
                std::string("a reader of ") + topic_of<Sample>.name};
  check(dds_set_status_mask(reader.get(), DDS_DATA_AVAILABLE_STATUS | DDS_REQUESTED_INCOMPATIBLE_QOS_STATUS),
        "what a reader wakes for");
  return reader;
}

template Entity make_writer<Member>(const Entity&, std::chrono::milliseconds);
template Entity make_writer<State>(const Entity&, std::chrono::milliseconds);
template Entity make_writer<DecisionSample>(const Entity&, std::chrono::milliseconds);
template Entity make_writer<PromiseSample>(const Entity&, std::chrono::milliseconds);
template Entity make_writer<Request>(const Entity&, std::chrono::milliseconds);
template Entity make_writer<Answer>(const Entity&, std::chrono::milliseconds);
template Entity make_reader<Member>(const Entity&);
template Entity make_reader<State>(const Entity&);
template Entity make_reader<DecisionSample>(const Entity&);
template Entity make_reader<PromiseSample>(const Entity&);
template Entity make_reader<Request>(const Entity&);
template Entity make_reader<Answer>(const Entity&);

Stamp now() {
  using namespace std::chrono;
  const auto since = system_clock::now().time_since_epoch();
  const auto whole = duration_cast<seconds>(since);
  return {.sec = static_cast<std::int32_t>(whole.count()),
          .nanosec = static_cast<std::uint32_t>(duration_cast<nanoseconds>(since - whole).count())};
}

std::uint64_t new_session() {
  std::random_device draw;
  std::uint64_t session = 0;
  while (session == 0) session = (std::uint64_t{draw()} << 32) | draw();
  return session;
}

} // namespace director::dds
