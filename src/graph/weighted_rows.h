// SPDX-License-Identifier: BSD-3-Clause
// The rows of an error that its Ω does not leave out.
#pragma once

#include "boxplus/graph/information.h"

namespace boxplus {

/// Whether a row of Ω is not zero.
bool is_weighted(const detail::InformationView& omega, int row);
int weighted_rows(const detail::InformationView& omega);

/// Whether a row of the error belongs to the structure of the problem: if it is weighted, or if no row is,
/// because then the whole edge may come back, as a disabled edge may.
bool is_structural(const detail::InformationView& omega, int row);
int structural_rows(const detail::InformationView& omega);

}  // namespace boxplus
