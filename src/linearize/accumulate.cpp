// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/accumulate.h"

#include <algorithm>
#include <cmath>

#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

/// Adds Jiᵀ WJj to a di × dj block, or its transpose to a dj × di block. Ji and WJj have `rows` rows. A
/// positive Rows is this number as a constant; with Rows = 0, it is known only at run time.
template <int Rows>
void add_product(const double* Ji, int di, const double* WJj, int dj, int rows, bool transposed,
                 double* block) {
  const int n = Rows > 0 ? Rows : rows;
  const int step_a = transposed ? dj : 1, step_b = transposed ? 1 : di;
  for (int b = 0; b < dj; ++b) {
    for (int a = 0; a < di; ++a) {
      double sum = 0;
      for (int r = 0; r < n; ++r) sum += Ji[a * n + r] * WJj[b * n + r];
      block[a * step_a + b * step_b] += sum;
    }
  }
}

using AddProduct = void (*)(const double*, int, const double*, int, int, bool, double*);

AddProduct add_product_for(int rows) {
  switch (rows) {
    case 1:
      return add_product<1>;
    case 2:
      return add_product<2>;
    case 3:
      return add_product<3>;
    case 6:
      return add_product<6>;
    default:
      return add_product<0>;
  }
}

/// Visits the places in the gradient and in H to which an edge adds (Scatter). Calls add_vertex(column, dim,
/// target) for each vertex i, and add_pair(column_i, dim_i, column_j, dim_j, transposed, target) for each
/// pair of vertices i and j ≤ i. Skips targets that are kNowhere.
template <class AddVertex, class AddPair>
void for_each_target(const EdgeSystem& edge, const std::uint32_t* targets, AddVertex&& add_vertex,
                     AddPair&& add_pair) {
  const std::uint32_t* pair = targets + edge.dims.size();
  int column_i = 0;
  for (std::size_t i = 0; i < edge.dims.size(); column_i += edge.dims[i], ++i) {
    if (targets[i] != Scatter::kNowhere) add_vertex(column_i, edge.dims[i], targets[i]);
    int column_j = 0;
    for (std::size_t j = 0; j <= i; column_j += edge.dims[j], ++j, ++pair) {
      if (*pair == Scatter::kNowhere) continue;
      add_pair(column_i, edge.dims[i], column_j, edge.dims[j], (*pair & Scatter::kTransposed) != 0,
               *pair & ~Scatter::kTransposed);
    }
  }
}

/// Computes weighted = ΩJ and weighted_error = [Ωe; JᵀΩe].
void weigh(const EdgeSystem& edge, const detail::InformationView& information, double* weighted,
           double* weighted_error) {
  const int rows = edge.rows;
  information.apply(edge.jacobian, edge.cols, weighted);
  information.apply(edge.error, 1, weighted_error);
  double* v = weighted_error + rows;
  for (int c = 0; c < edge.cols; ++c) {
    double sum = 0;
    for (int r = 0; r < rows; ++r) sum += edge.jacobian[c * rows + r] * weighted_error[r];
    v[c] = sum;
  }
}

/// Adds an edge with scalar loops. Works for edges of any size.
void accumulate_any(const EdgeSystem& edge, const detail::InformationView& information, double weight,
                    const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                    double* weighted_error) {
  const int rows = edge.rows, cols = edge.cols;
  weigh(edge, information, weighted, weighted_error);
  const double* v = weighted_error + rows;
  if (weight != 1) {
    for (int k = 0; k < rows * cols; ++k) weighted[k] *= weight;
  }
  const AddProduct add = add_product_for(rows);
  for_each_target(
      edge, targets,
      [&](int column, int dim, std::uint32_t target) {
        for (int k = 0; k < dim; ++k)
          gradient[target + static_cast<std::uint32_t>(k)] += weight * v[column + k];
      },
      [&](int column_i, int di, int column_j, int dj, bool transposed, std::uint32_t target) {
        double* block = values + target;
        add(edge.jacobian + column_i * rows, di, weighted + column_j * rows, dj, rows, transposed, block);
      });
}

