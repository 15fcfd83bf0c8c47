// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/accumulate.h"

#include <algorithm>

#include "linear/kernels/kernel_table.h"

namespace boxplus {
namespace {

/// block (di × dj) += Jiᵀ WJj, where Ji and WJj have `rows` rows; or its transpose into a dj × di block.
/// `Rows` > 0 fixes the number of rows at compile time.
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

/// block += scale · vi vjᵀ, or its transpose.
void add_rank_one(double scale, const double* vi, int di, const double* vj, int dj, bool transposed,
                  double* block) {
  for (int b = 0; b < dj; ++b) {
    for (int a = 0; a < di; ++a) block[transposed ? b + a * dj : a + b * di] += scale * vi[a] * vj[b];
  }
}

/// The edge one number at a time: of any size, and with a rank-one weight.
void accumulate_any(const EdgeSystem& edge, const InformationView& information, const EdgeWeight& weight,
                    const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                    double* weighted_error) {
  const int rows = edge.rows, cols = edge.cols;
  const int arity = static_cast<int>(edge.dims.size());
  information.apply(edge.jacobian, cols, weighted);
  information.apply(edge.error, 1, weighted_error);
  double* v = weighted_error + rows;  // JᵀΩe, all vertices
  for (int c = 0; c < cols; ++c) {
    double sum = 0;
    for (int r = 0; r < rows; ++r) sum += edge.jacobian[c * rows + r] * weighted_error[r];
    v[c] = sum;
  }
  if (weight.first != 1) {
    for (int k = 0; k < rows * cols; ++k) weighted[k] *= weight.first;
  }
  const AddProduct add = add_product_for(rows);
  const std::uint32_t* pair = targets + arity;
  for (int i = 0, column_i = 0; i < arity; column_i += edge.dims[static_cast<std::size_t>(i)], ++i) {
    const int di = edge.dims[static_cast<std::size_t>(i)];
    if (targets[i] != Scatter::kNowhere) {
      for (int k = 0; k < di; ++k)
        gradient[targets[i] + static_cast<std::uint32_t>(k)] += weight.first * v[column_i + k];
    }
    for (int j = 0, column_j = 0; j <= i; column_j += edge.dims[static_cast<std::size_t>(j)], ++j, ++pair) {
      if (*pair == Scatter::kNowhere) continue;
      const int dj = edge.dims[static_cast<std::size_t>(j)];
      const bool transposed = (*pair & Scatter::kTransposed) != 0;
      double* block = values + (*pair & ~Scatter::kTransposed);
      add(edge.jacobian + column_i * rows, di, weighted + column_j * rows, dj, rows, transposed, block);
      if (weight.second != 0)
        add_rank_one(weight.second, v + column_i, di, v + column_j, dj, transposed, block);
    }
  }
}

/// Adds P = JᵀΩJ, of which `at(i, j)` is the block of the vertices i and j, where the targets say.
void add_products(const EdgeSystem& edge, const double* products, int stride, const double* gradient_of_edge,
                  const std::uint32_t* targets, double* values, double* gradient) {
  const dense::KernelTable& kernels = dense::kernels();
  const int arity = static_cast<int>(edge.dims.size());
  const std::uint32_t* pair = targets + arity;
  for (int i = 0, column_i = 0; i < arity; column_i += edge.dims[static_cast<std::size_t>(i)], ++i) {
    const int di = edge.dims[static_cast<std::size_t>(i)];
    if (targets[i] != Scatter::kNowhere)
      kernels.add_block(gradient + targets[i], di, 1, gradient_of_edge + column_i, stride);
    for (int j = 0, column_j = 0; j <= i; column_j += edge.dims[static_cast<std::size_t>(j)], ++j, ++pair) {
      if (*pair == Scatter::kNowhere) continue;
      const int dj = edge.dims[static_cast<std::size_t>(j)];
      double* block = values + (*pair & ~Scatter::kTransposed);
      if ((*pair & Scatter::kTransposed) == 0) {
        kernels.add_block(block, di, dj, products + column_j * stride + column_i, stride);
      } else {  // P is symmetric
        kernels.add_block(block, dj, di, products + column_i * stride + column_j, stride);
      }
    }
  }
}

/// The edge by the kernels for small ones.
void accumulate_small(const EdgeSystem& edge, const InformationView& information, const EdgeWeight& weight,
                      const std::uint32_t* targets, double* values, double* gradient) {
  double products[dense::kMostEdgeColumns * dense::kMostEdgeColumns],
      gradient_of_edge[dense::kMostEdgeColumns];
  const auto kind = static_cast<dense::EdgeNumbers::Kind>(information.kind);
  const int stride = dense::kernels().normal_products(
      {edge.rows, edge.cols, edge.jacobian, edge.error, kind, information.values, weight.first}, products,
      gradient_of_edge);
  add_products(edge, products, stride, gradient_of_edge, targets, values, gradient);
}

}  // namespace

EdgeWeight edge_weight(const RobustKernel* kernel, double e2, bool triggs) {
  if (kernel == nullptr) return {};
  const Rho rho = (*kernel)(e2);
  EdgeWeight weight{rho.first < 0 ? 0 : rho.first, 0};  // NaN stays NaN
  if (triggs && e2 > 0) {
    const double least = -weight.first / e2;
    weight.second = 2 * rho.second < least ? least : 2 * rho.second;
  }
  return weight;
}

void accumulate(const EdgeSystem& edge, const InformationView& information, const EdgeWeight& weight,
                const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                double* weighted_error) {
  const bool is_small = edge.rows <= dense::kMostEdgeRows && edge.cols <= dense::kMostEdgeColumns;
  if (is_small && weight.second == 0) {
    accumulate_small(edge, information, weight, targets, values, gradient);
  } else {
    accumulate_any(edge, information, weight, targets, values, gradient, weighted, weighted_error);
  }
}

}  // namespace boxplus
