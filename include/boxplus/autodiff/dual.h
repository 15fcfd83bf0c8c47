// SPDX-License-Identifier: BSD-3-Clause
// Dual numbers with their arithmetic, their functions, and support for Eigen.
#pragma once

#include "boxplus/autodiff/dual_eigen.h"
#include "boxplus/autodiff/dual_functions.h"
#include "boxplus/autodiff/dual_number.h"
#include "boxplus/autodiff/dual_trigonometry.h"
