// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/options/options.h"
#include "plan/plan.h"

namespace boxplus {

/// The relative residual to which an iterative linear solver solves. Options::linear_tolerance says why.
double forcing_term(const Options& options, const Plan& plan);

}  // namespace boxplus
