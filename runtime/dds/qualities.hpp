#pragma once
// SPDX-License-Identifier: MIT
// The quality of service of each kind of sample. README.md has a table with the reasons.

#include "runtime/dds/entity.hpp"

#include <memory>

namespace director::dds {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Quality = std::unique_ptr<dds_qos_t, DeleteQos>;

/// The quality of a writer. `say_again`: the period of states.
template <class Sample>
Quality writer_quality(std::chrono::milliseconds say_again);

/// The quality of a reader: no more than it needs, so that other software may offer less where that does no harm.
template <class Sample>
Quality reader_quality();

} // namespace director::dds
