// SPDX-License-Identifier: BSD-3-Clause
// What the digits of a double can tell about the chordal cost.
#pragma once

#include "certify/chordal_problem.h"

namespace boxplus::certificate {

/// How much the chordal cost may change if estimates and measurements are rounded to double, and the errors
/// of the edges with them: of a rotation by 2 ε, of a translation by ε times the lengths of the positions (in
/// the frame of the graph) and of the measurement. The errors of different edges are independent. If this is
/// more than the tolerance of a proof, then chi2 has too few digits for it.
double rounding_of_cost(const ChordalProblem& problem, const StackedPoses& poses);

/// Whether the poses fit each measurement up to rounding, whatever its weight. Then F is zero but for
/// rounding, and no other poses fit better.
bool fits_exactly(const ChordalProblem& problem, const StackedPoses& poses);

}  // namespace boxplus::certificate
