// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/field_reader.h"
#include "io/bal/bal_format.h"
#include "io/bal/bal_from_model.h"
#include "io/bal/bal_pose.h"
#include "io/edges_to_write.h"
#include "io/model/camera_types.h"
#include "io/model/graph_model.h"
#include "io/model/graph_roles.h"
#include "io/moderate_pose.h"
#include "io/reprojection_losses.h"
#include "io/written_errors.h"

namespace boxplus {
namespace {

using BalEdgePool = detail::TypedEdgePool<BalEdge, BalVertex, Vector3>;

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidArgument(
      "cannot write BAL's .bal: expected vertices Product<SE3, BalCamera> and Vector3, and edges "
      "Reprojection<BalCamera> between them, got " +
      what);
}

bool has_colmap_cameras(const Graph& graph) {
  const auto pools = graph.vertex_pools();
  return std::any_of(pools.begin(), pools.end(),
                     [](const auto& pool) { return camera_type_of(*pool) && pool->alive_count() > 0; });
}

std::size_t count_images_with_offset(const Graph& graph) {
  const GraphRoles roles(graph);
  std::set<std::pair<VertexRef, VertexRef>> images;  // the vertex of the image and its offset
  for (const EdgeRef& edge : graph.all_edges()) {
    const std::optional<PixelObservation> seen = roles.observation(edge);
    if (seen && seen->offset) images.insert({seen->image, *seen->offset});
  }
  return images.size();
}

bool is_bal_edge(const Graph& graph, EdgeRef edge) {
  return dynamic_cast<const BalEdgePool*>(graph.edge_pools()[edge.pool].get()) != nullptr;
}

/// Collects lines, and passes them on in larger pieces.
class Pieces {
 public:
  explicit Pieces(TextSink sink) : sink_(sink), out_(text_) {}

  /// Writes numbers, of which the first ones are integers.
  void line(std::span<const double> numbers, std::size_t integers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      i < integers ? out_.integer(static_cast<std::int64_t>(numbers[i])) : out_.number(numbers[i]);
    out_.end_line();
    if (text_.size() >= kPiece) end();
  }
  void lines(const Vector3& values) {
    for (const double& value : values) line(std::span(&value, 1), 0);
  }
  void end() {
    if (!text_.empty()) sink_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 18;
  TextSink sink_;
  std::string text_;
  FieldWriter out_;
};

class BalWriter {
 public:
  explicit BalWriter(const GraphFileView& file) : graph_(file.graph), edges_(edges_to_write(file)) {
    std::erase_if(edges_, [&](EdgeRef edge) { return edge == EdgeRef{} || !is_bal_edge(graph_, edge); });
    if (graph_.parameter_count() > 0) refuse("a parameter");
    for (const auto& pool : graph_.vertex_pools()) index_.emplace_back(pool->slots());
    for (const VertexRef& vertex : graph_.all_vertices()) number(vertex);
    check_errors();
  }

  void write(TextSink sink) const {
    Pieces out(sink);
    const auto size = [](const auto& elements) { return static_cast<double>(elements.size()); };
    out.line({{size(cameras_), size(points_), size(edges_)}}, 3);
    for (const EdgeRef& edge : edges_) write_edge(edge, out);
    write_vertices(out);
    out.end();
  }

  /// The edges are those of a text.
  void write_with_edges_of(const TextSource& text, const ReadOptions& options, TextSink sink) const {
    Pieces out(sink);
    visit_bal(text, options,
              {[&](std::span<const double> counts) { out.line(counts, 3); },
               [&](std::span<const double> observation) { out.line(observation, 2); }});
    write_vertices(out);
    out.end();
  }

