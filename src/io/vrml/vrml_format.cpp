// SPDX-License-Identifier: BSD-3-Clause
#include "io/vrml/vrml_format.h"

#include "io/ply/point_cloud.h"
#include "io/text_pieces.h"

namespace boxplus {
namespace {

constexpr std::string_view kTitle = "#VRML V2.0 utf8";
using Line = std::array<std::size_t, 2>;

/// The lines between the positions of the vertices of edges.
std::vector<Line> edge_lines(const Graph& graph, const PointCloud& cloud) {
  std::vector<Line> lines;
  for (const EdgeRef& edge : graph.all_edges()) {
    std::size_t from = PointCloud::kAbsent;
    for (const VertexRef& vertex : graph.vertices(edge)) {
      if (graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) continue;
      const std::size_t to = cloud.index_of(vertex);
      if (to == PointCloud::kAbsent) continue;
      if (from == PointCloud::kAbsent) {
        from = to;
      } else {
        lines.push_back({from, to});
      }
    }
  }
  return lines;
}

void add_points(const PointCloud& cloud, TextPieces& out) {
  out.add("Shape {{\n geometry PointSet {{\n  coord DEF positions Coordinate {{ point [\n");
  for (const PointCloud::Vertex& vertex : cloud.vertices)
    out.add("{} {} {},\n", vertex.position[0], vertex.position[1], vertex.position[2]);
  out.add("  ] }}\n  color Color {{ color [\n");
  constexpr double kWhite = 255;
  for (const PointCloud::Vertex& vertex : cloud.vertices) {
    out.add("{:.3g} {:.3g} {:.3g},\n", vertex.color[0] / kWhite, vertex.color[1] / kWhite,
            vertex.color[2] / kWhite);
  }
  out.add("  ] }}\n }}\n}}\n");
}

void add_lines(const std::vector<Line>& lines, std::string_view color, TextPieces& out) {
  if (lines.empty()) return;
  out.add(
      "Shape {{\n appearance Appearance {{ material Material {{ emissiveColor {} }} }}\n"
      " geometry IndexedLineSet {{\n  coord USE positions\n  coordIndex [\n",
      color);
  for (const auto& [from, to] : lines) out.add("{} {} -1,\n", from, to);
  out.add("  ]\n }}\n}}\n");
}

void write_vrml(const GraphFileView& file, TextSink sink) {
  const PointCloud cloud(file, "VRML's .wrl");
  TextPieces out(sink);
  out.add("{}\n# a graph, written by boxplus\n", kTitle);
  add_points(cloud, out);
  add_lines(cloud.lines, "0.85 0.28 0.06", out);
  if (cloud.lines.empty()) add_lines(edge_lines(file.graph, cloud), "0.4 0.45 0.5", out);
  out.flush();
}

}  // namespace

FileFormat vrml_format() {
  return {.name = "VRML",
          .extension = ".wrl",
          .recognize = [](std::string_view text) { return text.starts_with(kTitle); },
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { write_vrml(file, sink); }};
}

}  // namespace boxplus
