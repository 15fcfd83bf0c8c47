// SPDX-License-Identifier: BSD-3-Clause
#include "io/gnuplot/gnuplot_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "boxplus/base/error.h"
#include "boxplus/manifold/quaternion.h"
#include "graph/graph_view.h"
#include "io/text_pieces.h"

namespace boxplus {
namespace {

constexpr std::string_view kTitle = "# gnuplot data of a graph, written by boxplus";

/// The frame of a vertex, unless it is a parameter or has no finite position.
std::optional<detail::Frame> frame_of(const Graph& graph, VertexRef vertex) {
  detail::Frame frame;
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  if (pool.parameter(vertex.slot) || !pool.get_frame(vertex.slot, frame)) return std::nullopt;
  const bool is_finite = std::all_of(frame.translation.begin(), frame.translation.begin() + frame.dimension,
                                     [](double x) { return std::isfinite(x); });
  return is_finite ? std::optional(frame) : std::nullopt;
}

/// Writes data sets in pieces.
class GnuplotWriter {
 public:
  GnuplotWriter(const Graph& graph, TextSink sink)
      : graph_(graph), role_(graph), out_(sink), vertices_(graph.all_vertices()), edges_(graph.all_edges()) {
    for (const VertexRef& vertex : vertices_) {
      if (const auto frame = frame_of(graph_, vertex)) dimension_ = std::max(dimension_, frame->dimension);
    }
    if (dimension_ == 0) {
      throw InvalidArgument(
          "cannot write .gnuplot: expected poses or points with finite positions, got none");
    }
  }

  void write() {
    out_.add("{}\n# poses: id {}, points: id {}, edges: {} of both ends\n", kTitle,
             dimension_ == 2 ? "x y theta" : "x y z qx qy qz qw", dimension_ == 2 ? "x y" : "x y z",
             dimension_ == 2 ? "x y" : "x y z");
    out_.add("# plot FILE index 'odometry' using 1:2 with lines, '' index 'points' using 2:3 with points\n");
    add_vertices("poses", true);
    add_vertices("points", false);
    add_edges("odometry", [](EdgeRole role) { return role == EdgeRole::kOdometry; });
    add_edges("closures", [](EdgeRole role) { return role == EdgeRole::kLoopClosure; });
    add_edges("observations",
              [](EdgeRole role) { return role != EdgeRole::kOdometry && role != EdgeRole::kLoopClosure; });
    out_.flush();
  }

 private:
  /// Two blank lines end the data set before this one.
  void begin(const char* name) { out_.add("\n\n# {}\n", name); }

  void add_position(const detail::Frame& frame) {
    out_.add("{} {}", frame.translation[0], frame.translation[1]);
    if (dimension_ == 3) out_.add(" {}", frame.translation[2]);
  }

  void add_vertices(const char* name, bool poses) {
    bool is_first = true;
    for (const VertexRef& vertex : vertices_) {
      const auto frame = frame_of(graph_, vertex);
      if (!frame || frame->has_rotation != poses) continue;
      if (is_first) begin(name);
      is_first = false;
      out_.add("{} ", graph_.id(vertex));
      add_position(*frame);
      if (poses) add_rotation(*frame);
      out_.add("\n");
    }
  }

  void add_rotation(const detail::Frame& frame) {
    const std::array<double, 9>& R = frame.rotation;
    if (dimension_ == 2) return out_.add(" {}", std::atan2(R[2], R[0]));
    Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
    const auto rows = static_cast<std::size_t>(frame.dimension);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < rows; ++j)
        rotation(static_cast<int>(i), static_cast<int>(j)) = R[rows * i + j];
    }
    const auto q = detail::quaternion_of(rotation);
    out_.add(" {} {} {} {}", q.x, q.y, q.z, q.w);
  }

  /// The frames of the vertices of an edge that have a position.
  std::vector<detail::Frame> ends_of(EdgeRef edge) const {
    std::vector<detail::Frame> ends;
    for (const VertexRef& vertex : graph_.vertices(edge)) {
      if (const auto frame = frame_of(graph_, vertex)) ends.push_back(*frame);
    }
    return ends;
  }

  void add_edges(const char* name, bool (*has_role)(EdgeRole)) {
    bool is_first = true;
    for (const EdgeRef& edge : edges_) {
      if (!has_role(role_(edge))) continue;
      const std::vector<detail::Frame> ends = ends_of(edge);
      if (ends.size() < 2) continue;
      if (is_first) begin(name);
      is_first = false;
      for (std::size_t k = 1; k < ends.size(); ++k) {
        add_position(ends[0]);
        out_.add("\n");
        add_position(ends[k]);
        out_.add("\n\n");
      }
    }
  }

  const Graph& graph_;
  EdgeRoles role_;
  TextPieces out_;
  std::vector<VertexRef> vertices_;
  std::vector<EdgeRef> edges_;
  int dimension_ = 0;
};

}  // namespace

FileFormat gnuplot_format() {
  return {.name = "gnuplot",
          .extension = ".gnuplot",
          .recognize = [](std::string_view text) { return text.starts_with(kTitle); },
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { GnuplotWriter(file.graph, sink).write(); }};
}

}  // namespace boxplus
