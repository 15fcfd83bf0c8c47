// SPDX-License-Identifier: BSD-3-Clause
// Eigen types whose layout does not depend on compiler flags: use these in public value types and interfaces.
#pragma once

#include <Eigen/Core>

#include "boxplus/base/abi.h"

namespace boxplus {

inline constexpr int kDynamic = Eigen::Dynamic;

/// Column-major matrix without alignment requirement (row-major if Eigen demands it: one row, several
/// columns).
template <class Scalar, int Rows, int Cols>
using Matrix =
    Eigen::Matrix<Scalar, Rows, Cols,
                  Eigen::DontAlign | ((Rows == 1 && Cols != 1) ? Eigen::RowMajor : Eigen::ColMajor)>;

/// Column vector without alignment requirement.
template <class Scalar, int Size>
using Vector = Matrix<Scalar, Size, 1>;

/// Points and directions of the plane and of space.
using Vector2 = Vector<double, 2>;
using Vector3 = Vector<double, 3>;

}  // namespace boxplus
