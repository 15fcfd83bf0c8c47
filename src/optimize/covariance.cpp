// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/covariance.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "boxplus/linearize/linearizer.h"
#include "linear/inverse_blocks.h"
#include "linearize/fixed_directions.h"
#include "optimize/planned_system.h"

namespace boxplus {

class CovarianceMaker {
 public:
  static Covariance make(const Graph& graph, const Options& options, std::span<const VertexRef> vertices,
                         bool joint) {
    try {
      return CovarianceMaker(graph, options, joint).make(vertices);
    } catch (const Stopped&) {
      Covariance stopped;
      stopped.status_ = Covariance::Status::kStopped;
      stopped.message_ = "there is no covariance: the computation was stopped";
      return stopped;
    }
  }

 private:
  CovarianceMaker(const Graph& graph, const Options& options, bool joint)
      : graph_(graph),
        options_(options),
        stop_(options.stop),
        plan_(make_plan(graph, {.level = options.level,
                                .vertices = options.vertices,
                                .edges = options.edges,
                                .gauge = options.gauge,
                                .threads = resolved_threads(options),
                                .stop = stop_})),
        linearizer_(graph, plan_) {
    result_.is_joint_ = joint;
    linearizer_.set_stop(stop_);
  }

  Covariance make(std::span<const VertexRef> vertices) {
    list(vertices);
    refuse_freedoms();
    if (!result_.ok() || plan_.structure.blocks() == 0) return std::move(result_);
    factorize();
    if (result_.ok()) invert();
    return std::move(result_);
  }

  static constexpr std::uint32_t kNoBlock = 0xFFFFFFFFu;

  /// Finds the block of each vertex in H. Vertices that do not move have no block.
  void list(std::span<const VertexRef> vertices) {
    std::map<VertexRef, std::uint32_t> block_of;
    for (std::uint32_t block = 0; block < plan_.structure.blocks(); ++block)
      block_of.emplace(plan_.block_vertex[block], block);
    for (const GaugeVertex& gauge : plan_.held) result_.held_.push_back(gauge.vertex);
    for (const VertexRef& vertex : vertices) {
      const int dim = graph_.tangent_dim(vertex);
      result_.vertices_.push_back(vertex);
      if (!result_.places_.try_emplace(vertex, Covariance::Place{blocks_.size(), dim}).second) continue;
      const auto found = block_of.find(vertex);
      blocks_.push_back(found == block_of.end() ? kNoBlock : found->second);
      if (found == block_of.end() && dim > 0 && moves(vertex)) {
        fail(Covariance::Status::kSingular, vertex, "no active edge touches it");
      }
    }
    if (!blocks_.empty())
      result_.blocks_.resize(result_.block_index(blocks_.size() - 1, blocks_.size() - 1) + 1);
  }

  /// Fails if a component has a free motion that no edge measures and that no held vertex removes.
  void refuse_freedoms() {
    for (const detail::GaugeFreedom& freedom : plan_.freedoms) {
      if (result_.ok() && !is_gauge(freedom))
        fail(Covariance::Status::kSingular, freedom.vertex,
             "nothing measures the " + std::string(to_string(freedom)) + " of its part of the graph");
    }
  }

  bool is_gauge(const detail::GaugeFreedom& freedom) const {
    if (options_.gauge != GaugePolicy::kFixFirst) return false;
    const auto is_it = [&](const GaugeVertex& gauge) { return gauge.vertex == freedom.vertex; };
    if (std::any_of(plan_.held.begin(), plan_.held.end(), is_it)) return true;
    detail::Frame frame;
    graph_.vertex_pools()[freedom.vertex.pool]->get_frame(freedom.vertex.slot, frame);
    const int rigid_motions = frame.dimension == 2 ? 3 : 6;
    return freedom.translation && freedom.rotation && freedom.directions >= rigid_motions;
  }

