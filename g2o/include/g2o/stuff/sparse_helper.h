// SPDX-License-Identifier: BSD-3-Clause
// Functions that write vectors and sparse matrices to text files for Octave. They return false if the file
// cannot be written.
#pragma once
#ifndef G2O_SPARSE_HELPER_H
#define G2O_SPARSE_HELPER_H

#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// An entry of a sparse matrix. Row and column indices begin with 0.
struct TripletEntry {
  int r, c;
  double x;
  TripletEntry(int r_, int c_, double x_) : r(r_), c(c_), x(x_) {}
};
/// Orders entries by column, then by row.
struct TripletColSort {
  bool operator()(const TripletEntry& e1, const TripletEntry& e2) const {
    return e1.c < e2.c || (e1.c == e2.c && e1.r < e2.r);
  }
};

/// Writes n values, one per line.
G2O_STUFF_API bool writeVector(const std::string& filename, const double* v, int n);

/// Writes a matrix that is given in compressed columns. Column c has the rows i[k] and values v[k] for p[c] ≤
/// k < p[c + 1]. If `upperTriangle` is true, also writes a mirrored copy of each entry, so that the matrix is
/// symmetric.
G2O_STUFF_API bool writeCCSMatrix(const std::string& filename, int rows, int cols, const int* p, const int* i,
                                  const double* v, bool upperTriangle = true);

/// Writes a matrix that is given by its entries in any order. Each position may occur only once.
G2O_STUFF_API bool writeTripletEntries(const std::string& filename, int rows, int cols,
                                       const std::vector<TripletEntry>& triplets);

}  // namespace g2o

#endif  // G2O_SPARSE_HELPER_H
