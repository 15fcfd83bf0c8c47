// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/pose_graph.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>

#include "boxplus/base/error.h"
#include "graph/graph_view.h"

namespace boxplus::outliers {
namespace {

/// The mean of the variances of the rows [first, first + count).
double mean_variance(const Eigen::MatrixXd& covariance, int first, int count) {
  return count > 0 ? covariance.diagonal().segment(first, count).mean() : 0;
}

/// The spread of a measurement, or nothing if Ω is singular.
std::optional<Spread> spread_of(const detail::InformationView& information,
                                const detail::RelativeFrame& relative) {
  const Eigen::MatrixXd omega = information.matrix();
  const Eigen::LLT<Eigen::MatrixXd> factor(omega);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXd covariance = factor.solve(Eigen::MatrixXd::Identity(omega.rows(), omega.cols()));
  const double unit = relative.rotation_unit;
  const Spread spread{
      mean_variance(covariance, relative.translation_row, relative.translation_rows),
      mean_variance(covariance, relative.rotation_row, relative.rotation_rows) / (unit * unit)};
  const auto is_usable = [](double variance) { return variance > 0 && std::isfinite(variance); };
  if (!is_usable(spread.translation) || !is_usable(spread.rotation)) return std::nullopt;
  return spread;
}

class Reader {
 public:
  explicit Reader(const Graph& graph) : graph_(graph), roles_(graph) {}

  void read(PoseGraph& result, const Options& options) {
    for (const EdgeRef& edge : options.edges.empty() ? graph_.all_edges() : options.edges) {
      if (graph_.is_enabled(edge) && (options.level < 0 || graph_.level(edge) == options.level))
        read(result, edge);
    }
    result.poses.assign(roles_.trajectory().begin(), roles_.trajectory().end());
    split(result);
  }

 private:
  struct Found {
    EdgeRef edge;
    VertexRef from, to;
    detail::RelativeFrame relative;
    Spread spread;
  };

  void read(PoseGraph& result, const EdgeRef& edge) {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    detail::RelativeFrame relative;
    const auto is_other = [&] {
      if (!pool.relative_frame(edge.slot, relative) || !relative.motion.has_rotation || relative.from < 0)
        return true;
      const std::vector<VertexRef> vertices = graph_.vertices(edge);
      const VertexRef from = vertices[relative.from], to = vertices[relative.to];
      if (!is_pose(from) || !is_pose(to) || relative.rotation_rows == 0 || relative.translation_rows == 0)
        return true;
      const std::optional<Spread> spread = spread_of(graph_.information(edge), relative);
      if (!spread) return true;
      found_.push_back({edge, from, to, relative, *spread});
      note_dimension(result, relative.motion.dimension);
      return false;
    };
    if (is_other()) result.others.push_back(edge);
  }

  static void note_dimension(PoseGraph& result, int dimension) {
    result.is_mixed |= result.dimension != 0 && result.dimension != dimension;
    result.dimension = dimension;
  }

  bool is_pose(const VertexRef& vertex) const { return roles_.rank(vertex) != GraphView::kNone; }

  void split(PoseGraph& result) const {
    if (result.is_mixed) {
      for (const Found& found : found_) result.others.push_back(found.edge);
      return;
    }
    std::size_t order = 0;
    for (const Found& found : found_) {
      PoseEdge edge{found.edge,
                    roles_.rank(found.from),
                    roles_.rank(found.to),
                    motion_of(found.relative.motion),
                    found.spread,
                    graph_.information(found.edge).rows,
                    order++};
      if (edge.from > edge.to) {
        std::swap(edge.from, edge.to);
        edge.motion = edge.motion.inverse();
      }
      (edge.to - edge.from == 1 ? result.links : result.closures).push_back(edge);
    }
  }

  const Graph& graph_;
  EdgeRoles roles_;
  std::vector<Found> found_;
};

}  // namespace

PoseGraph::PoseGraph(const Graph& graph, const Options& options) {
  Reader(graph).read(*this, options);
}

void PoseGraph::suspect(detail::FunctionRef<bool(std::size_t)> is_suspect) {
  std::vector<PoseEdge> trusted;
  for (std::size_t k = 0; k < links.size(); ++k) (is_suspect(k) ? closures : trusted).push_back(links[k]);
  links = std::move(trusted);
  std::ranges::sort(closures, {}, &PoseEdge::order);
}

std::vector<Motion> PoseGraph::estimates(const Graph& graph) const {
  std::vector<Motion> result;
  result.reserve(poses.size());
  for (const VertexRef& pose : poses) {
    detail::Frame frame;
    graph.vertex_pools()[pose.pool]->get_frame(pose.slot, frame);
    result.push_back(motion_of(frame));
  }
  return result;
}

}  // namespace boxplus::outliers
