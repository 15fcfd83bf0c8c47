// SPDX-License-Identifier: BSD-3-Clause
// The same Gauss-Newton iterations in both faces: what the objects of the g2o face cost.
#pragma once

#include <string>

namespace boxplus::bench {

struct FaceFigures {
  double linearize_s = 0;  ///< of one linearisation, H assembled
  double iteration_s = 0;  ///< the median iteration but for the first
};

struct FaceDuel {
  FaceFigures native, face;
};

/// Both with all threads, from the estimates of the file. Throws std::runtime_error where the two end at chi2
/// that differ by more than 1e-9.
FaceDuel run_face_duel(const std::string& path);

}  // namespace boxplus::bench
