// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/uncertainty.h"

#include <fmt/format.h>

#include <algorithm>

#include "covariance/covariance_references.h"

namespace boxplus::viewer {
namespace {

/// Every drawn vertex, in the order of the structure.
std::vector<VertexRef> drawn_vertices(const Graph& graph, const Structure& structure) {
  std::vector<VertexRef> vertices;
  vertices.reserve(structure.count);
  for (const VertexGroup& group : structure.vertices) {
    const detail::VertexPool& pool = *graph.vertex_pools()[group.pool];
    for (const std::uint32_t slot : group.slots)
      vertices.push_back({group.pool, slot, pool.generation(slot)});
  }
  return vertices;
}

/// "vertex 7", "the vertices 7 and 20", or "the vertices 1, 2, … and 5 more".
std::string names_of(const Graph& graph, const std::vector<VertexRef>& vertices) {
  constexpr std::size_t kMostNames = 12;
  if (vertices.size() == 1) return fmt::format("vertex {}", graph.id(vertices.front()));
  const std::size_t last = std::min(vertices.size() - 1, kMostNames);
  std::string names = "the vertices ";
  for (std::size_t k = 0; k < last; ++k)
    names += fmt::format("{}{}", k == 0 ? "" : ", ", graph.id(vertices[k]));
  if (last + 1 == vertices.size()) return names + fmt::format(" and {}", graph.id(vertices.back()));
  return names + fmt::format(" and {} more", vertices.size() - last);
}

/// Says of which vertices the covariances are, and to which vertices they are relative.
std::string note_on(const Graph& graph, const std::vector<VertexRef>& references, std::size_t chosen,
                    std::size_t drawn) {
  std::string note =
      chosen < drawn ? fmt::format("covariances of {} positions, spread evenly over all {}", chosen, drawn)
                     : fmt::format("covariances of all {} positions", drawn);
  if (!references.empty()) note += ", relative to " + names_of(graph, references);
  if (references.size() > 1) note += " of their parts of the graph";
  return note;
}

}  // namespace

Eigen::MatrixXd position_covariance(const Graph& graph, VertexRef vertex, const Covariance& covariance) {
  detail::Frame frame;
  graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame);
  const int d = frame.dimension;
  // The first entries of the tangent vector of a pose or a point are its translation: for a pose in its own
  // frame, for a point in the world frame.
  const Eigen::MatrixXd own = covariance.of(vertex).topLeftCorner(d, d);
  if (!frame.has_rotation) return own;
  const Eigen::MatrixXd R =
      Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(frame.rotation.data(), d, d);
  return R * own * R.transpose();
}

Uncertainty read_uncertainty(const Graph& graph, const Structure& structure, const std::atomic<bool>& stop) {
  const std::vector<VertexRef> drawn = drawn_vertices(graph, structure);
  const std::size_t count = std::min<std::size_t>(drawn.size(), Uncertainty::kMostVertices);
  std::vector<std::uint32_t> numbers;
  std::vector<VertexRef> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    numbers.push_back(static_cast<std::uint32_t>(k * drawn.size() / count));
    chosen.push_back(drawn[numbers.back()]);
  }
  Options options;
  options.stop = &stop;
  const auto [covariance, references] = referenced_covariances(graph, chosen, options);
  if (!covariance.ok()) return {.note = covariance.message()};
  Uncertainty uncertainty{.note = note_on(graph, references, count, drawn.size()),
                          .vertices = std::move(numbers)};
  for (const VertexRef& vertex : chosen) {
    const Eigen::MatrixXd of_position = position_covariance(graph, vertex, covariance);
    Eigen::Matrix3d full = Eigen::Matrix3d::Zero();
    full.topLeftCorner(of_position.rows(), of_position.cols()) = of_position;
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column)
        uncertainty.covariances.push_back(static_cast<float>(full(row, column)));
    }
  }
  return uncertainty;
}

}  // namespace boxplus::viewer
