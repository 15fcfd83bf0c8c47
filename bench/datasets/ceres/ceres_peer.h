// SPDX-License-Identifier: BSD-3-Clause
// Ceres on the same graph: with the same errors, the same weights and the same poses held.
//
// The peer is a separate library, compiled for this processor and with hidden symbols, so that neither side
// runs code that was compiled for the other.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "datasets/plain_graph.h"

/// Marks the symbols that the library exports.
#define BOXPLUS_PEER __attribute__((visibility("default")))

namespace boxplus::bench {

/// The configurations of Ceres that are tried on every graph, all with SPARSE_NORMAL_CHOLESKY over
/// SuiteSparse.
struct CeresSettings {
  enum class Strategy { kLevenbergMarquardt, kDogleg, kSubspaceDogleg };
  std::string_view name;
  Strategy strategy = Strategy::kLevenbergMarquardt;
  double initial_radius = 1e4;  ///< Ceres's default
  bool post_ordering = false;   ///< let CHOLMOD order the matrix, instead of ordering the parameter blocks
  bool non_monotonic = false;
};
BOXPLUS_PEER std::span<const CeresSettings> all_ceres_settings();

struct CeresStop {
  double chi2 = 0;  ///< arrived when chi2 is at most this
  int iterations = 100;
  double seconds = 120;
  double cost_tolerance = 1e-12;  ///< the relative decrease of the cost that ends a run
};

struct CeresRun {
  double chi2_initial = 0, chi2_final = 0;  ///< twice the cost
  int iterations = 0;
  double arrival_s = std::numeric_limits<double>::infinity();  ///< from the call until chi2 was reached
  double total_s = 0;
  double jacobian_s = 0;    ///< for one evaluation of errors, Jacobians and gradient
  double iteration_s = 0;   ///< the median iteration without the first, which includes the analysis
  double gradient_max = 0;  ///< largest entry of the gradient of the cost at the start
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

class BOXPLUS_PEER CeresPeer {
 public:
  enum class Jacobians { kAutodiff, kAnalytic };

  CeresPeer(const PlainGraph& graph, Jacobians jacobians);
  ~CeresPeer();

  /// Solves from the estimates of the graph, with one thread.
  CeresRun solve(const CeresSettings& settings, const CeresStop& stop);
  /// The result of the last run, in the layout of PlainGraph.
  const std::vector<double>& poses() const;
  const std::vector<double>& points() const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

/// The versions of Ceres, and of the Eigen with which its cost functions are compiled.
BOXPLUS_PEER std::string_view ceres_version();

}  // namespace boxplus::bench
