// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/parallel_front.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "boxplus/base/parallel.h"
#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

constexpr double kMinParallelFlops = 1e6;
constexpr double kMinParallelAdditions = 1e5;
constexpr double kBetweenStops = 1e9;  // the number of flops between two checks of the stop token

/// Divides the columns of a lower trapezoid into `parts` ranges with equal numbers of values. Returns the
/// first column of range `part`.
int part_begin(int rows, int columns, int part, int parts) {
  const double r = rows, c = columns, area = (r * c - c * c / 2) * part / parts;
  return std::min(columns, static_cast<int>(r - std::sqrt(std::max(0.0, r * r - 2 * area))));
}

/// Does the same as dense::factor_panel(), but for few columns. Factorizes the square at the top of the
/// block, and then divides the rows below the square by its factor in parallel.
template <class Scalar>
int factor_block_column(int threads, Scalar* block, int rows, int width, int ld,
                        const Scalar* minimum_pivot) {
  const int below = rows - width;
  const int parts = 1.0 * below * width * width < kMinParallelFlops ? 1 : threads;
  if (parts == 1) return dense::factor_panel(block, rows, width, ld, minimum_pivot);
  const int good = dense::factor_panel(block, width, width, ld, minimum_pivot);
  if (good < width) return good;
  detail::parallel_tasks(parts, [&](int part) {
    const auto bound = [&](int p) { return static_cast<int>(std::int64_t{below} * p / parts); };
    dense::divide_by_transposed(block + width + bound(part), ld, block, ld, bound(part + 1) - bound(part),
                                width);
  });
  return good;
}

}  // namespace

template <class Scalar>
int factor_panel_with(int threads, const StopToken& stop, Scalar* panel, int rows, int columns, int ld,
                      const Scalar* minimum_pivot) {
  const double flops = 1.0 * rows * columns * columns;
  if (flops < (threads == 1 ? kBetweenStops : kMinParallelFlops))
    return dense::factor_panel(panel, rows, columns, ld, minimum_pivot);
  for (int j = 0; j < columns; j += dense::kBlock) {
    if (j > 0 && stop.raised()) return kPanelStopped;
    const int width = std::min(dense::kBlock, columns - j), next = j + width;
    Scalar* block = panel + j + static_cast<std::ptrdiff_t>(j) * ld;
    const int good = factor_block_column(threads, block, rows - j, width, ld, minimum_pivot + j);
    if (good < width) return j + good;
    Scalar* trailing = panel + next + static_cast<std::ptrdiff_t>(next) * ld;
    const int below = rows - next, right = columns - next;
    const int parts = 2.0 * below * right * width < kMinParallelFlops ? 1 : threads;
    detail::parallel_tasks(parts, [&](int part) {
      const int begin = part_begin(below, right, part, parts);
      const int end = part + 1 == parts ? right : part_begin(below, right, part + 1, parts);
      dense::subtract_square(trailing, ld, block + width, ld, below, width, begin, end);
    });
  }
  return columns;
}

template <class Scalar>
void extend_add_with(int threads, const dense::ExtendAdd<Scalar>& task) {
  const double below = task.below;
  if (threads == 1 || below * below < kMinParallelAdditions)
    return dense::factor_kernels<Scalar>().extend_add(task);
  // The number of values in the lower triangle that are to the left of a column.
  const auto area = [&](double column) { return column * (below - column / 2); };
  const double first = area(task.columns->source);
  const dense::Run& back = task.columns_end[-1];
  const double all = area(back.source + double{0} + back.length) - first;
  const auto split = [&](int part) {
    return std::find_if(task.columns, task.columns_end, [&](const dense::Run& run) {
      return area(run.source) - first >= all * part / threads;
    });
  };
  detail::parallel_tasks(threads, [&](int part) {
    dense::ExtendAdd<Scalar> mine = task;
    mine.columns = split(part);
    mine.columns_end = part + 1 == threads ? task.columns_end : split(part + 1);
    dense::factor_kernels<Scalar>().extend_add(mine);
  });
}

template <class Scalar>
bool set_to_minus_square_with(int threads, const StopToken& stop, Scalar* c, int ldc, const Scalar* a,
                              int lda, int size, int k) {
  const double flops = 1.0 * size * size * k;
  if (flops < (threads == 1 ? kBetweenStops : kMinParallelFlops)) {
    dense::set_to_minus_square(c, ldc, a, lda, size, k, 0, size);
    return true;
  }
  const int parts = flops < kMinParallelFlops ? 1 : threads;
  const int strips = 1 + static_cast<int>(flops / kBetweenStops);
  for (int strip = 0, begin = 0; strip < strips; ++strip) {
    if (strip > 0 && stop.raised()) return false;
    const int end = strip + 1 == strips ? size : part_begin(size, size, strip + 1, strips);
    const int below = size - begin, width = end - begin;
    detail::parallel_tasks(parts, [&](int part) {
      const int from = begin + part_begin(below, width, part, parts);
      const int to = part + 1 == parts ? end : begin + part_begin(below, width, part + 1, parts);
      dense::set_to_minus_square(c, ldc, a, lda, size, k, from, to);
    });
    begin = end;
  }
  return true;
}

template int factor_panel_with(int, const StopToken&, double*, int, int, int, const double*);
template bool set_to_minus_square_with(int, const StopToken&, double*, int, const double*, int, int, int);
template void extend_add_with(int, const dense::ExtendAdd<double>&);
template int factor_panel_with(int, const StopToken&, float*, int, int, int, const float*);
template bool set_to_minus_square_with(int, const StopToken&, float*, int, const float*, int, int, int);
template void extend_add_with(int, const dense::ExtendAdd<float>&);

}  // namespace boxplus
