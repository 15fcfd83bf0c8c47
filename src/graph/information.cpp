// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/information.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/symmetric_eigen.h"
#include "boxplus/base/error.h"
#include "boxplus/graph/make_room.h"

namespace boxplus {
namespace {

/// The number of values in an upper triangle of n rows.
std::size_t triangle_size(int n) {
  const auto rows = static_cast<std::size_t>(n);
  return rows * (rows + 1) / 2;
}

/// The position of (i, j), i ≤ j, in an upper triangle of n rows that is stored row by row.
std::size_t triangle_index(int i, int j, int n) {
  return triangle_size(n) - triangle_size(n - i) + static_cast<std::size_t>(j - i);
}

std::string not_positive(const char* what, double value) {
  return fmt::format("information: expected a positive semi-definite matrix, got the {} {:.9g}", what, value);
}

/// The largest number of rows for which a valid Ω is checked without a heap allocation.
constexpr int kSmall = 6;

/// The reason why a full Ω is invalid; empty if it is valid.
template <class Storage>
std::string complaint_about(const detail::InformationView& omega) {
  const int rows = omega.rows;
  Storage full(rows, rows);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) full(i, j) = omega(i, j);
  }
  const double least = full.diagonal().minCoeff();
  if (least < 0) return not_positive("diagonal entry", least);
  // Computes an LDLᵀ factorization of the slightly shifted matrix. This is cheap, and accurate enough to find
  // indefinite matrices.
  const double shift = 1e-9 * full.diagonal().cwiseAbs().maxCoeff();
  Storage l = full;
  for (int k = 0; k < rows; ++k) {
    const double pivot = l(k, k) + shift;
    if (!(pivot > 0)) {
      const double smallest = symmetric_eigen(full).values[0];
      if (smallest < -shift) return not_positive("eigenvalue", smallest);
      return {};
    }
    for (int i = k + 1; i < rows; ++i) {
      const double factor = l(i, k) / pivot;
      for (int j = k + 1; j <= i; ++j) l(i, j) -= factor * l(j, k);
    }
  }
  return {};
}

}  // namespace

double detail::InformationView::operator()(int i, int j) const {
  switch (kind) {
    case detail::InformationKind::kScalar:
      return i == j ? values[0] : 0;
    case detail::InformationKind::kDiagonal:
      return i == j ? values[i] : 0;
    default:
      return i <= j ? values[triangle_index(i, j, rows)] : values[triangle_index(j, i, rows)];
  }
}

void detail::InformationView::apply(const double* x, int columns, double* y) const {
  for (int c = 0; c < columns; ++c, x += rows, y += rows) {
    if (kind == detail::InformationKind::kScalar) {
      for (int i = 0; i < rows; ++i) y[i] = values[0] * x[i];
    } else if (kind == detail::InformationKind::kDiagonal) {
      for (int i = 0; i < rows; ++i) y[i] = values[i] * x[i];
    } else {
      std::fill_n(y, rows, 0.0);
      const double* omega = values;
      for (int i = 0; i < rows; ++i) {
        double sum = y[i] + *omega++ * x[i];
        for (int j = i + 1; j < rows; ++j, ++omega) {
          sum += *omega * x[j];
          y[j] += *omega * x[i];
        }
        y[i] = sum;
      }
    }
  }
}

double detail::InformationView::weighted_squared_norm(const double* e) const {
  double sum = 0;
  if (kind == detail::InformationKind::kDiagonal) {
    for (int i = 0; i < rows; ++i) sum += values[i] * e[i] * e[i];
    return sum;
  }
  const double* omega = values;
  for (int i = 0; i < rows; ++i) {
    double half = 0.5 * *omega++ * e[i];
    for (int j = i + 1; j < rows; ++j) half += *omega++ * e[j];
    sum += e[i] * half;
  }
  return 2 * sum;
}

Information::Information(detail::InformationKind kind, int rows, std::span<const double> values)
    : kind_(kind), rows_(rows), count_(values.size()) {
  if (count_ <= kNear) {
    std::copy(values.begin(), values.end(), near_.begin());
  } else {
    far_.assign(values.begin(), values.end());
  }
}

Information Information::diagonal(std::span<const double> values) {
  return {detail::InformationKind::kDiagonal, static_cast<int>(values.size()), values};
}

Information Information::se3_sigmas(double translation, double rotation) {
  for (const double sigma : {translation, rotation}) {
    if (!(sigma > 0) || !std::isfinite(sigma))
      throw InvalidArgument(
          fmt::format("information: expected finite standard deviations > 0, got {}", sigma));
  }
  const double t = 1 / (translation * translation), r = 4 / (rotation * rotation);
  return diagonal(std::array{t, t, t, r, r, r});
}