  bool moves(VertexRef vertex) const {
    const auto contains = [&](const std::vector<VertexRef>& list) {
      return std::find(list.begin(), list.end(), vertex) != list.end();
    };
    if (graph_.is_fixed(vertex) || contains(result_.held_)) return false;
    if (all_directions_fixed(*graph_.vertex_pools()[vertex.pool], vertex.slot)) return false;
    return options_.vertices.empty() || contains(options_.vertices);
  }

  void fail(Covariance::Status status, VertexRef vertex, std::string_view why) {
    result_.status_ = status;
    result_.failed_vertex_ = vertex;
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    result_.message_ = pool.parameter(vertex.slot) ? "there is no covariance: parameter "
                                                   : "there is no covariance: vertex ";
    result_.message_ += std::to_string(graph_.id(vertex)) + " (" + std::string(pool.type_name()) +
                        ") is not determined: " + std::string(why);
  }

  void factorize() {
    linearizer_.linearize({options_.numeric_jacobians, options_.triggs_correction});
    stop_.check();
    solver_ = make_linear_solver(LinearSolverKind::kBlockCholesky);
    solver_->analyze(
        plan_.structure,
        {.threads = resolved_threads(options_), .last = plan_.loose_blocks, .may_be_singular = true}, stop_);
    const AssembledSystem system(plan_.structure, linearizer_.values());
    stiffness_.assign(plan_.scalars(), 0.0);
    for (const std::uint32_t scalar : plan_.held_scalars) {
      const auto next =
          std::upper_bound(plan_.structure.offset.begin(), plan_.structure.offset.end(), scalar);
      hold(static_cast<std::uint32_t>(next - plan_.structure.offset.begin() - 1), scalar);
    }
    const SolveControl control{.stop = stop_};
    FactorResult factor = solver_->factorize(system, {1.0, stiffness_.data()}, control);
    while (factor.status == LinearStatus::kNotPositiveDefinite && hold(factor))
      factor = solver_->factorize(system, {1.0, stiffness_.data()}, control);
    stop_.check();
    if (factor.status == LinearStatus::kOk) return;
    const VertexRef vertex = plan_.block_vertex[factor.failed_block];
    if (factor.status == LinearStatus::kNotFinite) {
      fail(Covariance::Status::kNotFinite, vertex, "an error, a Jacobian or a weight is NaN or infinite");
    } else {
      fail(Covariance::Status::kSingular, vertex, "the edges leave it free to move in some direction");
    }
  }

  /// If the block of a vanished pivot is one of Plan::loose_blocks, holds the direction of the pivot, because
  /// it is gauge freedom. Otherwise, returns false.
  bool hold(const FactorResult& factor) {
    const auto& loose = plan_.loose_blocks;
    const bool is_loose = std::find(loose.begin(), loose.end(), factor.failed_block) != loose.end();
    if (options_.gauge != GaugePolicy::kFixFirst || !is_loose || stiffness_[factor.failed_scalar] > 0)
      return false;
    hold(factor.failed_block, factor.failed_scalar);
    return true;
  }

  void hold(std::uint32_t block, std::uint32_t scalar) {
    // To hold a direction, adds this multiple of the diagonal entry of H to the entry. The variance of the
    // direction is then smaller than any rounding error.
    constexpr double kStiff = 1e30;
    const std::uint32_t dim = plan_.structure.dim(block), i = scalar - plan_.structure.offset[block];
    const double* diagonal =
        linearizer_.values().data() + plan_.structure.value_start[plan_.structure.column_start[block]];
    stiffness_[scalar] = kStiff * std::max(diagonal[i * (dim + 1)], 1e-300);
    const auto own = std::span(stiffness_).subspan(plan_.structure.offset[block], dim);
    if (std::all_of(own.begin(), own.end(), [](double s) { return s > 0; }))
      result_.held_.push_back(plan_.block_vertex[block]);
  }

