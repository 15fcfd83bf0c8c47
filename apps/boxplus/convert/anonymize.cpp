// SPDX-License-Identifier: BSD-3-Clause
#include "convert/anonymize.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxplus/io/field_reader.h"
#include "boxplus/io/registry.h"
#include "graph/graph_view.h"

namespace boxplus::app {
namespace {

/// The positions of the vertices of an edge that it has measured; none if the edge stays.
std::vector<std::size_t> measured_vertices(const Graph& graph, EdgeRef edge, const EdgeRoles& role_of_edge) {
  std::vector<std::size_t> poses, landmarks, others;
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (graph.vertex_pools()[vertices[i].pool]->parameter(vertices[i].slot)) continue;
    const VertexRole role = role_of(graph, vertices[i]);
    (role == VertexRole::kPose ? poses : role == VertexRole::kLandmark ? landmarks : others).push_back(i);
  }
  switch (role_of_edge(edge)) {
    case EdgeRole::kObservation:
      if (landmarks.empty()) return others;  // lines, segments, planes
      return poses.empty() ? std::vector{landmarks.back()} : landmarks;
    case EdgeRole::kLoopClosure:
      return {poses[1]};
    default:
      return {};
  }
}

/// The lines of all edges of a .g2o text that are part of the graph, in order.
std::vector<std::string_view> edge_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    FieldReader in({}, 0, line);
    if (in.at_end()) continue;
    const Tag* tag = default_registry().find(in.token("a tag"));
    if (tag && tag->kind == Tag::Kind::kEdge) lines.push_back(line);
  }
  return lines;
}

/// The line with −1 as the ids at these positions.
std::string with_hidden_ids(std::string_view line, const std::vector<std::size_t>& positions) {
  FieldReader in({}, 0, line);
  std::string text;
  FieldWriter out(text);
  out.token(in.token("a tag"));
  for (std::size_t i = 0; !in.at_end(); ++i) {
    const std::string_view field = in.token("a field");
    const bool is_hidden = std::find(positions.begin(), positions.end(), i) != positions.end();
    out.token(is_hidden ? "-1" : field);
  }
  return text;
}

}  // namespace

std::size_t anonymize(GraphFile& file) {
  Graph& graph = file.graph;
  GraphFile without_kept;  // so that all lines of edges are those of the graph
  without_kept.graph = graph;
  without_kept.edges = file.edges;
  const std::string text = format_graph(without_kept, {.format = "g2o"});
  const std::vector<std::string_view> lines = edge_lines(text);
  const EdgeRoles role_of_edge(graph);
  std::vector<GraphFile::KeptLine> kept;
  std::vector<EdgeRef> changed;
  for (std::size_t k = 0; k < file.edges.size(); ++k) {
    const auto positions = measured_vertices(graph, file.edges[k], role_of_edge);
    if (positions.empty()) continue;
    kept.push_back({GraphFile::KeptLine::Place::kAfterEdge, static_cast<std::int64_t>(k),
                    with_hidden_ids(lines.at(k), positions)});
    changed.push_back(file.edges[k]);
  }
  for (const EdgeRef& edge : changed) graph.remove(edge);
  // A line that followed an edge follows its changed line.
  kept.insert(kept.end(), std::make_move_iterator(file.kept.begin()),
              std::make_move_iterator(file.kept.end()));
  file.kept = std::move(kept);
  return changed.size();
}

}  // namespace boxplus::app