Information Information::upper_triangle(std::span<const double> values, int rows) {
  if (rows < 0) throw InvalidArgument("information: expected rows ≥ 0, got " + std::to_string(rows));
  if (values.size() != triangle_size(rows)) {
    throw InvalidArgument("information: expected the " + std::to_string(triangle_size(rows)) +
                          " values of an upper triangle of " + std::to_string(rows) + " rows, got " +
                          std::to_string(values.size()));
  }
  bool diagonal = rows > 0, scalar = diagonal;
  const double* value = values.data();
  for (int i = 0; i < rows; ++i) {
    const double on_diagonal = *value++;
    scalar = scalar && on_diagonal == values[0];
    for (int j = i + 1; j < rows; ++j) diagonal = (*value++ == 0) && diagonal;
  }
  if (diagonal && scalar) return {detail::InformationKind::kScalar, rows, values.first(1)};
  if (!diagonal) return {detail::InformationKind::kFull, rows, values};
  Information result(detail::InformationKind::kDiagonal, rows, values.first(static_cast<std::size_t>(rows)));
  double* out = result.far_.empty() ? result.near_.data() : result.far_.data();
  for (int i = 0; i < rows; ++i) *out++ = values[triangle_index(i, i, rows)];
  return result;
}

Information Information::from_matrix(const Eigen::MatrixXd& matrix) {
  const int n = static_cast<int>(matrix.rows());
  if (matrix.cols() != n) {
    throw InvalidArgument("information: expected a square matrix, got " + std::to_string(n) + " × " +
                          std::to_string(matrix.cols()) +
                          " (for a diagonal matrix, use Information::diagonal)");
  }
  std::vector<double> upper;
  upper.reserve(triangle_size(n));
  for (int i = 0; i < n; ++i) {
    for (int j = i; j < n; ++j) {
      const double tolerance = 1e-9 * std::sqrt(std::abs(matrix(i, i) * matrix(j, j)));
      if (!(std::abs(matrix(i, j) - matrix(j, i)) <= tolerance)) {  // also true if one of the entries is NaN
        throw InvalidArgument(fmt::format(
            "information: expected a symmetric matrix, but ({0},{1}) = {2:.9g} and ({1},{0}) = {3:.9g}", i, j,
            matrix(i, j), matrix(j, i)));
      }
      upper.push_back(matrix(i, j));
    }
  }
  return upper_triangle(upper, n);
}

std::string Information::complaint(int rows) const {
  const std::span<const double> values = this->values();
  if (values.empty()) return "information: expected at least one row, got none";
  if (rows_ != 0 && rows_ != rows) {
    return "information: expected as many rows as the error has (" + std::to_string(rows) + "), got " +
           std::to_string(rows_);
  }
  for (double v : values) {
    if (!std::isfinite(v)) return "information: expected finite values, got " + std::to_string(v);
  }
  if (may_be_indefinite_) return {};
  if (kind_ != detail::InformationKind::kFull) {
    for (double v : values) {
      if (v < 0) return not_positive("diagonal entry", v);
    }
    return {};
  }
  const detail::InformationView omega{kind_, rows_, values.data()};
  return rows_ <= kSmall
             ? complaint_about<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kSmall, kSmall>>(
                   omega)
             : complaint_about<Eigen::MatrixXd>(omega);
}

void detail::InformationStore::reserve(double growth) {
  boxplus::detail::reserve(entries_, static_cast<std::size_t>(growth * static_cast<double>(entries_.size())));
  boxplus::detail::reserve(values_, static_cast<std::size_t>(growth * static_cast<double>(values_.size())));
}

void detail::InformationStore::append(const Information& information, int rows) {
  if (const std::string complaint = information.complaint(rows); !complaint.empty())
    throw InvalidArgument(complaint);
  const std::span<const double> values = information.values();
  detail::make_room(entries_);
  detail::make_room(values_, values.size());
  entries_.push_back(entry(information.kind(), values.size(), values_.size()));
  values_.insert(values_.end(), values.begin(), values.end());
}

void detail::InformationStore::set(std::uint32_t edge, const Information& information, int rows) {
  if (const std::string complaint = information.complaint(rows); !complaint.empty())
    throw InvalidArgument(complaint);
  const std::span<const double> values = information.values();
  std::uint64_t capacity = (entries_[edge] >> kOffsetBits) & kCapacityMask;
  std::uint64_t offset = entries_[edge] & kOffsetMask;
  if (values.size() > capacity) {
    capacity = values.size();
    offset = values_.size();
    values_.resize(values_.size() + values.size());
  }
  std::copy(values.begin(), values.end(), values_.begin() + static_cast<std::ptrdiff_t>(offset));
  entries_[edge] = entry(information.kind(), capacity, offset);
}

std::uint64_t detail::InformationStore::entry(detail::InformationKind kind, std::uint64_t capacity,
                                              std::uint64_t offset) {
  return (static_cast<std::uint64_t>(kind) << 62) | (std::min(capacity, kCapacityMask) << kOffsetBits) |
         offset;
}

}  // namespace boxplus
