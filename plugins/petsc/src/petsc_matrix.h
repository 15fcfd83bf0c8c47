// SPDX-License-Identifier: BSD-3-Clause
// A system of boxplus as a matrix of PETSc.
#pragma once

#include <petscmat.h>

#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "petsc_calls.h"
#include "petsc_layout.h"

namespace boxplus::petsc {

/// A + λD. The structure and the layout must outlive the matrix.
class Matrix {
 public:
  /// `type` is MATBAIJ, MATSBAIJ or MATAIJ. If the blocks have different sizes, it becomes MATAIJ.
  Matrix(const Calls& calls, const BlockStructure& structure, const Layout& layout, MatType type);
  /// `values` are in the layout of the structure.
  void assign(const Calls& calls, const double* values, const Damping& damping);
  operator Mat() const { return matrix_; }

 private:
  /// The place of a block in the matrix.
  struct Place {
    PetscInt row, column;
  };
  /// The items that go to each process, or come from it: its share, and the first one of each share.
  struct Shares {
    std::vector<int> count, first;
  };

  template <class F>
  void for_each_block(F&& f) const;
  void exchange_places(const Calls& calls);
  void preallocate(const Calls& calls);
  const double* by_rows(std::uint32_t k, std::uint32_t column, bool is_upper, const double* values,
                        const Damping& damping);
  void insert(const Calls& calls, Place place, const double* values);
  std::size_t size(Place place) const {
    return static_cast<std::size_t>(layout_->dim(place.row)) *
           static_cast<std::size_t>(layout_->dim(place.column));
  }

  const BlockStructure* structure_;
  const Layout* layout_;
  Owned<Mat, MatDestroy> matrix_;
  bool upper_only_ = false;  // whether the matrix stores only its upper triangle
  // What this process contributes to rows of others, and what they contribute to its rows.
  std::vector<Place> received_places_;
  Shares sent_, received_;  // of values
  std::vector<double> sent_values_, received_values_;
  std::vector<double> block_;  // scratch memory
  std::vector<PetscInt> rows_, columns_;
};

}  // namespace boxplus::petsc
