#pragma once
// SPDX-License-Identifier: MIT
// A Spec whose places are all the same, so that the content of two Specs can be compared. A leaf that is forgotten here
// makes the comparison of equal Specs fail.

#include "dsl/spec.hpp"

namespace director::dsl {

Spec without_places(Spec spec);

} // namespace director::dsl
