// SPDX-License-Identifier: BSD-3-Clause
// The operations of the Schur complement that process one block W. W has R rows and N columns, and lies in
// the columns of an eliminated vertex.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// N consecutive doubles in registers, in as few vectors as possible: the last vector may overlap with the
/// one before it. Loads and stores access no memory beyond these N doubles.
template <int N>
struct Column {
#if defined(__GNUC__)
  static constexpr int kWidth = N >= kLanes ? kLanes : (N >= 4 && kLanes > 4) ? 4 : N >= 2 ? 2 : 1;
  typedef double Part __attribute__((vector_size(kWidth * sizeof(double))));
#else
  static constexpr int kWidth = 1;
  using Part = double;
#endif
  static constexpr int kParts = (N + kWidth - 1) / kWidth;
  Part parts[kParts];

  /// The first double of a part.
  static constexpr int begin(int part) {
    return part < kParts - 1 ? part * kWidth : N - kWidth;
  }

  void load(const double* from) {
    for_each_index<kParts>([&](auto k) __attribute__((always_inline)) {
      __builtin_memcpy(&parts[k], from + begin(k), sizeof(Part));
    });
  }
  void store(double* to) const {
    for_each_index<kParts>([&](auto k) __attribute__((always_inline)) {
      __builtin_memcpy(to + begin(k), &parts[k], sizeof(Part));
    });
  }
  void subtract(const Column& other, double factor) {
    for_each_index<kParts>([&](auto k)
                               __attribute__((always_inline)) { parts[k] -= other.parts[k] * factor; });
  }
  void scale(double factor) {
    for_each_index<kParts>([&](auto k) __attribute__((always_inline)) { parts[k] *= factor; });
  }
};

/// Y = W L⁻ᵀ. The diagonal of L contains the reciprocals of its entries.
template <int R, int N>
void whitened_block(int, int, const double* l, const double* w, double* y, int y_stride) {
  Column<R> columns[N];
  for_each_index<N>([&](auto p) __attribute__((always_inline)) {
    columns[p].load(w + p * R);
    for_each_index<p>([&](auto q)
                          __attribute__((always_inline)) { columns[p].subtract(columns[q], l[p + q * N]); });
    columns[p].scale(l[p + p * N]);
    columns[p].store(y + p * y_stride);
  });
}

/// C −= A Bᵀ, with A in registers. Cols is the number of rows of B, or 0 if it is known only at run time.
template <int R, int N, int Cols>
inline void subtract_block_product(const Column<R> (&a)[N], const double* b, int b_rows, double* c) {
  const int cols = Cols > 0 ? Cols : b_rows;
#pragma GCC unroll 12
  for (int j = 0; j < cols; ++j) {
    Column<R> sum;
    sum.load(c + j * R);
    for_each_index<N>([&](auto p) __attribute__((always_inline)) { sum.subtract(a[p], b[j + p * cols]); });
    sum.store(c + j * R);
  }
}

template <int R, int N>
void subtract_block_products(int, int, const double* a, const BlockProducts& products) {
  Column<R> columns[N];
  for_each_index<N>([&](auto p) __attribute__((always_inline)) { columns[p].load(a + p * R); });
  const double* b = products.b;
  for (int k = 0; k < products.count; ++k) {
    const int b_rows = products.b_rows[k];
    double* c = products.values + products.targets[k];
    if (b_rows == R) {
      subtract_block_product<R, N, R>(columns, b, b_rows, c);
    } else {
      subtract_block_product<R, N, 0>(columns, b, b_rows, c);
    }
    b += b_rows * N;
  }
}

/// y −= W x.
template <int R, int N>
void subtract_block_multiple(int, int, const double* w, const double* x, double* y) {
  Column<R> sum;
  sum.load(y);
  for_each_index<N>([&](auto p) __attribute__((always_inline)) {
    Column<R> column;
    column.load(w + p * R);
    sum.subtract(column, x[p]);
  });
  sum.store(y);
}

/// y −= Wᵀ x.
template <int R, int N>
void subtract_transposed_multiple(int, int, const double* w, const double* x, double* y) {
#pragma GCC unroll 3
  for (int p = 0; p < N; ++p) {
    double even = 0, odd = 0;
#pragma GCC unroll 12
    for (int r = 0; r + 1 < R; r += 2) {
      even += w[r + p * R] * x[r];
      odd += w[r + 1 + p * R] * x[r + 1];
    }
    if constexpr (R % 2 == 1) even += w[R - 1 + p * R] * x[R - 1];
    y[p] -= even + odd;
  }
}

template <int R, int N>
inline constexpr EliminationKernels kEliminationKernels{whitened_block<R, N>, subtract_block_products<R, N>,
                                                        subtract_block_multiple<R, N>,
                                                        subtract_transposed_multiple<R, N>};

template <int R>
inline const EliminationKernels* elimination_kernels_of(int dim) {
  switch (dim) {
    case 1:
      return &kEliminationKernels<R, 1>;
    case 2:
      return &kEliminationKernels<R, 2>;
    case 3:
      return &kEliminationKernels<R, 3>;
    default:
      return nullptr;
  }
}

/// The rows are those of points, of poses, of the intrinsic parameters of cameras, and of both in one vertex.
inline const EliminationKernels* elimination_kernels_for(int rows, int dim) {
  const EliminationKernels* found = nullptr;
  const auto look_in = [&]<int... R>(std::integer_sequence<int, R...>) {
    ((rows == R ? void(found = elimination_kernels_of<R>(dim)) : void()), ...);
  };
  look_in(std::integer_sequence<int, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 22>());
  return found;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
