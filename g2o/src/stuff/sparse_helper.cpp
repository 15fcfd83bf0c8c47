// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/sparse_helper.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <locale>

namespace g2o {
namespace {

/// Returns the name of the variable in Octave: the file name without its folder and its extension.
std::string variable_name(const std::string& filename) {
  const std::string name = filename.substr(filename.rfind('/') + 1);
  return name.substr(0, name.rfind('.'));
}

std::ofstream text_file(const std::string& filename) {
  std::ofstream out(filename);
  out.imbue(std::locale::classic());
  out << std::setprecision(17);
  return out;
}

}  // namespace

bool writeVector(const std::string& filename, const double* v, int n) {
  std::ofstream out = text_file(filename);
  for (int i = 0; i < n; ++i) out << v[i] << '\n';
  out.close();
  return !out.fail();
}

bool writeCCSMatrix(const std::string& filename, int rows, int cols, const int* p, const int* i,
                    const double* v, bool upperTriangle) {
  std::vector<TripletEntry> entries;
  for (int c = 0; c < cols; ++c) {
    for (int k = p[c]; k < p[c + 1]; ++k) {
      entries.emplace_back(i[k], c, v[k]);
      if (upperTriangle && i[k] != c) entries.emplace_back(c, i[k], v[k]);
    }
  }
  return writeTripletEntries(filename, rows, cols, entries);
}

bool writeTripletEntries(const std::string& filename, int rows, int cols,
                         const std::vector<TripletEntry>& triplets) {
  std::vector<TripletEntry> sorted = triplets;
  std::sort(sorted.begin(), sorted.end(), TripletColSort());
  std::ofstream out = text_file(filename);
  out << "# name: " << variable_name(filename) << "\n# type: sparse matrix\n# nnz: " << sorted.size()
      << "\n# rows: " << rows << "\n# columns: " << cols << "\n";
  for (const TripletEntry& e : sorted) out << e.r + 1 << " " << e.c + 1 << " " << e.x << "\n";
  out.close();
  return !out.fail();
}

}  // namespace g2o
