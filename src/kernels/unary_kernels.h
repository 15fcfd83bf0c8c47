// SPDX-License-Identifier: BSD-3-Clause
// Adds JᵀΩJ and JᵀΩe of unary edges, one after the other. As long as consecutive edges have the same vertex,
// the vertex's block of H and its gradient stay in registers.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"
#include "kernels/transpose.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// The block of H (C × C) and the gradient (C) of one vertex. The lanes of a pack are consecutive rows. Each
/// term of each edge is added directly to these sums. So the bits of the result depend only on the order of
/// the edges, and not on how the caller divides the edges into calls.
template <int R, int C>
class UnarySums {
 public:
  void load(const double* hessian, const double* gradient) {
    for (int b = 0; b < C; ++b) load_column(hessian + b * C, columns_[b]);
    load_column(gradient, columns_[C]);
  }

  void store(double* hessian, double* gradient) const {
    for (int b = 0; b < C; ++b) store_column(columns_[b], hessian + b * C);
    store_column(columns_[C], gradient);
  }

  void add(const double* jacobian, const double* error, EdgeNumbers::Kind kind, const double* omega,
           double weight) {
    Pack rows[R][kPacksOfColumn], weighted[R][kPacksOfColumn];
    load_rows(jacobian, rows);
    weigh(rows, kind, omega, weight, weighted);
#pragma GCC unroll 3
    for (int r = 0; r < R; ++r) {
#pragma GCC unroll 8
      for (int b = 0; b <= C; ++b) {
        const double factor = b < C ? jacobian[b * R + r] : error[r];
#pragma GCC unroll 4
        for (int p = 0; p < kPacksOfColumn; ++p) columns_[b][p] += weighted[r][p] * factor;
      }
    }
  }

 private:
  static constexpr int kPacksOfColumn = (C + kLanes - 1) / kLanes, kFull = C / kLanes, kRest = C % kLanes;

  static void load_column(const double* from, Pack (&to)[kPacksOfColumn]) {
    for (int p = 0; p < kFull; ++p) to[p] = dense::BOXPLUS_ISA::load(from + p * kLanes);
    if constexpr (kRest > 0) to[kFull] = Lanes(kRest).load(from + kFull * kLanes);
  }

  static void store_column(const Pack (&from)[kPacksOfColumn], double* to) {
    for (int p = 0; p < kFull; ++p) dense::BOXPLUS_ISA::store(to + p * kLanes, from[p]);
    if constexpr (kRest > 0) Lanes(kRest).store(to + kFull * kLanes, from[kFull]);
  }

  /// Loads the rows of J, which is stored column by column.
  static void load_rows(const double* jacobian, Pack (&rows)[R][kPacksOfColumn]) {
    if constexpr (R == 1) {
      load_column(jacobian, rows[0]);
    } else {
      for (int p = 0; p < kPacksOfColumn; ++p) {
        const double* columns[kLanes];
        for (int l = 0; l < kLanes; ++l) {
          const int column = p * kLanes + l;
          columns[l] = jacobian + (column < C ? column : 0) * R;
        }
        Pack transposed[R];
        load_lanes<R>(columns, transposed);
        for (int r = 0; r < R; ++r) rows[r][p] = transposed[r];
      }
    }
  }

  /// weighted = weight · Ω · rows.
  static void weigh(const Pack (&rows)[R][kPacksOfColumn], EdgeNumbers::Kind kind, const double* omega,
                    double weight, Pack (&weighted)[R][kPacksOfColumn]) {
    if (kind == EdgeNumbers::kFull && R > 1) {
      for (int r = 0; r < R; ++r) {
        for (int p = 0; p < kPacksOfColumn; ++p) weighted[r][p] = Pack{};
        for (int s = 0; s < R; ++s) {
          const int i = r < s ? r : s, j = r < s ? s : r;
          const double factor = weight * omega[i * R - i * (i - 1) / 2 + (j - i)];
          for (int p = 0; p < kPacksOfColumn; ++p) weighted[r][p] += rows[s][p] * factor;
        }
      }
    } else {
      for (int r = 0; r < R; ++r) {
        const double factor = weight * omega[kind == EdgeNumbers::kDiagonal ? r : 0];
        for (int p = 0; p < kPacksOfColumn; ++p) weighted[r][p] = rows[r][p] * factor;
      }
    }
  }

  Pack columns_[C + 1][kPacksOfColumn];
};

template <int R, int C>
void add_unary_edges(const UnaryEdges& tile) {
  UnarySums<R, C> sums;
  for (int k = 0; k < tile.count;) {
    const std::uint32_t at_gradient = tile.targets[k][0], at_hessian = tile.targets[k][1];
    if (at_gradient == kNoTarget) {
      ++k;
      continue;
    }
    sums.load(tile.values + at_hessian, tile.gradient + at_gradient);
    for (; k < tile.count && tile.targets[k][0] == at_gradient; ++k) {
      sums.add(tile.jacobian + k * R * C, tile.error + k * R, tile.kind, tile.omega[k],
               tile.weight ? tile.weight[k] : 1);
    }
    sums.store(tile.values + at_hessian, tile.gradient + at_gradient);
  }
}

template <int C>
AddUnaryEdges add_unary_edges_of(int rows) {
  switch (rows) {
    case 1:
      return add_unary_edges<1, C>;
    case 2:
      return add_unary_edges<2, C>;
    case 3:
      return add_unary_edges<3, C>;
    default:
      return nullptr;
  }
}

inline AddUnaryEdges add_unary_edges_for(int rows, int dim) {
  switch (dim) {
    case 1:
      return add_unary_edges_of<1>(rows);
    case 2:
      return add_unary_edges_of<2>(rows);
    case 3:
      return add_unary_edges_of<3>(rows);
    case 4:
      return add_unary_edges_of<4>(rows);
    case 6:
      return add_unary_edges_of<6>(rows);
    case 7:
      return add_unary_edges_of<7>(rows);
    default:
      return nullptr;
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
