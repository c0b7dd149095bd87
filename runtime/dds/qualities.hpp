#pragma once
// SPDX-License-Identifier: MIT
// The quality of service of each kind of sample, in one place. The reasons stand in README.md, as a table.

#include "runtime/dds/entity.hpp"

#include <memory>

namespace director::dds {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Quality = std::unique_ptr<dds_qos_t, DeleteQos>;

/// Of a writer. `say_again`: of states.
template <class Sample>
Quality quality_to_offer(std::chrono::milliseconds say_again);

/// Of a reader: no more than it takes, so that other software may offer less where that does no harm.
template <class Sample>
Quality quality_to_ask_for();

} // namespace director::dds