/// Adds an edge with the kernels for small edges. Computes `products` = ρ′JᵀΩJ as a whole, and then adds its
/// blocks.
void accumulate_small(const EdgeSystem& edge, const detail::InformationView& information, double weight,
                      const std::uint32_t* targets, double* values, double* gradient) {
  static_assert(static_cast<int>(detail::InformationKind::kScalar) == dense::EdgeNumbers::kScalar &&
                static_cast<int>(detail::InformationKind::kDiagonal) == dense::EdgeNumbers::kDiagonal &&
                static_cast<int>(detail::InformationKind::kFull) == dense::EdgeNumbers::kFull);
  const dense::KernelTable& kernels = dense::kernels();
  double products[dense::kMostEdgeColumns * dense::kMostEdgeColumns],
      gradient_of_edge[dense::kMostEdgeColumns];
  const double* columns[dense::kMostEdgeColumns];
  for (int c = 0; c < edge.cols; ++c) columns[c] = edge.jacobian + c * edge.rows;
  const auto kind = static_cast<dense::EdgeNumbers::Kind>(information.kind);
  const int stride =
      kernels.normal_products({edge.rows, edge.cols, columns, edge.error, kind, information.values, weight},
                              products, gradient_of_edge);
  for_each_target(
      edge, targets,
      [&](int column, int dim, std::uint32_t target) {
        kernels.add_block(gradient + target, dim, 1, gradient_of_edge + column, stride);
      },
      [&](int column_i, int di, int column_j, int dj, bool transposed, std::uint32_t target) {
        if (transposed) {  // `products` is symmetric
          kernels.add_block(values + target, dj, di, products + column_i * stride + column_j, stride);
        } else {
          kernels.add_block(values + target, di, dj, products + column_j * stride + column_i, stride);
        }
      });
}

/// Adds an edge with the dense kernels. Computes the lower triangle of −ρ′JᵀΩJ in strips of columns, and then
/// subtracts its blocks.
void accumulate_large(const EdgeSystem& edge, const detail::InformationView& information, double weight,
                      const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                      double* weighted_error, double* dense) {
  constexpr int kStripColumns = 48;
  const int rows = edge.rows, cols = edge.cols;
  weigh(edge, information, weighted, weighted_error);
  const double* v = weighted_error + rows;
  double* transposed = dense;  // ρ′Jᵀ
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) transposed[r * cols + c] = weight * edge.jacobian[c * rows + r];
  }
  double* product = dense + rows * cols;
  std::fill_n(product, cols * cols, 0.0);
  for (int c = 0; c < cols; c += kStripColumns) {
    dense::kernels().in_double.subtract_product(product + c * cols + c, cols, transposed + c, cols,
                                                weighted + c * rows, rows, cols - c,
                                                std::min(kStripColumns, cols - c), rows);
  }
  const auto add_vertex = [&](int column, int dim, std::uint32_t target) {
    for (int k = 0; k < dim; ++k) gradient[target + static_cast<std::uint32_t>(k)] += weight * v[column + k];
  };
  const auto add_pair = [&](int column_i, int di, int column_j, int dj, bool is_transposed,
                            std::uint32_t target) {
    double* block = values + target;
    for (int b = 0; b < dj; ++b) {
      for (int a = 0; a < di; ++a) {
        const int column = std::min(column_i + a, column_j + b), row = std::max(column_i + a, column_j + b);
        block[is_transposed ? b + a * dj : a + b * di] -= product[column * cols + row];
      }
    }
  };
  for_each_target(edge, targets, add_vertex, add_pair);
}

/// The part of the curvature of ρ′Ω along the error that Triggs' correction leaves at least.
constexpr double kLeastCurvature = 1e-4;

}  // namespace

EdgeWeight edge_weight(const RobustKernel* kernel, double e2, bool triggs) {
  if (kernel == nullptr) return {};
  const RobustKernel::Rho rho = (*kernel)(e2);
  EdgeWeight weight{rho.first < 0 ? 0 : rho.first, 0};  // NaN stays NaN
  if (triggs && e2 > 0 && weight.first > 0) {
    constexpr double kRounding = 1e-9;
    const double along_error = weight.first + 2 * rho.second * e2;
    const bool is_corrected = std::isfinite(along_error) && along_error >= -kRounding * weight.first;
    if (is_corrected)
      weight.second = (std::max(along_error, kLeastCurvature * weight.first) - weight.first) / e2;
  }
  return weight;
}

void accumulate(const EdgeSystem& edge, const detail::InformationView& information, double weight,
                const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                double* weighted_error, double* dense) {
  const bool is_small =
      edge.rows <= dense::kMostEdgeRows && edge.cols > 0 && edge.cols <= dense::kMostEdgeColumns;
  if (is_small) {
    accumulate_small(edge, information, weight, targets, values, gradient);
  } else if (dense != nullptr && dense_scratch(edge.rows, edge.cols) > 0) {
    accumulate_large(edge, information, weight, targets, values, gradient, weighted, weighted_error, dense);
  } else {
    accumulate_any(edge, information, weight, targets, values, gradient, weighted, weighted_error);
  }
}

}  // namespace boxplus
