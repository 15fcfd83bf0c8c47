// SPDX-License-Identifier: BSD-3-Clause
// Adds JᵀΩJ and JᵀΩe of several binary edges at a time, one edge per lane, to H and to the gradient.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/normal_kernels.h"
#include "kernels/transpose.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// Ω x for one edge per lane. Ω and x have R rows.
template <int R, EdgeNumbers::Kind kKind>
inline void weigh(const Pack* omega, const Pack (&x)[R], Pack (&out)[R]) {
#pragma GCC unroll 6
  for (int r = 0; r < R; ++r) {
    if constexpr (kKind == EdgeNumbers::kFull) {
      Pack sum{};
#pragma GCC unroll 6
      for (int s = 0; s < R; ++s) {
        const int i = r < s ? r : s, j = r < s ? s : r;
        sum += omega[i * R - i * (i - 1) / 2 + (j - i)] * x[s];
      }
      out[r] = sum;
    } else {
      out[r] = omega[kKind == EdgeNumbers::kDiagonal ? r : 0] * x[r];
    }
  }
}

/// The results of kLanes edges: H_ii, H_ji and H_jj, column by column, and both gradients. multiply()
/// computes each value for all edges at once. turn_to_edges() then transposes the values, so that the values
/// of each edge are contiguous.
template <int R, int I, int J>
struct LaneProducts {
  static constexpr int kII = 0, kJI = I * I, kJJ = kJI + J * I, kGradient = kJJ + J * J;
  static constexpr int kSize = kGradient + I + J;
  static constexpr int kStride = (kSize + kLanes - 1) / kLanes * kLanes;
  Pack numbers[kStride];
  double edges[kLanes][kStride];

  template <EdgeNumbers::Kind kKind>
  void multiply(const double* jacobian, const double* error, const Pack* omega) {
    constexpr int C = I + J;
    Pack e[R], weighted_error[R];
    for (int r = 0; r < R; ++r) e[r] = load(error + r * kTileLanes);
    weigh<R, kKind>(omega, e, weighted_error);
    for (int b = 0; b < C; ++b) {
      Pack column[R], weighted[R];
      Pack gradient{};
#pragma GCC unroll 6
      for (int r = 0; r < R; ++r) {
        column[r] = load(jacobian + (b * R + r) * kTileLanes);
        gradient += column[r] * weighted_error[r];
      }
      numbers[kGradient + b] = gradient;
      weigh<R, kKind>(omega, column, weighted);
      const auto product = [&](int a) {
        Pack sum{};
#pragma GCC unroll 6
        for (int r = 0; r < R; ++r) sum += load(jacobian + (a * R + r) * kTileLanes) * weighted[r];
        return sum;
      };
      if (b < I) {
        for (int a = b; a < I; ++a) numbers[kII + b * I + a] = numbers[kII + a * I + b] = product(a);
        for (int a = 0; a < J; ++a) numbers[kJI + b * J + a] = product(I + a);
      } else {
        for (int a = b - I; a < J; ++a)
          numbers[kJJ + (b - I) * J + a] = numbers[kJJ + a * J + (b - I)] = product(I + a);
      }
    }
  }

  void turn_to_edges() {
    for (int m = 0; m < kStride; m += kLanes) {
      Pack rows[kLanes];
      for (int k = 0; k < kLanes; ++k) rows[k] = m + k < kSize ? numbers[m + k] : Pack{};
      transpose(rows);
      for (int k = 0; k < kLanes; ++k) store(&edges[k][m], rows[k]);
    }
  }

  void add(int lane, const std::uint32_t* targets, double* values, double* gradient) const {
    const double* edge = edges[lane];
    if (targets[0] != kNoTarget) add_column<I>(gradient + targets[0], edge + kGradient);
    if (targets[1] != kNoTarget) add_column<J>(gradient + targets[1], edge + kGradient + I);
    if (targets[2] != kNoTarget) add_column<I * I>(values + targets[2], edge + kII);
    if (targets[3] != kNoTarget) add_coupling(edge + kJI, targets[3], values);
    if (targets[4] != kNoTarget) add_column<J * J>(values + targets[4], edge + kJJ);
  }

  static void add_coupling(const double* block, std::uint32_t target, double* values) {
    if ((target & kTransposedTarget) == 0) return add_column<J * I>(values + target, block);
    double* to = values + (target & ~kTransposedTarget);
    for (int j = 0; j < J; ++j) {
      for (int i = 0; i < I; ++i) to[j * I + i] += block[i * J + j];
    }
  }
};

/// The number of values of an Ω of R rows.
template <int R, EdgeNumbers::Kind kKind>
inline constexpr int kOmegaNumbers = kKind == EdgeNumbers::kFull ? R*(R + 1) / 2
                                                                 : (kKind == EdgeNumbers::kDiagonal ? R : 1);

