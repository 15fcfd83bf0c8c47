// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/covariance_references.h"

#include <algorithm>
#include <string>
#include <utility>

#include "covariance/covariance_system.h"
#include "covariance/weight_span.h"
#include "linear/inverse_blocks.h"
#include "plan/fixed_directions.h"

namespace boxplus {

class CovarianceMaker {
 public:
  static ReferencedCovariance make(CovarianceSystem& system, const Graph& graph, const Options& options,
                                   const BatchSystem* planned, std::span<const VertexRef> vertices,
                                   bool joint) {
    for (const VertexRef& vertex : vertices) (void)graph.tangent_dim(vertex);  // throws if it is stale
    try {
      system.plan(graph, options, planned);
      return CovarianceMaker(system, graph, options, joint).make(vertices);
    } catch (const Stopped&) {
      system.forget();
      Covariance stopped;
      stopped.status_ = Covariance::Status::kStopped;
      stopped.message_ = "there is no covariance: the computation was stopped";
      return {std::move(stopped)};
    } catch (...) {
      system.forget();
      throw;
    }
  }

 private:
  CovarianceMaker(CovarianceSystem& system, const Graph& graph, const Options& options, bool joint)
      : system_(system), graph_(graph), options_(options), stop_(options.stop) {
    result_.is_joint_ = joint;
  }

  ReferencedCovariance make(std::span<const VertexRef> vertices) {
    system_.factorize();
    list(vertices);
    refuse_freedoms();
    const auto& failure = system_.failure();
    if (result_.ok() && failure) fail(*failure);
    if (result_.ok()) invert();
    std::vector<VertexRef> references = this->references();
    return {std::move(result_), std::move(references)};
  }

  const Plan& plan() const { return system_.plan(); }

  /// Finds the block of each vertex in H. Vertices that do not move have no block.
  void list(std::span<const VertexRef> vertices) {
    for (const detail::GaugeVertex& gauge : plan().held) result_.held_.push_back(gauge.vertex);
    result_.held_.insert(result_.held_.end(), system_.held().begin(), system_.held().end());
    for (const VertexRef& vertex : vertices) {
      const int dim = graph_.tangent_dim(vertex);
      result_.vertices_.push_back(vertex);
      const Covariance::Place place{blocks_.size(), dim};
      result_.places_.try_emplace(result_.places_.end(), vertex, place);  // most lists ascend
      if (result_.places_.size() == blocks_.size()) continue;
      blocks_.push_back(system_.block_of(vertex));
      if (blocks_.back() == CovarianceSystem::kNoBlock && dim > 0 && moves(vertex))
        fail(Covariance::Status::kSingular, vertex, "no active edge touches it");
    }
    if (!blocks_.empty())
      result_.blocks_.resize(result_.block_index(blocks_.size() - 1, blocks_.size() - 1) + 1);
  }

  /// Fails if a component has a free motion that no edge measures and that no held vertex removes.
  void refuse_freedoms() {
    for (const detail::GaugeFreedom& freedom : plan().freedoms) {
      if (result_.ok() && !is_gauge(freedom))
        fail(Covariance::Status::kSingular, freedom.vertex,
             "nothing measures the " + std::string(to_string(freedom)) + " of its part of the graph");
    }
  }

  bool is_gauge(const detail::GaugeFreedom& freedom) const {
    if (options_.gauge != GaugePolicy::kFixFirst) return false;
    const auto is_it = [&](const detail::GaugeVertex& gauge) { return gauge.vertex == freedom.vertex; };
    if (std::any_of(plan().held.begin(), plan().held.end(), is_it)) return true;
    detail::Frame frame;
    graph_.vertex_pools()[freedom.vertex.pool]->get_frame(freedom.vertex.slot, frame);
    return freedom.translation && freedom.rotation && freedom.directions >= rigid_motions(frame);
  }

  bool moves(VertexRef vertex) const {
    const auto contains = [&](const std::vector<VertexRef>& list) {
      return std::find(list.begin(), list.end(), vertex) != list.end();
    };
    if (graph_.is_fixed(vertex) || contains(result_.held_)) return false;
    if (all_directions_fixed(*graph_.vertex_pools()[vertex.pool], vertex.slot)) return false;
    return options_.vertices.empty() || contains(options_.vertices);
  }

