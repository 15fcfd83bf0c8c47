// SPDX-License-Identifier: BSD-3-Clause
// Eigen types whose layout does not depend on compiler flags. Use them in public value types and interfaces.
#pragma once

#include <Eigen/Core>

#include "boxplus/base/abi.h"

namespace boxplus {

inline constexpr int kDynamic = Eigen::Dynamic;

/// A matrix without an alignment requirement. It is column-major, except that Eigen requires row-major order
/// for a matrix of one row and several columns.
template <class Scalar, int Rows, int Cols>
using Matrix =
    Eigen::Matrix<Scalar, Rows, Cols,
                  Eigen::DontAlign | ((Rows == 1 && Cols != 1) ? Eigen::RowMajor : Eigen::ColMajor)>;

/// A column vector without an alignment requirement.
template <class Scalar, int Size>
using Vector = Matrix<Scalar, Size, 1>;

/// Points and directions in the plane and in space.
using Vector2 = Vector<double, 2>;
using Vector3 = Vector<double, 3>;

}  // namespace boxplus
