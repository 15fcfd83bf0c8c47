// SPDX-License-Identifier: BSD-3-Clause
// Adds JᵀΩJ and JᵀΩe of several edges at a time, one edge per lane, to H and to the gradient.
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

/// The layout of the results of one edge, whose error has R rows and whose vertices have the tangent sizes D:
/// first the blocks H_ij, j ≤ i, in the order of EdgeLanes::targets, and then the gradient. Each block is
/// column-major, but a turned block is row-major.
template <int R, int... D>
struct EdgePlaces {
  static constexpr int kArity = sizeof...(D), kColumns = (D + ...);
  static constexpr int dim(int i) {
    const int dims[] = {D...};
    return dims[i];
  }
  static constexpr int first_column(int i) {
    int first = 0;
    for (int k = 0; k < i; ++k) first += dim(k);
    return first;
  }
  /// The number of values of the blocks H_kj, j ≤ k < i.
  static constexpr int values_before(int i) {
    int values = 0;
    for (int k = 0; k < i; ++k) values += dim(k) * first_column(k + 1);
    return values;
  }
  /// The index of the first value of H_ij, j ≤ i.
  static constexpr int block(int i, int j) { return values_before(i) + dim(i) * first_column(j); }
  /// Whether H_ij is turned: its usual target is transposed. The second vertex of a pixel is a point. Points
  /// are usually eliminated, so that the column of the point contains the block.
  static constexpr bool is_turned(int i, int j) { return R == 2 && i == 1 && j == 0 && dim(i) == 3; }
  /// The index of the entry (a, b) of H_ij, j ≤ i.
  static constexpr int entry(int i, int j, int a, int b) {
    return block(i, j) + (is_turned(i, j) ? a * dim(j) + b : b * dim(i) + a);
  }
};

/// The results of kLanes edges: the blocks of H and then the gradient. multiply() computes each value for all
/// edges at once. turn_to_edges() then transposes the values, so that the values of each edge are contiguous.
template <int R, int... D>
struct LaneProducts {
  using Places = EdgePlaces<R, D...>;
  static constexpr int kArity = Places::kArity, kColumns = Places::kColumns;
  static constexpr int kGradient = Places::values_before(kArity), kSize = kGradient + kColumns;
  static constexpr int kStride = (kSize + kLanes - 1) / kLanes * kLanes;
  Pack numbers[kStride];
  double edges[kLanes][kStride];

  template <EdgeNumbers::Kind kKind>
  void multiply(const double* jacobian, const double* error, const Pack* omega) {
    Pack e[R], weighted_error[R];
    for (int r = 0; r < R; ++r) e[r] = load(error + r * kTileLanes);
    weigh<R, kKind>(omega, e, weighted_error);
    for_each_vertex([&](auto j) {
      for (int b = 0; b < Places::dim(j); ++b) {
        Pack column[R], weighted[R], gradient{};
#pragma GCC unroll 6
        for (int r = 0; r < R; ++r) {
          column[r] = load(jacobian + ((Places::first_column(j) + b) * R + r) * kTileLanes);
          gradient += column[r] * weighted_error[r];
        }
        numbers[kGradient + Places::first_column(j) + b] = gradient;
        weigh<R, kKind>(omega, column, weighted);
        multiply_column<j>(jacobian, b, weighted);
      }
    });
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
    const std::uint32_t* pair = targets + kArity;
    for_each_vertex([&](auto i) {
      if (targets[i] != kNoTarget)
        add_column<Places::dim(i)>(gradient + targets[i], edge + kGradient + Places::first_column(i));
      for_each_vertex_up_to<i>([&](auto j) {
        const std::uint32_t target = *pair++;
        if (target != kNoTarget) add_block<i, j>(edge + Places::block(i, j), target, values);
      });
    });
  }

 private:
  template <int N>
  struct Constant {
    constexpr operator int() const { return N; }
  };
  template <int kLast, int k = 0, class F>
  static void for_each_vertex_up_to(F&& f) {
    f(Constant<k>());
    if constexpr (k < kLast) for_each_vertex_up_to<kLast, k + 1>(f);
  }
  template <class F>
  static void for_each_vertex(F&& f) {
    for_each_vertex_up_to<kArity - 1>(f);
  }

  /// The products of column b of vertex j with the columns of the vertices i ≥ j. `weighted` is Ω times that
  /// column.
  template <int j>
  [[gnu::always_inline]] void multiply_column(const double* jacobian, int b, const Pack (&weighted)[R]) {
    const auto product = [&](int a) {
      Pack sum{};
#pragma GCC unroll 6
      for (int r = 0; r < R; ++r) sum += load(jacobian + (a * R + r) * kTileLanes) * weighted[r];
      return sum;
    };
    for (int a = b; a < Places::dim(j); ++a) {
      const Pack value = product(Places::first_column(j) + a);
      numbers[Places::entry(j, j, a, b)] = numbers[Places::entry(j, j, b, a)] = value;
    }
    for_each_vertex([&](auto i) {
      if constexpr (i > j) {
        for (int a = 0; a < Places::dim(i); ++a)
          numbers[Places::entry(i, j, a, b)] = product(Places::first_column(i) + a);
      }
    });
  }