  /// If the weights span more digits than a factor with 32 digits has, a lost pivot says nothing of a vertex.
  void fail(const CovarianceSystem::Failure& failure) {
    constexpr double kMostDigits = 18;
    const WeightSpan span = weight_span(graph_, plan());
    const bool is_span = failure.status == Covariance::Status::kSingular && span.digits() > kMostDigits;
    if (!failure.is_weight_span && !is_span) return fail(failure.status, failure.vertex, failure.why);
    result_.status_ = failure.status;
    result_.failed_vertex_ = failure.vertex;
    result_.message_ = "there is no covariance: " + to_string(span, graph_);
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

  /// As ReferencedCovariance::references. Holding one direction of a vertex determines only a scale.
  std::vector<VertexRef> references() const {
    std::vector<VertexRef> found = result_.held_;
    for (std::uint32_t block = 0; block < plan().structure.blocks(); ++block) {
      if (system_.held_directions(block) == 0) continue;
      const VertexRef vertex = plan().block_vertex[block];
      detail::Frame frame;
      if (!graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) continue;
      if (system_.held_directions(block) >= rigid_motions(frame) &&
          std::find(found.begin(), found.end(), vertex) == found.end())
        found.push_back(vertex);
    }
    std::sort(found.begin(), found.end(),
              [this](const VertexRef& a, const VertexRef& b) { return graph_.id(a) < graph_.id(b); });
    return found;
  }

  static int rigid_motions(const detail::Frame& frame) { return frame.dimension == 2 ? 3 : 6; }

  /// Above this growth of the inverse, rounding in double may be visible in its sixth digit.
  static constexpr double kMostGrowth = 1e8;

  /// The vertices of a wanted block.
  struct Target {
    std::size_t i, j;
  };

  void invert() {
    std::vector<BlockCoordinate> wanted;
    std::vector<Target> targets;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      for (std::size_t j = result_.is_joint_ ? 0 : i; j <= i; ++j) {
        if (blocks_[i] == CovarianceSystem::kNoBlock || blocks_[j] == CovarianceSystem::kNoBlock) continue;
        wanted.push_back({blocks_[i], blocks_[j]});
        targets.push_back({i, j});
      }
    }
    if (wanted.empty()) return;
    if (system_.precise_factor() != nullptr) return invert_precisely(wanted, targets);
    InverseBlocks inverse(plan().structure, wanted);
    if (!inverse.compute(system_.solver(), stop_)) {
      stop_.check();
      fail(Covariance::Status::kNotFinite, plan().block_vertex[std::max(wanted[0].row, wanted[0].column)],
           "the inverse of H overflows");
      return;
    }
    if (growth(wanted, inverse) > kMostGrowth && system_.compute_precise_factor(scalars(wanted))) {
      if (system_.failure()) return fail(*system_.failure());
      return invert_precisely(wanted, targets);
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) store(targets[k].i, targets[k].j, inverse.block(k));
  }

  /// The largest product of a diagonal entry of H and the same one of its inverse, which is at most the
  /// condition number of the scaled H.
  double growth(std::span<const BlockCoordinate> wanted, const InverseBlocks& inverse) const {
    double largest = 0;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (wanted[k].row != wanted[k].column) continue;
      const Eigen::MatrixXd block = inverse.block(k);
      for (Eigen::Index i = 0; i < block.rows(); ++i) {
        if (!is_held(wanted[k].row, i))
          largest =
              std::max(largest, block(i, i) * system_.diagonal(wanted[k].row, static_cast<std::uint32_t>(i)));
      }
    }
    return largest;
  }

  /// The number of columns of the inverse that have wanted blocks.
  std::size_t scalars(std::span<const BlockCoordinate> wanted) const {
    std::size_t sum = 0;
    for (const auto& [row, column] : wanted) sum += row == column ? plan().structure.dim(column) : 0;
    return sum;
  }

