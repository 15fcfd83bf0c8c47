// SPDX-License-Identifier: BSD-3-Clause
// The type in which a graph stores an estimate.
#pragma once

#include <concepts>

#include "boxplus/base/matrix.h"

namespace boxplus::detail {

/// An Eigen column vector of doubles, or an expression of such a type.
template <class T>
concept EigenColumn = requires {
  typename T::PlainObject;
  requires std::derived_from<T, Eigen::MatrixBase<T>>;
  requires T::ColsAtCompileTime == 1 && std::same_as<typename T::Scalar, double>;
};

template <class T>
struct StoredAs {
  using Type = T;
};
template <EigenColumn T>
struct StoredAs<T> {
  using Type = Vector<double, T::RowsAtCompileTime>;
};

/// Vector<double, N> for every Eigen column vector of N doubles, with any alignment, and for expressions of
/// such vectors; T itself for all other types. So Eigen::Vector2d and Vector2 are one vertex type.
template <class T>
using StoredEstimate = typename StoredAs<T>::Type;

}  // namespace boxplus::detail
