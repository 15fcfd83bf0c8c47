// SPDX-License-Identifier: BSD-3-Clause
// Runs the same Gauss-Newton iterations in both APIs, to measure the cost of the objects of the g2o API.
#pragma once

#include <string>

namespace boxplus::bench {

struct FaceFigures {
  double linearize_s = 0;  ///< the time of one linearization, including the assembly of H
  double iteration_s = 0;  ///< the median time of an iteration, without the first
};

struct FaceComparison {
  FaceFigures native, face;
};

/// Runs both APIs with all threads, from estimates near the minimum. Throws std::runtime_error if the
/// relative difference of the final chi2 is above 1e-9.
FaceComparison run_face_comparison(const std::string& path);

}  // namespace boxplus::bench
