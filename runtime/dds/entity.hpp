#pragma once
// SPDX-License-Identifier: MIT
// The C library of Cyclone DDS, with owners and types. Errors: a Failure with the message of the library.

#include "runtime/dds/messages.h"
#include "runtime/dds/settings.hpp"
#include "runtime/hosted/background_thread.hpp"

#include <dds/dds.h>

#include <array>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace director::dds {

using Member = director_msgs_msg_dds__Member_;
using State = director_msgs_msg_dds__State_;
using DecisionSample = director_msgs_msg_dds__Decision_;
using PromiseSample = director_msgs_msg_dds__Promise_;
using Request = director_msgs_msg_dds__Request_;
using Answer = director_msgs_msg_dds__Answer_;
using Stamp = builtin_interfaces_msg_dds__Time_;

/// A background thread.
template <class Work>
std::thread started(Work work) {
  try {
    return background_thread(std::move(work));
  } catch (const std::system_error& problem) {
    throw Failure("dds: a thread cannot be started: " + problem.code().message());
  }
}

/// A handle of the library. Its owner deletes it, with all that belongs to it.
class Entity {
public:
  Entity() = default;
  /// `handle`: the result of the library; below 0 it is an error of `what`.
  Entity(dds_entity_t handle, const std::string& what);
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity();
  dds_entity_t get() const { return handle_; }

private:
  dds_entity_t handle_ = 0;
};

Entity join(std::uint32_t domain);
void check(dds_return_t answer, const std::string& what);

/// A writer of the topic of the type, with its quality (qualities.hpp). `say_again`: the period in which a state is
/// repeated.
template <class Sample>
Entity make_writer(const Entity& participant, std::chrono::milliseconds say_again = std::chrono::milliseconds(100));
template <class Sample>
Entity make_reader(const Entity& participant);

/// False: the middleware did not take it.
template <class Sample>
bool write(const Entity& writer, const Sample& sample) {
  return dds_write(writer.get(), &sample) == DDS_RETCODE_OK;
}

/// A text of a sample to write, which the library only reads.
inline char* text(const std::string& of) { return const_cast<char*>(of.c_str()); }

/// Calls each(sample, info) for all samples received, and removes them. Without valid data only the keys are set.
template <class Sample, class Each>
void take(const Entity& reader, Each&& each) {
  constexpr std::size_t at_once = 32;
  for (;;) {
    std::array<void*, at_once> samples{};
    std::array<dds_sample_info_t, at_once> infos{};
    const dds_return_t count = dds_take(reader.get(), samples.data(), infos.data(), at_once, at_once);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      each(*static_cast<const Sample*>(samples[i]), infos[i]);
    dds_return_loan(reader.get(), samples.data(), count);
  }
}

Stamp now();
std::uint64_t new_session();

} // namespace director::dds
