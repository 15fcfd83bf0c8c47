// SPDX-License-Identifier: BSD-3-Clause
// The matrix of a linear system as a solver sees it: block values, an operator, or both.
#pragma once

#include <span>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// A symmetric positive semi-definite matrix A. It is never damped: damping is an argument of the solver.
class BlockSystem {
 public:
  virtual ~BlockSystem() = default;
  virtual const BlockStructure& structure() const = 0;
  /// The values in the layout of structure(), or empty if A exists only as an operator.
  virtual std::span<const double> values() const = 0;
  /// y = A x.
  virtual void multiply(const double* x, double* y) const = 0;
  /// The diagonal blocks, one after the other, each dim × dim column-major with both triangles.
  virtual void block_diagonal(double* out) const = 0;
};

/// A BlockSystem over a structure and values that it does not own. The structure and the values must outlive
/// it.
class AssembledSystem final : public BlockSystem {
 public:
  AssembledSystem(const BlockStructure& structure, std::span<const double> values)
      : structure_(&structure), values_(values) {}
  const BlockStructure& structure() const override { return *structure_; }
  std::span<const double> values() const override { return values_; }
  void multiply(const double* x, double* y) const override;
  void block_diagonal(double* out) const override;

 private:
  const BlockStructure* structure_;
  std::span<const double> values_;
};

}  // namespace boxplus
