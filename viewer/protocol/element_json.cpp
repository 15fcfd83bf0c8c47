// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/protocol/element_json.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const EdgeFacts& edge, const Verdicts& verdicts) {
  const std::optional<Verdict> verdict = verdicts.of(edge.edge);
  Json ends = Json::array();
  for (const EdgeFacts::End& end : edge.ends) {
    ends.push_back({{"id", std::to_string(end.id)},
                    {"type", end.type},
                    {"is_parameter", end.is_parameter},
                    {"vertex", or_null(end.number)}});
  }
  return {{"kind", "edge"},
          {"edge", edge.number},
          {"line", or_null(edge.line)},
          {"type", edge.type},
          {"tag", edge.tag},
          {"fields", edge.fields},
          {"vertices", ends},
          {"vertex_count", edge.vertices},
          {"rows", edge.rows},
          {"level", edge.level},
          {"error", edge.error},
          {"chi2", edge.chi2},
          {"chi2_per_row", edge.chi2_per_row()},
          {"weight", edge.weight},
          {"kernel", edge.kernel},
          {"is_enabled", edge.is_enabled},
          {"verdict", verdict ? Json(to_string(*verdict)) : Json(nullptr)}};
}

Json json_of(const VertexFacts& vertex, const Verdicts& verdicts) {
  Json edges = Json::array();
  for (const EdgeFacts& edge : vertex.edges) edges.push_back(json_of(edge, verdicts));
  return {{"kind", "vertex"},
          {"id", std::to_string(vertex.id)},
          {"vertex", or_null(vertex.number)},
          {"type", vertex.type},
          {"tag", vertex.tag},
          {"estimate", vertex.estimate},
          {"is_fixed", vertex.is_fixed},
          {"fixed_directions", vertex.fixed_directions},
          {"edge_count", vertex.edge_count},
          {"edges", edges}};
}

}  // namespace

std::string element_json(const Graph& graph, const Structure& structure, const ElementName& name,
                         std::uint64_t structure_number, const Verdicts& verdicts) {
  const Element element = find_element(graph, structure, name);
  Json json = std::visit([&](const auto& ref) { return json_of(facts_of(graph, structure, ref), verdicts); },
                         element);
  json["structure"] = structure_number;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace boxplus::viewer
