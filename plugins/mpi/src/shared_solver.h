// SPDX-License-Identifier: BSD-3-Clause
// The linear solver of the kept vertices of all processes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "kept_vertices.h"

namespace boxplus::mpi {

/// The inner solver of a SchurSolver. It gets the contributions of this process to S and to the reduced
/// right-hand side (without an elimination: to H and to the right-hand side), adds those of the other
/// processes, and solves the whole system, as every process does. If the inner solver needs contributions, it
/// gets those of this process, and adds them to those of the others itself.
///
/// Each solution begins with begin() and ends with end(), also in a process that fails before it calls
/// factorize() or solve(), so that the others do not wait for it.
class SharedSolver final : public LinearSolver {
 public:
  /// `inner` must not be null, and not need an operator. All arguments must outlive this object.
  SharedSolver(std::shared_ptr<LinearSolver> inner, Communicator& communicator, const KeptVertices& kept,
               int threads);

  std::string_view name() const override { return inner_->name(); }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override;
  LinearStatistics statistics() const override { return inner_->statistics(); }

  /// Begins the solution with another damping, in all processes.
  void begin() {
    stage_ = Stage::kBegun;
    worst_ = LinearStatus::kOk;
    failed_vertex_.reset();
  }
  /// Ends the solution in all processes. `status` is the reason why this process did not go on. Returns the
  /// worst status of all.
  LinearStatus end(LinearStatus status);
  /// The kept vertex at which the last factorization failed in all processes.
  std::optional<std::uint32_t> failed_vertex() const { return failed_vertex_; }

 private:
  enum class Stage : std::uint8_t { kBegun, kFactorized, kSolved, kFailed };
  /// A part of a block of this process that belongs to one pair of vertices, with its destination.
  struct Part {
    std::uint32_t from, to;
    std::uint16_t rows, columns, stride;
    bool transposed;
  };
  /// A kept vertex in the system of this process, whose blocks may have several.
  struct PartOfBlock {
    std::uint32_t first;  // scalar in its block of the local system
    std::uint32_t dim;
    std::uint32_t block;  // in the inner system
  };
  /// The place of one of KeptVertices::local() in the inner system.
  struct Place {
    std::uint32_t block, first;
  };

  bool is_divided() const { return inner_->needs() == Needs::kContributions; }
  void find_places();
  std::vector<std::vector<PartOfBlock>> vertices_of_blocks(const BlockStructure& structure) const;
  bool agree(LinearStatus status);
  void find_failed_vertex(std::uint32_t failed_block);
  void add_parts(std::span<const double> values);
  template <class F>
  auto call_inner(F&& f);
  template <class F>
  void for_each_scalar(F&& f) const;

  std::shared_ptr<LinearSolver> inner_;
  Communicator* communicator_;
  const KeptVertices* kept_;
  int threads_;
  // The inner system has all kept vertices, or those of this process in the order of their numbers.
  std::vector<std::uint32_t> vertices_;  // their numbers, if the inner system has those of this process
  std::vector<Place> places_;            // of each of kept_->local()
  BlockStructure structure_;
  std::vector<Part> parts_;
  std::vector<double> values_;     // of the matrix, and then the diagonal of its damping
  std::vector<double> vector_;     // of all scalars
  std::uint32_t first_local_ = 0;  // the scalar of the plan that is the first one of the local system
  Stage stage_ = Stage::kBegun;
  LinearStatus worst_ = LinearStatus::kOk;
  std::optional<std::uint32_t> failed_vertex_;
};

}  // namespace boxplus::mpi
