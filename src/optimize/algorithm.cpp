// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/algorithm.h"

#include "optimize/dogleg.h"
#include "optimize/gauss_newton.h"
#include "optimize/levenberg_marquardt.h"

namespace boxplus {

std::unique_ptr<Algorithm> make_algorithm(AlgorithmKind kind) {
  switch (kind) {
    case AlgorithmKind::kGaussNewton:
      return std::make_unique<GaussNewton>();
    case AlgorithmKind::kLevenbergMarquardt:
      return std::make_unique<LevenbergMarquardt>();
    default:
      return std::make_unique<Dogleg>();
  }
}

std::string_view to_string(AlgorithmKind kind) {
  switch (kind) {
    case AlgorithmKind::kGaussNewton:
      return "gauss-newton";
    case AlgorithmKind::kLevenbergMarquardt:
      return "levenberg-marquardt";
    case AlgorithmKind::kDogleg:
      return "dogleg";
    default:
      return "automatic";
  }
}

}  // namespace boxplus
