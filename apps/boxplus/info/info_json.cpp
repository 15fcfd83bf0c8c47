// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "info/info_text.h"
#include "optimize/outlier_search.h"

namespace boxplus::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(VertexRole role) {
  switch (role) {
    case VertexRole::kPose:
      return "pose";
    case VertexRole::kLandmark:
      return "landmark";
    default:
      return "other";
  }
}

Json edge_json(const EdgeFacts& edge) {
  return {{"tag", edge.tag},
          {"vertices", edge.vertices},
          {"chi2", edge.chi2},
          {"line", edge.line > 0 ? Json(edge.line) : Json(nullptr)}};
}

Json vertex_types_json(const GraphFacts& facts) {
  Json result = Json::array();
  for (const VertexTypeFacts& type : facts.vertex_types) {
    result.push_back({{"tag", type.tag},
                      {"role", type.parameter ? "parameter" : name_of(type.role)},
                      {"count", type.count},
                      {"fixed", type.fixed},
                      {"unknowns", type.unknowns},
                      {"degree_min", type.degrees.min},
                      {"degree_mean", type.degrees.mean},
                      {"degree_max", type.degrees.max}});
  }
  return result;
}

Json edge_types_json(const GraphFacts& facts) {
  Json result = Json::array();
  for (const EdgeTypeFacts& type : facts.edge_types) {
    result.push_back({{"tag", type.tag},
                      {"count", type.count},
                      {"rows", type.rows},
                      {"chi2", type.chi2},
                      {"worst", edge_json(type.worst)}});
  }
  return result;
}

Json components_json(const GraphFacts& facts) {
  Json result = Json::array();
  for (const ComponentFacts& component : facts.components) {
    result.push_back({{"first", component.first},
                      {"vertices", component.vertices},
                      {"edges", component.edges},
                      {"fixed", component.fixed},
                      {"priors", component.priors},
                      {"held", component.held},
                      {"free", component.free}});
  }
  return result;
}

Json roles_json(const GraphFacts& facts) {
  const auto count = [&](EdgeRole role) { return facts.roles[static_cast<std::size_t>(role)]; };
  return {{"odometry", count(EdgeRole::kOdometry)},
          {"loop_closures", count(EdgeRole::kLoopClosure)},
          {"observations", count(EdgeRole::kObservation)},
          {"priors", count(EdgeRole::kPrior)},
          {"others", count(EdgeRole::kOther)}};
}

Json kernel_json(const GraphFacts& facts) {
  if (facts.kernel.name.empty()) return nullptr;
  return {{"name", facts.kernel.name}, {"edges", facts.kernel.edges}, {"rejected", facts.rejected}};
}

Json extent_json(const GraphFacts& facts) {
  Json result = Json::array();
  for (int axis = 0; axis < facts.dimension; ++axis)
    result.push_back(facts.extent[static_cast<std::size_t>(axis)]);
  return result;
}

Json notes_json(const GraphFile& file) {
  Json result = Json::array();
  for (const GraphFile::Note& note : file.notes) {
    result.push_back(
        {{"line", note.line}, {"column", note.column}, {"skipped", note.skipped}, {"text", note.text}});
  }
  return result;
}

Json direction_json(const Graph& graph, const Finding::Direction& direction) {
  switch (direction.kind) {
    case Finding::Direction::Kind::kAlong:
      return {{"kind", "along"}, {"axis", direction.axis}};
    case Finding::Direction::Kind::kAbout:
      return {{"kind", "about"}, {"axis", direction.axis}};
    case Finding::Direction::Kind::kScale:
      return {{"kind", "scale"}};
    default:
      return {{"kind", "tangent"}, {"vertex", graph.id(direction.vertex)}, {"tangent", direction.tangent}};
  }
}

Json diagnosis_json(const GraphFacts& facts, const Graph& graph) {
  if (!facts.diagnosis) return nullptr;
  Json findings = Json::array();
  for (const FindingFacts& facts_of_finding : facts.diagnosis->findings) {
    const Finding& finding = facts_of_finding.finding;
    Json edges = Json::array(), directions = Json::array();
    for (const EdgeFacts& edge : facts_of_finding.edges) edges.push_back(edge_json(edge));
    for (const Finding::Direction& direction : finding.directions)
      directions.push_back(direction_json(graph, direction));
    findings.push_back({{"kind", to_string(finding.kind)},
                        {"severity", to_string(finding.severity)},
                        {"text", finding.text},
                        {"vertices", finding.ids},
                        {"edges", edges},
                        {"directions", directions}});
  }
  return {{"at_minimum", facts.diagnosis->at_minimum}, {"findings", findings}};
}

}  // namespace

std::string facts_json(const GraphFacts& facts, const GraphFile& file, const std::string& name) {
  Json worst = Json::array();
  for (const EdgeFacts& edge : facts.worst) worst.push_back(edge_json(edge));
  Json outliers, obstacle;
  if (facts.outliers && facts.outliers->found) outliers = outliers_json(*facts.outliers->found);
  if (facts.outliers && !facts.outliers->found) obstacle = facts.outliers->obstacle;
  const Json json = {{"input", name},
                     {"vertices", facts.vertices},
                     {"parameters", facts.parameters},
                     {"edges", facts.edges},
                     {"unknowns", facts.unknowns},
                     {"rows", facts.rows},
                     {"chi2", facts.chi2},
                     {"kernel", kernel_json(facts)},
                     {"extent", extent_json(facts)},
                     {"edge_roles", roles_json(facts)},
                     {"vertex_types", vertex_types_json(facts)},
                     {"edge_types", edge_types_json(facts)},
                     {"components", components_json(facts)},
                     {"isolated", facts.isolated},
                     {"worst_edges", worst},
                     {"diagnosis", diagnosis_json(facts, file.graph)},
                     {"outliers", outliers},
                     {"outliers_obstacle", obstacle},
                     {"data", facts.data},
                     {"kept_lines", file.kept.size()},
                     {"skipped_lines", file.skipped},
                     {"indefinite_edges", file.indefinite},
                     {"notes", notes_json(file)}};
  // Tags and notes may contain text from the file, so bytes that are not valid UTF-8 are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace boxplus::app
