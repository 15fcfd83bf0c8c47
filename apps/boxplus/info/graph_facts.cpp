// SPDX-License-Identifier: BSD-3-Clause
#include "info/graph_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "boxplus/base/error.h"
#include "boxplus/io/data.h"
#include "boxplus/io/registry.h"
#include "optimize/optimize_run.h"
#include "plan/plan.h"

namespace boxplus::app {
namespace {

std::string tag_or_type(const Graph& graph, VertexRef vertex) {
  const Tag* tag = default_registry().tag_of(graph, vertex);
  return tag ? tag->name : std::string(graph.vertex_pools()[vertex.pool]->type_name());
}

std::string tag_or_type(const Graph& graph, EdgeRef edge) {
  const Tag* tag = default_registry().tag_of(graph, edge);
  return tag ? tag->name : std::string(graph.edge_pools()[edge.pool]->type_name());
}

/// Returns the sort key for the worst edges: chi2, or infinity if chi2 is NaN.
double badness(double chi2) {
  return std::isnan(chi2) ? std::numeric_limits<double>::infinity() : chi2;
}

EdgeFacts facts_of(const Graph& graph, EdgeRef edge) {
  EdgeFacts facts{edge, tag_or_type(graph, edge), {}, graph.chi2(edge), 0};
  for (const VertexRef& vertex : graph.vertices(edge)) {
    if (!graph.vertex_pools()[vertex.pool]->parameter(vertex.slot))
      facts.vertices.push_back(graph.id(vertex));
  }
  return facts;
}

/// The number of edges of each vertex and parameter, by number.
std::vector<std::size_t> count_degrees(const GraphView& view) {
  std::vector<std::size_t> degrees(view.numbers(), 0);
  for (const EdgeRef& edge : view.graph().all_edges()) {
    view.for_each_vertex(edge.pool, edge.slot, [&](std::uint32_t pool, std::uint32_t slot, std::size_t) {
      ++degrees[view.number(pool, slot)];
    });
  }
  return degrees;
}

void add_vertex(const Graph& graph, VertexRef vertex, std::size_t degree, VertexTypeFacts& type) {
  type.degrees.min = type.count == 0 ? degree : std::min(type.degrees.min, degree);
  type.degrees.max = std::max(type.degrees.max, degree);
  type.degrees.mean += static_cast<double>(degree);  // the sum; find_vertex_types() divides it by the count
  ++type.count;
  type.fixed += graph.is_fixed(vertex);
}

void find_vertex_types(const Graph& graph, const Plan& plan, GraphFacts& facts) {
  const GraphView view(graph);
  const std::vector<std::size_t> degrees = count_degrees(view);
  std::map<std::pair<bool, std::string>, VertexTypeFacts> types;
  const auto add_all = [&](const std::vector<VertexRef>& vertices, bool parameters) {
    for (const VertexRef& vertex : vertices) {
      VertexTypeFacts& type = types[{parameters, tag_or_type(graph, vertex)}];
      type.role = role_of(graph, vertex);
      add_vertex(graph, vertex, degrees[view.number(vertex)], type);
    }
  };
  add_all(graph.all_vertices(), false);
  add_all(graph.all_parameters(), true);
  for (const VertexRef& vertex : plan.block_vertex) {
    const bool parameter = graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
    types[{parameter, tag_or_type(graph, vertex)}].unknowns +=
        static_cast<std::size_t>(graph.tangent_dim(vertex)) - graph.fixed_directions(vertex).size();
  }
  for (auto& [key, type] : types) {
    std::tie(type.parameter, type.tag) = key;
    type.degrees.mean /= static_cast<double>(type.count);
    facts.unknowns += type.unknowns;
    facts.vertex_types.push_back(std::move(type));
  }
}

void find_extent(const Graph& graph, GraphFacts& facts) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) continue;
    facts.dimension = std::max(facts.dimension, frame.dimension);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(frame.dimension); ++axis) {
      low[axis] = std::min(low[axis], frame.translation[axis]);
      high[axis] = std::max(high[axis], frame.translation[axis]);
    }
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(facts.dimension); ++axis)
    facts.extent[axis] = high[axis] - low[axis];
}

void find_edge_types(const Graph& graph, const std::vector<EdgeFacts>& edges, GraphFacts& facts) {
  std::map<std::string, EdgeTypeFacts> types;
  for (const EdgeFacts& edge : edges) {
    EdgeTypeFacts& type = types[edge.tag];
    if (type.count++ == 0 || badness(edge.chi2) > badness(type.worst.chi2)) type.worst = edge;
    type.rows += static_cast<std::size_t>(graph.edge_pools()[edge.edge.pool]->shape(edge.edge.slot).rows);
    type.chi2 += edge.chi2;
  }
  for (auto& [tag, type] : types) {
    type.tag = tag;
    facts.rows += type.rows;
    facts.edge_types.push_back(std::move(type));
  }
}

