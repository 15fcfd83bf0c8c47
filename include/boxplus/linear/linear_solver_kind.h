// SPDX-License-Identifier: BSD-3-Clause
// The choices that the library offers for solving its linear systems.
#pragma once

#include <cstdint>
#include <string_view>

namespace boxplus {

enum class LinearSolverKind : std::uint8_t {
  kAutomatic,  ///< the block Cholesky, or pcg in the cases that AutomaticSolverOptions names
  kBlockCholesky,
  kPcg,
  kDense,
  kEigenSparse
};
std::string_view to_string(LinearSolverKind kind);

/// The elimination order of direct solvers.
enum class Ordering : std::uint8_t {
  kAutomatic,         ///< minimum degree, or nested dissection if it is predicted to save more than it costs
  kMinimumDegree,     ///< approximate minimum degree
  kNestedDissection,  ///< takes many times as long to compute, but saves operations if fronts are large
};

/// The arithmetic of a direct solver.
enum class Precision : std::uint8_t {
  kAutomatic,  ///< double, or mixed if that is predicted to save time
  kDouble,
  /// The factor is in float, which halves memory and time. Each solution is refined with A, in double, to
  /// SolveControl::relative_tolerance. If this does not converge, the solver falls back to double.
  kMixed
};
std::string_view to_string(Precision precision);

/// The form in which the Schur complement of eliminated blocks is used.
enum class SchurMode : std::uint8_t {
  kAutomatic,  ///< explicit for solvers that need blocks, implicit for solvers that need only products
  kExplicit,   ///< as a matrix
  kImplicit    ///< as an operator that multiplies vectors
};

}  // namespace boxplus
