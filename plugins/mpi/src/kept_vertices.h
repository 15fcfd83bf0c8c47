// SPDX-License-Identifier: BSD-3-Clause
// The vertices that are not eliminated, as all processes number them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "communicator.h"
#include "plan/plan.h"

namespace boxplus::mpi {

/// A kept vertex that takes part in several processes has its scalars in the vectors of each. One of these
/// processes owns it: the one with the lowest rank. The scalars of all kept vertices have numbers, in the
/// order of parameters and vertices, and of their ids.
class KeptVertices {
 public:
  /// Collective. Throws InvalidArgument if the flags, sizes or estimates of a vertex differ between
  /// processes, or if there are more than `most` kept vertices.
  KeptVertices(Communicator& communicator, const Graph& graph, const Plan& plan, std::uint32_t most);

  std::uint32_t count() const { return static_cast<std::uint32_t>(dims_.size()); }
  /// The sizes of all kept vertices.
  const std::vector<std::uint32_t>& dims() const { return dims_; }
  /// The number of their scalars.
  std::uint32_t scalars() const { return scalars_; }
  Id id(std::uint32_t vertex) const { return ids_[vertex]; }

  /// A vertex in this process. They are in the order of the plan's blocks.
  struct Local {
    std::uint32_t vertex;     ///< its number in all processes
    std::uint32_t first;      ///< its first scalar in a vector of the plan
    std::uint32_t all_first;  ///< its first scalar among those of all kept vertices
    std::uint32_t dim;
    bool own;
  };
  std::span<const Local> local() const { return local_; }
  std::uint32_t own_count() const { return own_; }
  /// Those of the plan's unknowns that belong to this process.
  std::uint32_t own_unknowns() const { return own_unknowns_; }

  /// Replaces the entries of kept vertices of others by those of their owners. Collective.
  void complete(std::span<double> of_plan);
  /// Sets the entries of kept vertices of others to zero.
  void leave_own(std::span<double> of_plan) const;
  /// Calls f(scalar of the plan, scalar of all kept vertices, whether it is owned).
  template <class F>
  void for_each_scalar(F&& f) const {
    for (const Local& local : local_) {
      for (std::uint32_t i = 0; i < local.dim; ++i) f(local.first + i, local.all_first + i, local.own);
    }
  }

 private:
  Communicator* communicator_;
  std::vector<Id> ids_;
  std::vector<std::uint32_t> dims_;
  std::vector<Local> local_;
  std::uint32_t scalars_ = 0, own_ = 0, own_unknowns_ = 0;
  std::vector<double> shared_;  // of complete()
};

}  // namespace boxplus::mpi
