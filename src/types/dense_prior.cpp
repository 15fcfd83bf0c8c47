// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/dense_prior.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/symmetric_eigen.h"
#include "boxplus/base/error.h"

namespace boxplus::dense_prior {
namespace {

using Eigen::Index;
using MapOfRoot = Eigen::Map<const Eigen::MatrixXd>;

/// "expected R with 9 columns, got 8"
void require_size(const std::string& name, Index expected, const char* what, Index actual) {
  if (expected == actual) return;
  throw InvalidArgument("DensePrior: expected " + name + " with " + std::to_string(expected) + " " + what +
                        ", got " + std::to_string(actual));
}

Rows make_rows(const Eigen::MatrixXd& root, const Eigen::VectorXd& offset) {
  if (!root.allFinite() || !offset.allFinite())
    throw InvalidArgument("DensePrior: expected finite values, got NaN or infinity");
  return {static_cast<int>(root.rows()),
          static_cast<int>(root.cols()),
          {root.data(), root.data() + root.size()},
          {offset.data(), offset.data() + offset.size()}};
}

}  // namespace

Rows from_root(const Eigen::MatrixXd& root, const Eigen::VectorXd& offset, int cols) {
  require_size("R", cols, "columns", root.cols());
  if (offset.size() == 0) return make_rows(root, Eigen::VectorXd::Zero(root.rows()));
  require_size("r", root.rows(), "entries", offset.size());
  return make_rows(root, offset);
}

Rows from_information(const Eigen::MatrixXd& H, const Eigen::VectorXd& b, int cols) {
  constexpr double kRounding = 1e-14;
  require_size("H", cols, "rows", H.rows());
  require_size("H", cols, "columns", H.cols());
  if (b.size() != 0) require_size("b", cols, "entries", b.size());
  if (!H.allFinite()) throw InvalidArgument("DensePrior: expected finite values, got NaN or infinity");
  const double scale = H.cwiseAbs().maxCoeff();
  if ((H - H.transpose()).cwiseAbs().maxCoeff() > 1e-9 * scale)
    throw InvalidArgument("DensePrior: expected a symmetric information matrix");
  const SymmetricEigen eigen = symmetric_eigen((H + H.transpose()) / 2);
  const Eigen::VectorXd& values = eigen.values;
  const double floor = kRounding * cols * scale;
  if (cols > 0 && values[0] < -1e5 * floor)
    throw InvalidArgument(
        "DensePrior: expected a positive semi-definite information matrix, got the eigenvalue " +
        fmt::format("{:.9g}", values[0]));
  Index flat = 0;
  while (flat < values.size() && values[flat] <= floor) ++flat;
  const Index rows = values.size() - flat;
  const Eigen::VectorXd roots = values.tail(rows).cwiseSqrt();
  const Eigen::MatrixXd vectors = eigen.vectors.rightCols(rows);
  const Eigen::MatrixXd root = roots.asDiagonal() * vectors.transpose();
  Eigen::VectorXd offset = Eigen::VectorXd::Zero(rows);
  if (b.size() != 0) offset = (vectors.transpose() * b).cwiseQuotient(roots);
  return make_rows(root, offset);
}

void evaluate(const Rows& rows, const double* delta, double* error) {
  const MapOfRoot root(rows.root.data(), rows.rows, rows.cols);
  Eigen::Map<Eigen::VectorXd> e(error, rows.rows);
  e = Eigen::Map<const Eigen::VectorXd>(rows.offset.data(), rows.rows);
  e.noalias() += root * Eigen::Map<const Eigen::VectorXd>(delta, rows.cols);
}

void multiply(const Rows& rows, int first, int dim, const double* D, double* jacobian) {
  const MapOfRoot root(rows.root.data(), rows.rows, rows.cols);
  Eigen::Map<Eigen::MatrixXd>(jacobian, rows.rows, dim).noalias() =
      root.middleCols(first, dim) * Eigen::Map<const Eigen::MatrixXd>(D, dim, dim);
}

void throw_count(std::string_view type, std::size_t expected, std::size_t actual) {
  throw InvalidArgument("DensePrior: expected " + std::to_string(expected) + " vertices of type " +
                        std::string(type) + ", one per mean, got " + std::to_string(actual));
}

}  // namespace boxplus::dense_prior