  /// Whether rounding of the Jacobians, which are doubles, may change the diagonal block of a column visibly.
  bool has_too_few_digits(std::uint32_t column, std::span<const Eigen::MatrixXd> blocks,
                          std::span<const std::size_t> of_column,
                          std::span<const BlockCoordinate> wanted) const {
    constexpr double kMostPreciseGrowth = 1e24;  // its product with ε² is 5e-8
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (wanted[of_column[b]].row != column) continue;
      for (Eigen::Index i = 0; i < blocks[b].rows(); ++i) {
        const double entry = system_.diagonal(column, static_cast<std::uint32_t>(i));
        if (!is_held(column, i) && !(blocks[b](i, i) * entry <= kMostPreciseGrowth)) return true;
      }
    }
    return false;
  }

  void invert_precisely(std::span<const BlockCoordinate> wanted, std::span<const Target> targets) {
    constexpr double kMostMultiplications = 4e9;  // a minute
    const BlockStructure& structure = plan().structure;
    const double per_column = system_.precise_factor()->multiplications_to_solve();
    if (static_cast<double>(scalars(wanted)) * per_column > kMostMultiplications)
      return fail({Covariance::Status::kSingular, plan().block_vertex[wanted.front().row], {}, true});
    std::vector<std::vector<std::size_t>> of_column(structure.blocks());
    for (std::size_t k = 0; k < wanted.size(); ++k) of_column[wanted[k].column].push_back(k);
    std::vector<DoubleDouble> x(structure.scalars());
    for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
      std::vector<Eigen::MatrixXd> blocks;
      for (const std::size_t k : of_column[column])
        blocks.emplace_back(structure.dim(wanted[k].row), structure.dim(column));
      for (std::uint32_t c = 0; c < structure.dim(column) && !blocks.empty(); ++c) {
        stop_.check();
        std::fill(x.begin(), x.end(), DoubleDouble());
        x[structure.offset[column] + c] = 1;
        system_.precise_factor()->solve(x);
        for (std::size_t b = 0; b < blocks.size(); ++b) {
          const std::uint32_t first = structure.offset[wanted[of_column[column][b]].row];
          for (Eigen::Index r = 0; r < blocks[b].rows(); ++r)
            blocks[b](r, c) = x[first + static_cast<std::uint32_t>(r)].high;
        }
      }
      if (has_too_few_digits(column, blocks, of_column[column], wanted))
        return fail({Covariance::Status::kSingular, plan().block_vertex[column], {}, true});
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        const Target& target = targets[of_column[column][b]];
        store(target.i, target.j, std::move(blocks[b]));
      }
    }
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
    return system_.is_held(plan().structure.offset[block] + static_cast<std::uint32_t>(direction));
  }

  /// Calls f for the fixed directions of the vertex of a block.
  template <class F>
  void for_each_fixed(std::uint32_t block, F&& f) const {
    const VertexRef& vertex = plan().block_vertex[block];
    for (const int direction : graph_.fixed_directions(vertex)) {
      if (static_cast<std::uint32_t>(direction) < plan().structure.dim(block)) f(direction);
    }
  }

  CovarianceSystem& system_;
  const Graph& graph_;
  const Options& options_;
  StopToken stop_;
  std::vector<std::uint32_t> blocks_;  // the block in H of each vertex, or CovarianceSystem::kNoBlock
  Covariance result_;
};

namespace {

ReferencedCovariance compute_once(const Graph& graph, std::span<const VertexRef> vertices,
                                  const Options& options, bool joint) {
  CovarianceSystem system;
  system.use_once();
  return CovarianceMaker::make(system, graph, options, nullptr, vertices, joint);
}

}  // namespace

Covariance covariance(const Graph& graph, std::span<const VertexRef> vertices, const Options& options) {
  return compute_once(graph, vertices, options, true).covariance;
}

Covariance covariance(const Graph& graph, std::initializer_list<VertexRef> vertices, const Options& options) {
  return covariance(graph, std::span(vertices.begin(), vertices.size()), options);
}

Covariance marginal_covariances(const Graph& graph, std::span<const VertexRef> vertices,
                                const Options& options) {
  return compute_once(graph, vertices, options, false).covariance;
}

ReferencedCovariance referenced_covariances(const Graph& graph, std::span<const VertexRef> vertices,
                                            const Options& options) {
  return compute_once(graph, vertices, options, false);
}

ReferencedCovariance covariance_of_system(CovarianceSystem& system, const Graph& graph,
                                          const Options& options, const BatchSystem* planned,
                                          std::span<const VertexRef> vertices, bool joint) {
  return CovarianceMaker::make(system, graph, options, planned, vertices, joint);
}

}  // namespace boxplus
