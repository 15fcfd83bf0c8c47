// SPDX-License-Identifier: BSD-3-Clause
// The same Gauss-Newton iterations in both APIs: measures the cost of the objects of the g2o API.
#pragma once

#include <string>

namespace boxplus::bench {

struct FaceFigures {
  double linearize_s = 0;  ///< for one linearization, with the assembly of H
  double iteration_s = 0;  ///< the median iteration without the first
};

struct FaceComparison {
  FaceFigures native, face;
};

/// Both with all threads, from the estimates of the file. Throws std::runtime_error if the final chi2 of the
/// two differ by more than 1e-9.
FaceComparison run_face_comparison(const std::string& path);

}  // namespace boxplus::bench
