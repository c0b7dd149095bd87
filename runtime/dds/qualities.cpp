// Header: runtime/dds/qualities.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/qualities.hpp"

namespace director::dds {

namespace {

// The longest wait for the network, and only of threads of the bridge.
constexpr dds_duration_t blocked_at_most = DDS_MSECS(50);
// The time after which a process that is gone is detected. Robots rely on `expires`, not on this.
constexpr dds_duration_t lease = DDS_SECS(1);
// A request that arrives later is not carried out any more.
constexpr dds_duration_t request_lives = DDS_SECS(1);
// A robot that joins gets a state that is overdue by up to this many periods.
constexpr int periods_overdue = 5;

/// A reliable quality that keeps the last `depth` samples of each key.
Quality reliable(std::int32_t depth, dds_durability_kind_t durability) {
  Quality quality(dds_create_qos());
  dds_qset_reliability(quality.get(), DDS_RELIABILITY_RELIABLE, blocked_at_most);
  dds_qset_history(quality.get(), DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_durability(quality.get(), durability);
  dds_qset_durability_service(quality.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  dds_qset_destination_order(quality.get(), DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP);
  // Instances are disposed explicitly when a bridge ends, and not when its process is killed.
  dds_qset_writer_data_lifecycle(quality.get(), false);
  dds_qset_ignorelocal(quality.get(), DDS_IGNORELOCAL_PARTICIPANT);
  constexpr dds_data_representation_id_t plain = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(quality.get(), 1, &plain);
  return quality;
}

} // namespace

template <>
Quality reader_quality<Member>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality reader_quality<State>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality reader_quality<DecisionSample>() {
  return reliable(256, DDS_DURABILITY_VOLATILE);
}
template <>
Quality reader_quality<PromiseSample>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality reader_quality<Request>() {
  return reliable(64, DDS_DURABILITY_VOLATILE);
}
template <>
Quality reader_quality<Answer>() {
  return reliable(64, DDS_DURABILITY_VOLATILE);
}

template <>
Quality writer_quality<Member>(std::chrono::milliseconds) {
  Quality quality = reader_quality<Member>();
  dds_qset_liveliness(quality.get(), DDS_LIVELINESS_AUTOMATIC, lease);
  return quality;
}
template <>
Quality writer_quality<State>(std::chrono::milliseconds say_again) {
  Quality quality = reader_quality<State>();
  dds_qset_liveliness(quality.get(), DDS_LIVELINESS_AUTOMATIC, lease);
  dds_qset_lifespan(quality.get(), periods_overdue * DDS_MSECS(say_again.count()));
  return quality;
}
template <>
Quality writer_quality<DecisionSample>(std::chrono::milliseconds) {
  return reader_quality<DecisionSample>();
}
template <>
Quality writer_quality<PromiseSample>(std::chrono::milliseconds) {
  return reader_quality<PromiseSample>();
}
template <>
Quality writer_quality<Request>(std::chrono::milliseconds) {
  Quality quality = reader_quality<Request>();
  dds_qset_lifespan(quality.get(), request_lives);
  return quality;
}
template <>
Quality writer_quality<Answer>(std::chrono::milliseconds) {
  return reader_quality<Answer>();
}

} // namespace director::dds
