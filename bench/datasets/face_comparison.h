// SPDX-License-Identifier: BSD-3-Clause
// Compares the native API of boxplus with its g2o API (the "face"). Both run the same Gauss-Newton
// iterations, so the difference is the cost of the vertex and edge objects of the g2o API.
#pragma once

#include <string>

namespace boxplus::bench {

struct FaceFigures {
  double linearize_s = 0;  ///< the time of one linearization, including the assembly of H
  double iteration_s = 0;  ///< the median time of an iteration; the first iteration is not counted
};

struct FaceComparison {
  FaceFigures native, face;
};

/// Runs both APIs with all hardware threads, from estimates near the minimum. Throws std::runtime_error if
/// the relative difference of their final chi2 is above 1e-9.
FaceComparison run_face_comparison(const std::string& path);

}  // namespace boxplus::bench
