// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/matrix_structure.h"

#include <algorithm>
#include <fstream>

namespace g2o {

MatrixStructure::MatrixStructure() = default;
MatrixStructure::~MatrixStructure() = default;

void MatrixStructure::alloc(int n_, int nz) {
  n = n_;
  maxN = std::max(maxN, n_);
  maxNz = std::max(maxNz, nz);
  columns_.resize(static_cast<size_t>(maxN) + 1);
  rows_.resize(static_cast<size_t>(maxNz));
  Ap = columns_.data();
  Aii = rows_.data();
}

void MatrixStructure::free() {
  columns_.clear();
  rows_.clear();
  Ap = Aii = nullptr;
  n = m = maxN = maxNz = 0;
}

bool MatrixStructure::write(const char* filename) const {
  std::ofstream out(filename);
  if (!out) return false;
  for (int column = 0; column < n; ++column) {
    for (int k = Ap[column]; k < Ap[column + 1]; ++k) out << Aii[k] + 1 << " " << column + 1 << " 1\n";
  }
  return out.good();
}

}  // namespace g2o
