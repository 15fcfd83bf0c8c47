// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_MATRIX_STRUCTURE_H
#define G2O_MATRIX_STRUCTURE_H

#include <string>
#include <vector>

#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// The pattern of a sparse matrix in compressed columns.
/// Column c has the rows Aii[k] for Ap[c] ≤ k < Ap[c + 1].
class G2O_CORE_API MatrixStructure {
 public:
  MatrixStructure();
  ~MatrixStructure();
  MatrixStructure(const MatrixStructure&) = delete;
  MatrixStructure& operator=(const MatrixStructure&) = delete;

  /// Allocates n_ columns with nz entries.
  void alloc(int n_, int nz);
  void free();
  /// Writes the pattern as a list of rows and columns, which are counted from 1.
  bool write(const char* filename) const;
  int nzMax() const { return maxNz; }

  int n = 0;          ///< number of columns
  int m = 0;          ///< number of rows
  int* Ap = nullptr;  ///< n + 1 offsets
  int* Aii = nullptr;

 protected:
  std::vector<int> columns_, rows_;
  int maxN = 0;
  int maxNz = 0;
};

}  // namespace g2o

#endif  // G2O_MATRIX_STRUCTURE_H
