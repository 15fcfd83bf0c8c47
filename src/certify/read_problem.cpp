// SPDX-License-Identifier: BSD-3-Clause
// Reads the chordal cost from a graph.
//
// Rotation. Let E = R_jᵀ R_i R_ij be the rotation by the angle θ about the axis u. Then
//   ‖(R_j − R_i R_ij) W‖² = tr(M (2I − E − Eᵀ)) = 4 sin²(θ/2) uᵀ (tr(M) I − M) u.
// With M = tr(ω)/2 I − ω, this is 4 q_vᵀ ω q_v for the vector part q_v of the quaternion of E. So it is
// exactly the error of Between<SE3>, whose Ω for q_v is 4 ω. M may be indefinite. In the plane, M = ω/2 I
// gives 2 ω (1 − cos θ) ≤ ω θ².
//
// Translation. ‖t_j − t_i − R_i t_ij‖² is the squared length of the error, in any frame. If Ω is not a
// multiple of the identity, the error depends on the frame, and is not quadratic in R_i. Then τ is the
// harmonic mean over the directions, as in SE-Sync.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "certify/chordal_problem.h"
#include "guess/frame_math.h"

namespace boxplus::certificate {
namespace {

using Relation = Certificate::Relation;

class Reader {
 public:
  Reader(const Graph& graph, ChordalProblem& problem, std::string& complaint)
      : graph_(graph), problem_(problem), complaint_(complaint) {}

  bool read(const Options& options);

 private:
  bool read_edge(const EdgeRef& edge);
  std::optional<std::uint32_t> pose(const VertexRef& vertex);
  void add(const EdgeRef& edge, const detail::RelativeFrame& relative, std::uint32_t from, std::uint32_t to);
  Relation relation(const EdgeRef& edge, const Eigen::MatrixXd& omega, const detail::RelativeFrame& relative,
                    double tau) const;
  bool pin_components();
  std::uint32_t root(std::uint32_t node);
  bool refuse(const std::string& what);
  std::string name(const EdgeRef& edge) const;