/// Returns the `count` edges with the largest chi2, the worst one first.
std::vector<EdgeFacts> worst_of(std::vector<EdgeFacts> edges, std::size_t count) {
  const auto end = edges.begin() + static_cast<std::ptrdiff_t>(std::min(count, edges.size()));
  std::partial_sort(edges.begin(), end, edges.end(), [](const EdgeFacts& a, const EdgeFacts& b) {
    return std::pair(-badness(a.chi2), a.edge) < std::pair(-badness(b.chi2), b.edge);
  });
  edges.erase(end, edges.end());
  return edges;
}

/// Finds the facts about single edges, with their lines.
class EdgeFinder {
 public:
  EdgeFinder(const GraphFile& file, const std::vector<std::int64_t>& edge_lines) : graph_(file.graph) {
    for (std::size_t k = 0; k < edge_lines.size(); ++k) line_of_.emplace(file.edges[k], edge_lines[k]);
  }
  EdgeFacts operator()(EdgeRef edge) const {
    EdgeFacts facts = facts_of(graph_, edge);
    if (const auto line = line_of_.find(edge); line != line_of_.end()) facts.line = line->second;
    return facts;
  }

 private:
  const Graph& graph_;
  std::map<EdgeRef, std::int64_t> line_of_;
};

}  // namespace

GraphFacts find_facts(const GraphFile& file, const std::vector<std::int64_t>& edge_lines, std::size_t worst) {
  const Graph& graph = file.graph;
  GraphFacts facts;
  facts.vertices = graph.vertex_count();
  facts.parameters = graph.parameter_count();
  facts.edges = graph.edge_count();
  facts.indefinite = static_cast<std::size_t>(file.indefinite);
  facts.chi2 = graph.chi2();
  const Plan plan = make_plan(graph, {});
  find_vertex_types(graph, plan, facts);
  find_extent(graph, facts);
  const EdgeRoles role(graph);
  std::vector<EdgeFacts> edges;
  for (std::size_t k = 0; k < file.edges.size(); ++k) {
    edges.push_back(facts_of(graph, file.edges[k]));
    if (!edge_lines.empty()) edges.back().line = edge_lines[k];
    ++facts.roles[static_cast<std::size_t>(role(file.edges[k]))];
  }
  find_edge_types(graph, edges, facts);
  facts.worst = worst_of(std::move(edges), worst);
  Components components = find_components(graph, plan, role);
  facts.components = std::move(components.with_edges);
  facts.isolated = std::move(components.isolated);
  for (const GraphFile::KeptLine& line : file.kept) {
    if (const std::string_view tag = data_tag_of(line.text); !tag.empty()) ++facts.data[std::string(tag)];
  }
  return facts;
}

DiagnosisFacts find_diagnosis(const GraphFile& file, const std::vector<std::int64_t>& edge_lines) {
  Diagnosis diagnosis = diagnose(file.graph);
  const EdgeFinder find_edge(file, edge_lines);
  DiagnosisFacts facts;
  facts.at_minimum = diagnosis.at_minimum;
  for (Finding& finding : diagnosis.findings) {
    FindingFacts& added = facts.findings.emplace_back();
    for (const EdgeRef& edge : finding.edges) added.edges.push_back(find_edge(edge));
    added.finding = std::move(finding);
  }
  return facts;
}

OutlierFacts find_false_edges(const GraphFile& file, const std::vector<std::int64_t>& edge_lines,
                              const Options& options, Suspects suspects) {
  constexpr std::size_t kShown = 10;
  OutlierFacts facts;
  Graph graph = file.graph;
  Progress progress(choose_progress(false, false));
  try {
    facts.found = run_find_outliers(graph, options, suspects, progress);
  } catch (const InvalidArgument& error) {
    facts.obstacle = error.what();
    return facts;
  }
  const EdgeFinder find_edge(file, edge_lines);
  std::vector<EdgeFacts> outliers;
  for (const EdgeVerdict& edge : facts.found->verdicts) {
    if (edge.verdict != Verdict::kOutlier) continue;
    outliers.push_back(find_edge(edge.edge));
    outliers.back().chi2 = edge.chi2;
  }
  facts.worst = worst_of(std::move(outliers), kShown);
  return facts;
}

}  // namespace boxplus::app