 private:
  /// Gives a vertex the next index among the cameras or among the points.
  void number(const VertexRef& vertex) {
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    const bool is_camera = dynamic_cast<const detail::TypedVertexPool<BalVertex>*>(&pool) != nullptr;
    if (!is_camera && !dynamic_cast<const detail::TypedVertexPool<Vector3>*>(&pool))
      refuse(fmt::format("vertex {} of type {}", graph_.id(vertex), pool.type_name()));
    std::vector<VertexRef>& list = is_camera ? cameras_ : points_;
    index_[vertex.pool][vertex.slot] = static_cast<std::int64_t>(list.size());
    list.push_back(vertex);
  }

  /// Refuses a graph if a reader of the file would have other poses or errors.
  void check_errors() const {
    std::vector<BalVertex> read;
    for (const VertexRef& vertex : cameras_) {
      const BalVertex& camera = graph_.estimate(graph_.typed<BalVertex>(vertex));
      read.emplace_back(BalPose(camera.get<0>()).T_world_camera(), camera.get<1>());
      if (!is_moderate(read.back().get<0>()))
        refuse(fmt::format("vertex {} with a pose that overflows", graph_.id(vertex)));
    }
    for (const EdgeRef& edge : edges_) {
      const auto& pool = static_cast<const BalEdgePool&>(*graph_.edge_pools()[edge.pool]);
      const BalEdge& observation = pool.value(edge.slot);
      const std::vector<VertexRef> vertices = graph_.vertices(edge);
      const Vector3& point = graph_.estimate(graph_.typed<Vector3>(vertices[1]));
      const auto camera = static_cast<std::size_t>(index_[vertices[0].pool][vertices[0].slot]);
      require_equal_error("BAL's .bal", {"camera", graph_.id(vertices[0]), graph_.id(vertices[1])},
                          observation.error(graph_.estimate(graph_.typed<BalVertex>(vertices[0])), point),
                          observation.error(read[camera], point));
    }
  }

  void write_edge(const EdgeRef& edge, Pieces& out) const {
    const auto& pool = static_cast<const BalEdgePool&>(*graph_.edge_pools()[edge.pool]);
    std::array<double, 4> line;
    std::size_t count = 0;
    for (const VertexRef& vertex : graph_.vertices(edge))
      line[count++] = static_cast<double>(index_[vertex.pool][vertex.slot]);
    for (const double pixel : pool.value(edge.slot).measurement) line[count++] = pixel;
    out.line(line, 2);
  }

  void write_vertices(Pieces& out) const {
    for (const VertexRef& vertex : cameras_) {
      const BalVertex& camera = graph_.estimate(graph_.typed<BalVertex>(vertex));
      const BalPose pose(camera.get<0>());
      for (const Vector3& values : {pose.rotation, pose.translation, Vector3(camera.get<1>().parameters)})
        out.lines(values);
    }
    for (const VertexRef& point : points_) out.lines(graph_.estimate(graph_.typed<Vector3>(point)));
  }

  const Graph& graph_;
  std::vector<EdgeRef> edges_;
  std::vector<VertexRef> cameras_, points_;
  std::vector<std::vector<std::int64_t>> index_;  // among the cameras or points, by vertex pool and slot
};

}  // namespace

void write_bal(const GraphFileView& file, const WriteOptions& /*options*/, TextSink sink) {
  if (!has_colmap_cameras(file.graph)) return BalWriter(file).write(sink);
  const GraphFile converted = bal_from_model(model_of(file));
  BalWriter({converted.graph, converted.edges}).write(sink);
}

void write_bal_vertices(const Graph& vertices, const TextSource& text, const ReadOptions& options,
                        TextSink sink) {
  BalWriter({vertices}).write_with_edges_of(text, options, sink);
}

std::vector<std::string> bal_losses(const GraphFileView& file) {
  if (!has_colmap_cameras(file.graph))
    return reprojection_losses(file.graph, [&](EdgeRef edge) { return is_bal_edge(file.graph, edge); });
  std::vector<std::string> sentences = model_losses(file);
  const std::size_t images = count_images_with_offset(file.graph);
  if (images > 0)
    sentences.push_back(images == 1 ? "the rig of 1 image" : fmt::format("the rigs of {} images", images));
  return sentences;
}

}  // namespace boxplus
