// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include "g2o/core/sparse_optimizer.h"

namespace g2o {
namespace internal {

/// The tag (or type) of an edge, and the ids of its vertices.
std::string nameOf(const OptimizableGraph::Edge& edge);

/// What is known about the information matrix of an edge, whose dimension must not be zero.
struct InformationCheck {
  double largest = std::numeric_limits<double>::quiet_NaN();  ///< of all |entries|; NaN if one is not finite
  bool symmetric = false;                                     ///< apart from rounding
  double least_eigenvalue = std::numeric_limits<double>::quiet_NaN();  ///< of a symmetric matrix
  bool definite = false;  ///< positive semi-definite, apart from rounding
};
InformationCheck checkInformation(const OptimizableGraph::Edge& edge);

/// Looks at the active edges for causes of a failed run, and reports what it finds as errors of the log:
///   - errors and Jacobians that are not finite, information matrices that are not finite, not symmetric,
///     zero or indefinite
///   - a Jacobian that differs from central differences (the first edge of each type)
///   - vertices of which some directions change no error
///   - parts of the graph without a fixed vertex and without an edge to a single vertex
/// Three elements of each kind are named, and the others counted. Takes about as long as linearizing all
/// edges once.
void reportFindings(SparseOptimizer& optimizer);

}  // namespace internal
}  // namespace g2o
