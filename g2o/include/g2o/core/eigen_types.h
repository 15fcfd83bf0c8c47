// SPDX-License-Identifier: BSD-3-Clause
// Aliases of Eigen types: the current names and the names that older clients use.
#pragma once
#ifndef G2O_EIGEN_TYPES_H
#define G2O_EIGEN_TYPES_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace g2o {

using number_t = double;

template <int N, typename T = double>
using VectorN = Eigen::Matrix<T, N, 1, Eigen::ColMajor>;
using Vector2 = VectorN<2>;
using Vector3 = VectorN<3>;
using Vector4 = VectorN<4>;
using Vector5 = VectorN<5>;
using Vector6 = VectorN<6>;
using Vector7 = VectorN<7>;
using VectorX = VectorN<Eigen::Dynamic>;

using Vector2I = VectorN<2, int>;
using Vector3I = VectorN<3, int>;
using Vector4I = VectorN<4, int>;
using VectorXI = VectorN<Eigen::Dynamic, int>;
using Vector2F = VectorN<2, float>;
using Vector3F = VectorN<3, float>;
using Vector4F = VectorN<4, float>;
using VectorXF = VectorN<Eigen::Dynamic, float>;

template <int N, typename T = double>
using MatrixN = Eigen::Matrix<T, N, N, Eigen::ColMajor>;
using Matrix2 = MatrixN<2>;
using Matrix3 = MatrixN<3>;
using Matrix4 = MatrixN<4>;
using Matrix5 = MatrixN<5>;
using Matrix6 = MatrixN<6>;
using Matrix7 = MatrixN<7>;
using MatrixX = MatrixN<Eigen::Dynamic>;

using Matrix2I = MatrixN<2, int>;
using Matrix3I = MatrixN<3, int>;
using Matrix4I = MatrixN<4, int>;
using MatrixXI = MatrixN<Eigen::Dynamic, int>;
using Matrix2F = MatrixN<2, float>;
using Matrix3F = MatrixN<3, float>;
using Matrix4F = MatrixN<4, float>;
using MatrixXF = MatrixN<Eigen::Dynamic, float>;

using Isometry2 = Eigen::Transform<double, 2, Eigen::Isometry, Eigen::ColMajor>;
using Isometry3 = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::ColMajor>;
using Affine2 = Eigen::Transform<double, 2, Eigen::Affine, Eigen::ColMajor>;
using Affine3 = Eigen::Transform<double, 3, Eigen::Affine, Eigen::ColMajor>;
using Rotation2D = Eigen::Rotation2D<double>;
using Quaternion = Eigen::Quaternion<double>;
using AngleAxis = Eigen::AngleAxis<double>;

// Names that older clients use.
using Vector2D = Vector2;
using Vector3D = Vector3;
using Vector4D = Vector4;
using Vector2d = Vector2;
using Vector3d = Vector3;
using Vector4d = Vector4;
using Vector6d = Vector6;
using Vector7d = Vector7;
using VectorXD = VectorX;
using Matrix2D = Matrix2;
using Matrix3D = Matrix3;
using Matrix4D = Matrix4;
using Matrix2d = Matrix2;
using Matrix3d = Matrix3;
using Matrix4d = Matrix4;
using Matrix6d = Matrix6;
using Matrix7d = Matrix7;
using MatrixXD = MatrixX;
using Isometry2D = Isometry2;
using Isometry3D = Isometry3;
using Affine2D = Affine2;
using Affine3D = Affine3;

}  // namespace g2o

#endif  // G2O_EIGEN_TYPES_H