  template <int i, int j>
  static void add_block(const double* from, std::uint32_t target, double* values) {
    constexpr bool is_turned = Places::is_turned(i, j);
    constexpr int kRows = is_turned ? Places::dim(j) : Places::dim(i);  // of the column-major values
    constexpr int kCols = is_turned ? Places::dim(i) : Places::dim(j);
    double* const to = values + (target & ~kTransposedTarget);
    if (i == j || ((target & kTransposedTarget) != 0) == is_turned)
      return add_column<kRows * kCols>(to, from);
    for (int r = 0; r < kRows; ++r) {
      for (int c = 0; c < kCols; ++c) to[r * kCols + c] += from[c * kRows + r];
    }
  }
};

/// The number of values of an Ω of R rows.
template <int R, EdgeNumbers::Kind kKind>
inline constexpr int kOmegaNumbers = kKind == EdgeNumbers::kFull ? R*(R + 1) / 2
                                                                 : (kKind == EdgeNumbers::kDiagonal ? R : 1);

template <EdgeNumbers::Kind kKind, int R, int... D>
void add_edges_of(const EdgeLanes& tile) {
  constexpr int kNumbers = kOmegaNumbers<R, kKind>;
  LaneProducts<R, D...> products;
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
    load_lanes<kNumbers>(omegas, omega);
    if (tile.weight) {
      for (Pack& number : omega) number *= load(weights);
    }
    products.template multiply<kKind>(tile.jacobian + lane_offset(R * products.kColumns, k),
                                      tile.error + lane_offset(R, k), omega);
    products.turn_to_edges();
    for (int l = 0; l < here; ++l) products.add(l, tile.targets[k + l], tile.values, tile.gradient);
  }
}

/// The number of rows R of an error, and the tangent sizes D of the vertices of its edge.
template <int R, int... D>
struct Sizes {};

/// Calls f with `kind` as a compile-time constant.
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

template <int R, int... D>
void add_edges(const EdgeLanes& tile) {
  for_kind(tile.kind, [&]<EdgeNumbers::Kind kKind>() { add_edges_of<kKind, R, D...>(tile); });
}

/// Calls f(Sizes) with the sizes as compile-time constants, if there are kernels for them. There are kernels
/// for relative poses and points, for observations of a point from a pose, and for pixels (2 rows). The 3, 4,
/// 5, 8 or 12 intrinsic parameters of the camera of a pixel are constants, or part of the vertex of its pose,
/// or a vertex of their own.
template <class F>
void for_lane_sizes(int rows, const int* dims, int arity, F&& f) {
  const auto is = [&]<int R, int... D>(Sizes<R, D...>) {
    constexpr int kDims[] = {D...};
    if (rows != R || arity != static_cast<int>(sizeof...(D))) return false;
    for (int i = 0; i < arity; ++i) {
      if (dims[i] != kDims[i]) return false;
    }
    return true;
  };
  const auto offer = [&]<int R, int... D>(Sizes<R, D...> sizes) {
    if (is(sizes)) f(sizes);
  };
  offer(Sizes<3, 3, 3>());
  offer(Sizes<6, 6, 6>());
  offer(Sizes<2, 3, 2>());
  offer(Sizes<3, 6, 3>());
  offer(Sizes<2, 6, 3>());
  offer(Sizes<2, 9, 3>());
  offer(Sizes<2, 10, 3>());
  offer(Sizes<2, 11, 3>());
  offer(Sizes<2, 12, 3>());
  offer(Sizes<2, 14, 3>());
  offer(Sizes<2, 18, 3>());
  offer(Sizes<2, 22, 3>());
  offer(Sizes<2, 6, 3, 3>());
  offer(Sizes<2, 6, 3, 4>());
  offer(Sizes<2, 6, 3, 5>());
  offer(Sizes<2, 6, 3, 6>());
  offer(Sizes<2, 6, 3, 8>());
  offer(Sizes<2, 6, 3, 12>());
  offer(Sizes<2, 6, 3, 16>());
}

/// The kernel for edges of these sizes, or null if there is none.
inline AddEdges add_edges_for(int rows, const int* dims, int arity) {
  AddEdges found = nullptr;
  for_lane_sizes(
      rows, dims, arity, [&]<int R, int... D>(Sizes<R, D...>) { found = add_edges<R, D...>; });
  return found;
}

template <int R, EdgeNumbers::Kind kKind>
inline void squared_norms_of(int count, const double* error, const double* const* omega, double* out) {
  for (int k = 0; k < count; k += kLanes) {
    const double* omegas[kLanes];
    for (int l = 0; l < kLanes; ++l) omegas[l] = omega[k + l < count ? k + l : count - 1];
    Pack numbers[kOmegaNumbers<R, kKind>], e[R], weighted[R];
    load_lanes<kOmegaNumbers<R, kKind>>(omegas, numbers);
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
  if (rows == 2) return squared_norms<2>;
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
      load_lanes<kLanes>(blocks, packs);
      for (int i = 0; i < kLanes; ++i) {
        store(to + (m + i) * kTileLanes, packs[i]);
        blocks[i] += kLanes;
      }
    }
    if (m < size) {
      Pack packs[kLanes];
      load_lanes(blocks, packs, size - m);
      for (int i = 0; i < size - m; ++i) store(to + (m + i) * kTileLanes, packs[i]);
    }
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
