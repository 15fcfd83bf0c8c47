// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/diagnosis_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "viewer/scene/element.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

/// The drawn vertices of a finding, and those of its edges, in ascending order.
std::vector<std::uint32_t> marked_vertices(const Graph& graph, const Structure& structure,
                                           const Finding& finding) {
  std::vector<std::uint32_t> marked;
  const auto mark = [&](std::span<const VertexRef> vertices) {
    for (const VertexRef& vertex : vertices) {
      if (marked.size() == kMostMarked) return;
      if (const auto number = number_of(structure, vertex)) marked.push_back(*number);
    }
  };
  mark(finding.vertices);
  for (const EdgeRef& edge : finding.edges) mark(graph.vertices(edge));
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  return marked;
}

/// The name of the element if there is only one.
Json only_element(const Graph& graph, const Finding& finding) {
  if (finding.edges.size() == 1)
    return {{"key", "edge"}, {"number", std::to_string(number_of(graph, finding.edges.front()))}};
  if (finding.edges.empty() && finding.ids.size() == 1)
    return {{"key", "id"}, {"number", std::to_string(finding.ids.front())}};
  return nullptr;
}

}  // namespace

std::string diagnosis_json(const Graph& graph, const Structure& structure, const Diagnosis& diagnosis,
                           std::uint64_t structure_number) {
  Json findings = Json::array();
  for (const Finding& finding : diagnosis.findings) {
    if (findings.size() == kMostFindings) break;
    findings.push_back({{"severity", to_string(finding.severity)},
                        {"kind", to_string(finding.kind)},
                        {"text", finding.text},
                        {"element", only_element(graph, finding)},
                        {"marked", marked_vertices(graph, structure, finding)}});
  }
  const Json json = {
      {"structure", structure_number}, {"count", diagnosis.findings.size()}, {"findings", findings}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxplus::viewer
