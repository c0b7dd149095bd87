// Header: runtime/dds/qualities.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/qualities.hpp"

namespace director::dds {

namespace {

// Nobody waits for the network longer than that, and only threads of the bridge do.
constexpr dds_duration_t blocked_at_most = DDS_MSECS(50);
// A process that is gone is known to be after that. Robots count on `expires`, not on this.
constexpr dds_duration_t lease = DDS_SECS(1);
// A request that comes later than that is not obeyed any more.
constexpr dds_duration_t request_lives = DDS_SECS(1);
// A state may be that many times overdue and still be told to who joins.
constexpr int sayings = 5;

/// Reliable, of the last `depth` samples of each key.
Quality reliable(std::int32_t depth, dds_durability_kind_t durability) {
  Quality quality(dds_create_qos());
  dds_qset_reliability(quality.get(), DDS_RELIABILITY_RELIABLE, blocked_at_most);
  dds_qset_history(quality.get(), DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_durability(quality.get(), durability);
  dds_qset_durability_service(quality.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  dds_qset_destination_order(quality.get(), DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP);
  // Whoever ends says so itself. A process that is gone did not say goodbye.
  dds_qset_writer_data_lifecycle(quality.get(), false);
  dds_qset_ignorelocal(quality.get(), DDS_IGNORELOCAL_PARTICIPANT);
  constexpr dds_data_representation_id_t plain = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(quality.get(), 1, &plain);
  return quality;
}

} // namespace

template <>
Quality quality_to_ask_for<Member>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality quality_to_ask_for<State>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality quality_to_ask_for<DecisionSample>() {
  return reliable(256, DDS_DURABILITY_VOLATILE);
}
template <>
Quality quality_to_ask_for<PromiseSample>() {
  return reliable(1, DDS_DURABILITY_TRANSIENT_LOCAL);
}
template <>
Quality quality_to_ask_for<Request>() {
  return reliable(64, DDS_DURABILITY_VOLATILE);
}
template <>
Quality quality_to_ask_for<Answer>() {
  return reliable(64, DDS_DURABILITY_VOLATILE);
}

template <>
Quality quality_to_offer<Member>(std::chrono::milliseconds) {
  Quality quality = quality_to_ask_for<Member>();
  dds_qset_liveliness(quality.get(), DDS_LIVELINESS_AUTOMATIC, lease);
  return quality;
}
template <>
Quality quality_to_offer<State>(std::chrono::milliseconds say_again) {
  Quality quality = quality_to_ask_for<State>();
  dds_qset_liveliness(quality.get(), DDS_LIVELINESS_AUTOMATIC, lease);
  dds_qset_lifespan(quality.get(), sayings * DDS_MSECS(say_again.count()));
  return quality;
}
template <>
Quality quality_to_offer<DecisionSample>(std::chrono::milliseconds) {
  return quality_to_ask_for<DecisionSample>();
}
template <>
Quality quality_to_offer<PromiseSample>(std::chrono::milliseconds) {
  return quality_to_ask_for<PromiseSample>();
}
template <>
Quality quality_to_offer<Request>(std::chrono::milliseconds) {
  Quality quality = quality_to_ask_for<Request>();
  dds_qset_lifespan(quality.get(), request_lives);
  return quality;
}
template <>
Quality quality_to_offer<Answer>(std::chrono::milliseconds) {
  return quality_to_ask_for<Answer>();
}

} // namespace director::dds
