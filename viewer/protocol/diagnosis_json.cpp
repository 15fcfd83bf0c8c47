// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/protocol/diagnosis_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "viewer/scene/element.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

void make_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// The drawn vertices of a finding, and those of its edges that have no line, such as priors.
Json marked_vertices(const Graph& graph, const Structure& structure, const Finding& finding) {
  std::vector<std::uint32_t> marked;
  const auto mark = [&](std::span<const VertexRef> vertices) {
    for (const VertexRef& vertex : vertices) {
      if (const auto number = number_of(structure, vertex)) marked.push_back(*number);
    }
  };
  mark(finding.vertices);
  for (const EdgeRef& edge : finding.edges) {
    if (lines_of(structure, edge).count == 0) mark(graph.vertices(edge));
  }
  make_unique(marked);
  const std::size_t count = marked.size();
  marked.resize(std::min(count, kMostMarked));
  return {{"count", count}, {"marked", marked}};
}

/// The lines of the drawn edges of a finding.
Json marked_edges(const Structure& structure, const Finding& finding) {
  std::size_t count = 0, marked = 0;
  std::vector<std::uint32_t> numbers;
  for (const EdgeRef& edge : finding.edges) {
    const Lines lines = lines_of(structure, edge);
    if (lines.count == 0) continue;
    ++count;
    if (numbers.size() + lines.count > kMostMarked) continue;
    ++marked;
    for (std::uint32_t k = 0; k < lines.count; ++k) numbers.push_back(lines.first + k);
  }
  make_unique(numbers);
  return {{"count", count}, {"marked", marked}, {"lines", numbers}};
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
                           std::uint64_t structure_number, std::size_t left_out) {
  Json findings = Json::array();
  for (const Finding& finding : diagnosis.findings) {
    if (findings.size() == kMostFindings) break;
    findings.push_back({{"severity", to_string(finding.severity)},
                        {"kind", to_string(finding.kind)},
                        {"text", finding.text},
                        {"element", only_element(graph, finding)},
                        {"vertices", marked_vertices(graph, structure, finding)},
                        {"edges", marked_edges(structure, finding)}});
  }
  const Json json = {{"structure", structure_number},
                     {"count", diagnosis.findings.size()},
                     {"findings", findings},
                     {"left_out", left_out}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxplus::viewer
