// SPDX-License-Identifier: BSD-3-Clause
// A system of boxplus as a matrix of PETSc.
#pragma once

#include <petscmat.h>

#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "petsc_calls.h"

namespace boxplus::petsc {

/// A + λD. The structure must outlive the matrix.
class Matrix {
 public:
  /// `type` is MATSEQBAIJ or MATSEQSBAIJ. If the blocks have different sizes, it becomes MATSEQAIJ.
  Matrix(const Calls& calls, const BlockStructure& structure, MatType type);
  /// `values` are in the layout of the structure.
  void assign(const Calls& calls, const double* values, const Damping& damping);
  operator Mat() const { return matrix_; }
  bool has_equal_blocks() const { return block_size_ > 0; }

 private:
  void preallocate(const Calls& calls);
  void insert(const Calls& calls, std::uint32_t row, std::uint32_t column, const double* values);

  const BlockStructure* structure_;
  Owned<Mat, MatDestroy> matrix_;
  PetscInt block_size_ = 0;       // 0 if the blocks have different sizes
  bool upper_only_ = false;       // whether the matrix stores only its upper triangle
  std::vector<double> diagonal_;  // scratch memory for one damped block
  std::vector<PetscInt> rows_, columns_;
};

}  // namespace boxplus::petsc