  void invert() {
    struct Target {
      std::size_t i, j;
    };
    std::vector<BlockCoordinate> wanted;
    std::vector<Target> targets;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      for (std::size_t j = result_.is_joint_ ? 0 : i; j <= i; ++j) {
        if (blocks_[i] == kNoBlock || blocks_[j] == kNoBlock) continue;
        wanted.push_back({blocks_[i], blocks_[j]});
        targets.push_back({i, j});
      }
    }
    if (wanted.empty()) return;
    InverseBlocks inverse(plan_.structure, wanted);
    if (!inverse.compute(*solver_, stop_)) {
      stop_.check();
      fail(Covariance::Status::kNotFinite, plan_.block_vertex[std::max(wanted[0].row, wanted[0].column)],
           "the inverse of H overflows");
      return;
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) store(targets[k].i, targets[k].j, inverse.block(k));
  }

  /// Stores the block of the inverse for vertices i and j. If i equals j, makes the block exactly symmetric.
  void store(std::size_t i, std::size_t j, Eigen::MatrixXd inverse) {
    for (Eigen::Index r = 0; r < inverse.rows(); ++r) {
      if (is_held(blocks_[i], r)) inverse.row(r).setZero();
    }
    for (Eigen::Index c = 0; c < inverse.cols(); ++c) {
      if (is_held(blocks_[j], c)) inverse.col(c).setZero();
    }
    std::vector<double>& out = result_.blocks_[result_.block_index(i, j)];
    out.resize(static_cast<std::size_t>(inverse.size()));
    Eigen::Map<Eigen::MatrixXd> kept(out.data(), inverse.rows(), inverse.cols());
    if (i == j) {
      kept = (inverse + inverse.transpose()) / 2;
    } else {
      kept = inverse;
    }
    for_each_fixed(blocks_[i], [&](Eigen::Index direction) { kept.row(direction).setZero(); });
    for_each_fixed(blocks_[j], [&](Eigen::Index direction) { kept.col(direction).setZero(); });
  }

  bool is_held(std::uint32_t block, Eigen::Index direction) const {
    return stiffness_[plan_.structure.offset[block] + static_cast<std::uint32_t>(direction)] > 0;
  }

  /// Calls f for the fixed directions of the vertex of a block.
  template <class F>
  void for_each_fixed(std::uint32_t block, F&& f) const {
    const VertexRef& vertex = plan_.block_vertex[block];
    for (const int direction : graph_.fixed_directions(vertex)) {
      if (static_cast<std::uint32_t>(direction) < plan_.structure.dim(block)) f(direction);
    }
  }

  const Graph& graph_;
  const Options& options_;
  StopToken stop_;
  Plan plan_;
  Linearizer linearizer_;
  std::shared_ptr<LinearSolver> solver_;
  std::vector<double> stiffness_;      // added to the diagonal of H, to hold directions
  std::vector<std::uint32_t> blocks_;  // the block in H of each vertex, or kNoBlock
  Covariance result_;
};

Covariance covariance(const Graph& graph, std::span<const VertexRef> vertices, const Options& options) {
  return CovarianceMaker::make(graph, options, vertices, true);
}

Covariance covariance(const Graph& graph, std::initializer_list<VertexRef> vertices, const Options& options) {
  return covariance(graph, std::span(vertices.begin(), vertices.size()), options);
}

Covariance marginal_covariances(const Graph& graph, std::span<const VertexRef> vertices,
                                const Options& options) {
  return CovarianceMaker::make(graph, options, vertices, false);
}

const Covariance::Place& Covariance::place(VertexRef vertex) const {
  if (!ok()) throw Error(message_);
  const auto found = places_.find(vertex);
  if (found == places_.end())
    throw InvalidArgument("Covariance: expected one of the vertices that it was computed for");
  return found->second;
}

std::size_t Covariance::block_index(std::size_t i, std::size_t j) const {
  return is_joint_ ? i * (i + 1) / 2 + j : i;
}

}  // namespace boxplus