  const Graph& graph_;
  ChordalProblem& problem_;
  std::string& complaint_;
  std::map<VertexRef, std::uint32_t> index_;
  std::vector<std::uint32_t> parent_;  // of the connected components
};

bool Reader::refuse(const std::string& what) {
  complaint_ = what;
  return false;
}

/// "Prior<SE2> (vertex 5)"
std::string Reader::name(const EdgeRef& edge) const {
  const std::vector<VertexRef> vertices = graph_.vertices(edge);
  std::string text(graph_.edge_pools()[edge.pool]->type_name());
  text += vertices.size() == 1 ? " (vertex" : " (vertices";
  for (const VertexRef& vertex : vertices) text += " " + std::to_string(graph_.id(vertex));
  return text + ")";
}

bool Reader::read(const Options& options) {
  if (!options.vertices.empty()) return refuse("only some of the vertices may move");
  for (const EdgeRef& edge : options.edges.empty() ? graph_.all_edges() : options.edges) {
    if (!graph_.is_enabled(edge) || (options.level >= 0 && graph_.level(edge) != options.level)) continue;
    if (!read_edge(edge)) return false;
  }
  if (problem_.edges.empty()) return refuse("the graph has no edge that measures a relative pose");
  return pin_components();
}

bool Reader::read_edge(const EdgeRef& edge) {
  const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
  detail::RelativeFrame relative;
  const std::vector<VertexRef> vertices = graph_.vertices(edge);
  const bool is_relative =
      vertices.size() == 2 && pool.relative_frame(edge.slot, relative) && relative.from >= 0;
  const int d = relative.motion.dimension;
  if (!is_relative || !relative.motion.has_rotation || relative.translation_rows != d ||
      relative.rotation_rows != d * (d - 1) / 2)
    return refuse("an edge does not measure the pose of a vertex relative to another one: " + name(edge));
  if (pool.kernel(edge.slot) != nullptr) return refuse("an edge has a robust kernel: " + name(edge));
  const auto from = pose(vertices[relative.from]), to = pose(vertices[relative.to]);
  if (!from || !to) return false;
  if (problem_.dimension != d) return refuse("some poses are in the plane, and others are in space");
  add(edge, relative, *from, *to);
  return true;
}

/// The index of a pose. Empty if the vertex is no pose that can be certified; then `complaint` is set.
std::optional<std::uint32_t> Reader::pose(const VertexRef& vertex) {
  const auto [position, is_new] = index_.try_emplace(vertex, static_cast<std::uint32_t>(parent_.size()));
  if (!is_new) return position->second;
  const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
  const std::string id = std::to_string(graph_.id(vertex));
  detail::Frame frame;
  const auto complain = [&](const std::string& what) {
    complaint_ = what;
    return std::nullopt;
  };
  if (!pool.get_frame(vertex.slot, frame) || !frame.has_rotation)
    return complain("vertex " + id + " is no pose");
  if (!graph_.fixed_directions(vertex).empty()) return complain("vertex " + id + " has fixed directions");
  if (!guess::is_finite(frame)) return complain("the estimate of vertex " + id + " is not finite");
  if (problem_.dimension == 0) problem_.dimension = frame.dimension;
  if (problem_.dimension != frame.dimension)
    return complain("some poses are in the plane, and others are in space");
  problem_.vertices.push_back(vertex);
  parent_.push_back(position->second);
  return position->second;
}

/// d / tr(Ω⁻¹), or the mean of the diagonal if Ω is singular.
double harmonic_mean(const Eigen::MatrixXd& omega) {
  const Eigen::LLT<Eigen::MatrixXd> factor(omega);
  const Eigen::Index n = omega.rows();
  const double trace =
      factor.info() == Eigen::Success ? factor.solve(Eigen::MatrixXd::Identity(n, n)).trace() : 0;
  const double mean = static_cast<double>(n) / trace;
  return trace > 0 && std::isfinite(mean) ? mean : omega.diagonal().mean();
}

void Reader::add(const EdgeRef& edge, const detail::RelativeFrame& relative, std::uint32_t from,
                 std::uint32_t to) {
  const int d = problem_.dimension;
  const Eigen::MatrixXd omega = graph_.information(edge).matrix();
  const double unit = relative.rotation_unit;
  const double tau = harmonic_mean(omega.block(relative.translation_row, relative.translation_row, d, d));
  const Eigen::MatrixXd rotation = unit * unit *
                                   omega.block(relative.rotation_row, relative.rotation_row,
                                               relative.rotation_rows, relative.rotation_rows);
  ChordalEdge result{from, to, Block::Zero(d + 1, d + 1), Block::Zero(d + 1, d + 1)};
  result.motion.topLeftCorner(d, d) = guess::rotation_of(relative.motion).transpose();
  result.motion.bottomLeftCorner(1, d) = guess::translation_of(relative.motion).transpose();
  result.motion(d, d) = 1;
  result.weight.topLeftCorner(d, d) = Eigen::MatrixXd::Identity(d, d) * (rotation.trace() / 2);
  if (d == 3) result.weight.topLeftCorner(d, d) -= rotation;
  result.weight(d, d) = tau;
  problem_.relation = std::max(problem_.relation, relation(edge, omega, relative, tau));
  problem_.edges.push_back(result);
  problem_.refs.push_back(edge);
  parent_[root(from)] = root(to);
}

/// Whether the edge's cost is eᵀΩe. Deviations of up to 1e-8 are allowed, because files contain rounded Ω.
Relation Reader::relation(const EdgeRef& edge, const Eigen::MatrixXd& omega,
                          const detail::RelativeFrame& relative, double tau) const {
  constexpr double kRounding = 1e-8;
  const int d = problem_.dimension;
  const auto translation = omega.block(relative.translation_row, relative.translation_row, d, d);
  const Eigen::MatrixXd deviation = translation - tau * Eigen::MatrixXd::Identity(d, d);
  if (deviation.cwiseAbs().maxCoeff() > kRounding * tau) return Relation::kSimilar;
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < relative.rotation_rows; ++j) {
      const int row = relative.translation_row + i, column = relative.rotation_row + j;
      const double scale = std::sqrt(omega(row, row) * omega(column, column));
      if (std::abs(omega(row, column)) > kRounding * scale) return Relation::kSimilar;
    }
  }
  const std::string_view type = graph_.edge_pools()[edge.pool]->type_name();
  if (type == "Between<SE3>") return Relation::kEqual;
  return type == "Between<SE2>" ? Relation::kBelow : Relation::kSimilar;
}

std::uint32_t Reader::root(std::uint32_t node) {
  while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
  return node;
}

/// Pins the fixed vertex of each component, or its first vertex.
bool Reader::pin_components() {
  const auto count = static_cast<std::uint32_t>(parent_.size());
  std::vector<std::uint32_t> pinned(count, ChordalProblem::kPinned);
  for (std::uint32_t node = 0; node < count; ++node) {
    if (!graph_.is_fixed(problem_.vertices[node])) continue;
    std::uint32_t& pin = pinned[root(node)];
    if (pin != ChordalProblem::kPinned) {
      return refuse("several vertices are fixed, such as " +
                    std::to_string(graph_.id(problem_.vertices[pin])) + " and " +
                    std::to_string(graph_.id(problem_.vertices[node])));
    }
    pin = node;
  }
  problem_.block.assign(count, ChordalProblem::kPinned);
  for (std::uint32_t node = 0; node < count; ++node) {
    std::uint32_t& pin = pinned[root(node)];
    if (pin == ChordalProblem::kPinned) pin = node;
    detail::Frame frame;
    const VertexRef& vertex = problem_.vertices[pin];
    graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame);
    problem_.pin.push_back(pin);
    problem_.offset.push_back(guess::translation_of(frame).norm());
    if (pin == node) continue;
    problem_.block[node] = static_cast<std::uint32_t>(problem_.moving.size());
    problem_.moving.push_back(node);
  }
  return true;
}

}  // namespace

bool read_problem(const Graph& graph, const Options& options, ChordalProblem& problem,
                  std::string& complaint) {
  return Reader(graph, problem, complaint).read(options);
}

}  // namespace boxplus::certificate