template <int R, int I, int J, EdgeNumbers::Kind kKind>
void add_edges_of(const EdgeLanes& tile) {
  constexpr int kNumbers = kOmegaNumbers<R, kKind>;
  LaneProducts<R, I, J> products;
  for (int k = 0; k < tile.count; k += kLanes) {
    const int here = tile.count - k < kLanes ? tile.count - k : kLanes;
    const double* omegas[kLanes];
    double weights[kLanes];
    for (int l = 0; l < kLanes; ++l) {
      const int edge = l < here ? k + l : k;
      omegas[l] = tile.omega[edge];
      weights[l] = tile.weight ? tile.weight[edge] : 1;
    }
    Pack omega[kNumbers];
    load_lanes(omegas, kNumbers, omega);
    if (tile.weight) {
      for (Pack& number : omega) number *= load(weights);
    }
    products.template multiply<kKind>(tile.jacobian + lane_offset(R * (I + J), k),
                                      tile.error + lane_offset(R, k), omega);
    products.turn_to_edges();
    for (int l = 0; l < here; ++l) products.add(l, tile.targets[k + l], tile.values, tile.gradient);
  }
}

/// Calls f with the kind as a compile-time constant.
template <class F>
inline void for_kind(EdgeNumbers::Kind kind, F&& f) {
  switch (kind) {
    case EdgeNumbers::kScalar:
      return f.template operator()<EdgeNumbers::kScalar>();
    case EdgeNumbers::kDiagonal:
      return f.template operator()<EdgeNumbers::kDiagonal>();
    case EdgeNumbers::kFull:
      return f.template operator()<EdgeNumbers::kFull>();
  }
}

template <int R, int I, int J>
void add_edges(const EdgeLanes& tile) {
  for_kind(tile.kind, [&]<EdgeNumbers::Kind kKind>() { add_edges_of<R, I, J, kKind>(tile); });
}

inline AddEdges add_edges_for(int rows, int dim_i, int dim_j) {
  const auto is = [&](int r, int i, int j) { return rows == r && dim_i == i && dim_j == j; };
  if (is(3, 3, 3)) return add_edges<3, 3, 3>;
  if (is(6, 6, 6)) return add_edges<6, 6, 6>;
  if (is(2, 3, 2)) return add_edges<2, 3, 2>;
  if (is(3, 6, 3)) return add_edges<3, 6, 3>;
  return nullptr;
}

template <int R, EdgeNumbers::Kind kKind>
inline void squared_norms_of(int count, const double* error, const double* const* omega, double* out) {
  for (int k = 0; k < count; k += kLanes) {
    const double* omegas[kLanes];
    for (int l = 0; l < kLanes; ++l) omegas[l] = omega[k + l < count ? k + l : count - 1];
    Pack numbers[kOmegaNumbers<R, kKind>], e[R], weighted[R];
    load_lanes(omegas, kOmegaNumbers<R, kKind>, numbers);
    for (int r = 0; r < R; ++r) e[r] = load(error + lane_offset(R, k) + r * kTileLanes);
    weigh<R, kKind>(numbers, e, weighted);
    Pack sum{};
    for (int r = 0; r < R; ++r) sum += e[r] * weighted[r];
    double lanes[kLanes];
    store(lanes, sum);
    for (int l = 0; l < kLanes && k + l < count; ++l) out[k + l] = lanes[l];
  }
}

template <int R>
void squared_norms(int count, const double* error, EdgeNumbers::Kind kind, const double* const* omega,
                   double* out) {
  for_kind(kind, [&]<EdgeNumbers::Kind kKind>() { squared_norms_of<R, kKind>(count, error, omega, out); });
}

inline SquaredNorms squared_norms_for(int rows) {
  if (rows == 3) return squared_norms<3>;
  if (rows == 6) return squared_norms<6>;
  return nullptr;
}

/// Copies blocks of `size` values to lanes. `edges` points to contiguous blocks, one per edge.
inline void to_lanes(const double* edges, int size, int count, double* lanes) {
  for (int k = 0; k < count; k += kLanes) {
    const double* blocks[kLanes];
    for (int l = 0; l < kLanes; ++l) blocks[l] = edges + (k + l < count ? k + l : count - 1) * size;
    double* to = lanes + lane_offset(size, k);
    int m = 0;
    for (; m + kLanes <= size; m += kLanes) {
      Pack packs[kLanes];
      load_lanes(blocks, kLanes, packs);
      for (int i = 0; i < kLanes; ++i) {
        store(to + (m + i) * kTileLanes, packs[i]);
        blocks[i] += kLanes;
      }
    }
    if (m < size) {
      Pack packs[kLanes];
      load_lanes(blocks, size - m, packs);
      for (int i = 0; i < size - m; ++i) store(to + (m + i) * kTileLanes, packs[i]);
    }
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
