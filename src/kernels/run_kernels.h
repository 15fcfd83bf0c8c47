// SPDX-License-Identifier: BSD-3-Clause
// Copies or adds runs of values: between a front and a vector, and from a child's update matrix to its
// parent.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// Divides [0, length) into parts that fit into a pack, and calls f(first, lanes) for each part. The object
/// `lanes` loads and stores the part.
template <class Scalar, class F>
inline void for_packs(int length, F&& f) {
  struct All {
    PackOf<Scalar> load(const Scalar* from) const { return dense::BOXPLUS_ISA::load(from); }
    void store(Scalar* to, PackOf<Scalar> pack) const { dense::BOXPLUS_ISA::store(to, pack); }
  };
  constexpr int kWidth = kLanesOf<Scalar>;
  int i = 0;
  for (; i + kWidth <= length; i += kWidth) f(i, All());
  if (i < length) f(i, LanesOf<Scalar>(length - i));
}

template <class Scalar>
void copy_numbers(const Scalar* from, Scalar* to, int length) {
  for_packs<Scalar>(length, [&](int i, const auto& lanes) { lanes.store(to + i, lanes.load(from + i)); });
}

template <class Scalar>
void add_numbers(const Scalar* from, Scalar* to, int length) {
  for_packs<Scalar>(length, [&](int i, const auto& lanes) {
    lanes.store(to + i, lanes.load(to + i) + lanes.load(from + i));
  });
}

/// Adds rows × columns values. If the columns are short, the outer loop is over packs of rows and the inner
/// loop over columns, so that the mask of the lanes is computed only once per pack of rows.
template <class Scalar>
void add_rectangle(const Scalar* from, long from_stride, Scalar* to, long to_stride, int rows, int columns) {
  constexpr int kShort = 4 * kLanesOf<Scalar>;
  if (rows > kShort) {
    for (int j = 0; j < columns; ++j) add_numbers(from + j * from_stride, to + j * to_stride, rows);
    return;
  }
  for_packs<Scalar>(rows, [&](int i, const auto& lanes) {
    const Scalar* source = from + i;
    Scalar* target = to + i;
    for (int j = 0; j < columns; ++j, source += from_stride, target += to_stride)
      lanes.store(target, lanes.load(target) + lanes.load(source));
  });
}

template <class Scalar>
void gather_runs(const Run* runs, int count, const Scalar* x, Scalar* work) {
  for (const Run* run = runs; run != runs + count; ++run)
    copy_numbers(x + run->destination, work + run->source, static_cast<int>(run->length));
}

template <class Scalar>
void scatter_runs(const Run* runs, int count, const Scalar* work, Scalar* x) {
  for (const Run* run = runs; run != runs + count; ++run)
    copy_numbers(work + run->source, x + run->destination, static_cast<int>(run->length));
}

template <class Scalar>
void add_runs(const Run* runs, int count, const Scalar* from, Scalar* to) {
  for (const Run* run = runs; run != runs + count; ++run)
    add_numbers(from + run->source, to + run->destination, static_cast<int>(run->length));
}

template <class Scalar>
void extend_add(const ExtendAdd<Scalar>& task) {
  const long below = task.below, leading = task.leading;
  for (const Run* c = task.columns; c != task.columns_end; ++c) {
    const int columns = static_cast<int>(c->length);
    const Scalar* from = task.update + c->source * below;
    Scalar* to = task.to + (c->destination - task.column_origin) * leading;
    const Scalar* diagonal = from + c->source;
    Scalar* target = to + (c->destination - task.row_origin);
    for (int j = 0; j < columns; ++j)
      add_numbers(diagonal + j * (below + 1), target + j * (leading + 1), columns - j);
    for (const Run* r = c + 1; r != task.end; ++r) {
      add_rectangle(from + r->source, below, to + (r->destination - task.row_origin), leading,
                    static_cast<int>(r->length), columns);
    }
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
