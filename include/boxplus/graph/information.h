// SPDX-License-Identifier: BSD-3-Clause
// The information matrix Ω of an edge: scalar, diagonal or full.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/base/matrix.h"

namespace boxplus::detail {

/// The layout of the values of an Ω of n rows: 1 value, n values, or the n(n+1)/2 values of the upper
/// triangle row by row (Ω11 Ω12 … Ω1n Ω22 …).
enum class InformationKind : std::uint8_t { kScalar, kDiagonal, kFull };

/// A view of an Ω that somebody else owns.
struct InformationView {
  InformationKind kind = InformationKind::kScalar;
  int rows = 0;
  const double* values = nullptr;

  double operator()(int i, int j) const;
  /// y = Ω x for `columns` columns of `rows` values each (column-major). y must not alias x.
  void apply(const double* x, int columns, double* y) const;
  /// eᵀ Ω e.
  double squared_norm(const double* e) const {
    if (kind != InformationKind::kScalar) return weighted_squared_norm(e);
    double sum = 0;
    for (int i = 0; i < rows; ++i) sum += e[i] * e[i];
    return values[0] * sum;
  }
  /// Eigen's allocator depends on compiler flags, so the code that frees a matrix must also allocate it.
  /// Therefore, this function is inline, like all functions that return an Eigen matrix of run-time size.
  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd full(rows, rows);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows; ++j) full(i, j) = (*this)(i, j);
    }
    return full;
  }

 private:
  double weighted_squared_norm(const double* e) const;  // diagonal or full
};

}  // namespace boxplus::detail

namespace boxplus {

/// An Ω that is passed to a graph.
class Information {
 public:
  using Kind = detail::InformationKind;
  using View = detail::InformationView;

  /// value · I, for an error of any size.
  Information(double value) : Information(Kind::kScalar, 0, std::span(&value, 1)) {}
  /// A symmetric n × n matrix. Throws InvalidArgument if it is not square or not symmetric.
  template <class Derived>
  Information(const Eigen::MatrixBase<Derived>& matrix) : Information(from_matrix(matrix)) {}
  static Information diagonal(std::span<const double> values);
  /// Of an error with the tangent of SE3, such as that of Between<SE3> and Prior<SE3>, from the standard
  /// deviations of each coordinate of the translation (meters) and of the rotation around each axis
  /// (radians). The last three rows of the error are the vector part of a quaternion, which measures half the
  /// angle. So their information is 4/σ². Throws InvalidArgument unless both are positive and finite.
  static Information se3_sigmas(double translation, double rotation);
  /// From n(n+1)/2 values, row by row. Diagonal matrices and multiples of I are detected and stored as such.
  static Information upper_triangle(std::span<const double> values, int rows);

  /// The same Ω, which a graph accepts although it has negative eigenvalues. A large error of such an edge
  /// may lower chi2, so that Σ ρ(eᵀΩe) need not have a minimum. Robust kernels are meant for eᵀΩe ≥ 0.
  Information as_given() && {
    may_be_indefinite_ = true;
    return std::move(*this);
  }

  Kind kind() const { return kind_; }
  std::span<const double> values() const {
    return count_ <= kNear ? std::span(near_.data(), count_) : std::span(far_);
  }
  /// The number of rows, or 0 for a scalar, which fits an error of any size.
  int rows() const { return rows_; }
  /// Says why this Ω does not suit an error of `rows` rows (size, NaN, indefinite). Empty if it is suitable.
  std::string complaint(int rows) const;

 private:
  Information(Kind kind, int rows, std::span<const double> values);
  static Information from_matrix(const Eigen::MatrixXd& matrix);

  /// The values of an Ω with up to six rows need no allocation.
  static constexpr std::size_t kNear = 21;
  Kind kind_;
  bool may_be_indefinite_ = false;
  int rows_;
  std::size_t count_;
  std::array<double, kNear> near_;
  std::vector<double> far_;  // all values, if there are more than kNear
};

}  // namespace boxplus

namespace boxplus::detail {

/// The Ω of all edges of a pool, one after the other.
class InformationStore {
 public:
  /// Reserves memory for `growth` times the present number of values.
  void reserve(double growth);
  void append(const Information& information, int rows);
  void set(std::uint32_t edge, const Information& information, int rows);
  InformationView view(std::uint32_t edge, int rows) const {
    const std::uint64_t entry = entries_[edge];
    return {static_cast<InformationKind>(entry >> 62), rows, values_.data() + (entry & kOffsetMask)};
  }

 private:
  static constexpr int kCapacityBits = 22, kOffsetBits = 40;
  static constexpr std::uint64_t kOffsetMask = (std::uint64_t{1} << kOffsetBits) - 1;
  static constexpr std::uint64_t kCapacityMask = (std::uint64_t{1} << kCapacityBits) - 1;
  static std::uint64_t entry(InformationKind kind, std::uint64_t capacity, std::uint64_t offset);

  // From the highest bit down: 2 bits for the kind, 22 bits for the number of values that fit at the offset,
  // 40 bits for the offset into values_.
  std::vector<std::uint64_t> entries_;
  std::vector<double> values_;
};

}  // namespace boxplus::detail
