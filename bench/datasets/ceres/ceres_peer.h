// SPDX-License-Identifier: BSD-3-Clause
// Runs Ceres on the same graph as boxplus: with the same errors, the same weights and the same fixed poses.
//
// This code is a separate shared library, because it is compiled with -march=native and boxplus is not. Its
// symbols are hidden, so that boxplus and Ceres do not share template functions, such as those of Eigen.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "datasets/plain_graph.h"

/// Marks a symbol that the shared library exports.
#define BOXPLUS_PEER __attribute__((visibility("default")))

namespace boxplus::bench {

/// One configuration of Ceres. All configurations are tried on every graph. They all use
/// SPARSE_NORMAL_CHOLESKY with SuiteSparse.
struct CeresSettings {
  enum class Strategy { kLevenbergMarquardt, kDogleg, kSubspaceDogleg };
  std::string_view name;
  Strategy strategy = Strategy::kLevenbergMarquardt;
  double initial_radius = 1e4;  ///< the initial radius of the trust region; this is the default of Ceres
  bool post_ordering = false;   ///< true: CHOLMOD orders the matrix; false: Ceres orders the parameter blocks
  bool non_monotonic = false;
};
BOXPLUS_PEER std::span<const CeresSettings> all_ceres_settings();

struct CeresStop {
  double chi2 = 0;  ///< the target: the run ends when chi2 is at most this
  int iterations = 100;
  double seconds = 120;
  double cost_tolerance = 1e-12;  ///< the run ends if the relative decrease of the cost is below this
};

struct CeresRun {
  double chi2_initial = 0, chi2_final = 0;  ///< twice the initial and the final cost of Ceres
  int iterations = 0;
  double arrival_s =
      std::numeric_limits<double>::infinity();  ///< the time from the call until the target was reached
  double total_s = 0;
  double jacobian_s = 0;  ///< the time of one evaluation of errors, Jacobians and gradient
  /// The median time of an iteration. The first one, which includes the analysis, is left out.
  double iteration_s = 0;
  double gradient_max = 0;  ///< the largest entry of the gradient of the cost at the start
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

class BOXPLUS_PEER CeresPeer {
 public:
  enum class Jacobians { kAutodiff, kAnalytic };

  CeresPeer(const PlainGraph& graph, Jacobians jacobians);
  ~CeresPeer();

  /// Solves the problem from the estimates of the graph, with one thread.
  CeresRun solve(const CeresSettings& settings, const CeresStop& stop);
  /// The result of the last run, in the layout of PlainGraph.
  const std::vector<double>& poses() const;
  const std::vector<double>& points() const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

/// Returns the version of Ceres.
BOXPLUS_PEER std::string_view ceres_version();

}  // namespace boxplus::bench
