// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "engine/batch_part.h"
#include "engine/hessian_places.h"

namespace g2o {
namespace internal {

/// Finds the places in H and in the gradient to which the edges of a part add, and those to which its sums
/// are added at the end. The sums themselves are stored behind `places.values()` and `places.scalars()`.
/// Returns false if an edge has got another vertex since it was taken.
bool lay_out_targets(const HessianPlaces& places, BatchPart& part);

}  // namespace internal
}  // namespace g2o
