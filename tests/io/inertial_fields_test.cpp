// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/inertial_fields.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "io/json/json_registry.h"

namespace boxplus {
namespace {

GraphFile read_lines_of_json(const std::string& text) {
  const Registry& registry = json_registry();
  return parse_graph(text, "g", {.registry = &registry});
}

std::string complaint_about(const std::string& text) {
  try {
    read_lines_of_json(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(InertialFields, ListTheMotionAndItsDependenceOnTheBiases) {
  const GraphFile file = read_lines_of_json(json_registry().example("EDGE_INERTIAL"));
  ASSERT_EQ(file.edges.size(), 1u);
  const InertialBetween& edge = file.graph.measurement(EdgeHandle<InertialBetween>{file.edges[0]});
  EXPECT_EQ(edge.motion.position, Vector3(1, 2, 3));
  EXPECT_EQ(edge.motion.rotation.z, 0.6);
  EXPECT_EQ(edge.motion.rotation.w, 0.8);
  EXPECT_EQ(edge.motion.velocity, Vector3(0.5, 0.25, -1));
  EXPECT_EQ(edge.motion.seconds, 0.5);
  EXPECT_EQ(edge.motion.bias[2], 0.03);
  EXPECT_EQ(edge.motion.bias_jacobian(0, 0), -0.5);
  EXPECT_EQ(edge.motion.bias_jacobian(0, 1), 0.125);
  EXPECT_EQ(edge.motion.bias_jacobian(1, 1), -0.5) << "by rows: field 7 of the matrix";
  EXPECT_EQ(edge.gravity, Vector3(0, 0, -9.8));
}

TEST(InertialFields, HaveAPositiveDuration) {
  const std::string text = json_registry().example("EDGE_INERTIAL");
  const std::string before = " 0.5 0.25 -1 ";  // the change of the velocity
  const std::size_t duration = text.find(before + "0.5 ");
  ASSERT_NE(duration, std::string::npos);
  for (const char* wrong : {"0", "-0.5"}) {
    std::string changed = text;
    changed.replace(duration + before.size(), 3, wrong);
    EXPECT_THAT(complaint_about(changed),
                testing::HasSubstr(std::string("expected a positive duration, got ") + wrong));
  }
}

TEST(InertialFields, KeepTheChi2OfADriveInJson) {
  Preintegration sum(ImuNoise{}, ImuBias::Constant(0.01));
  for (int k = 0; k < 20; ++k) sum.integrate({0.3, -0.2, 0.1 * k}, {0.5, 1, 9.7}, 0.005);
  GraphFile file;
  Graph& graph = file.graph;
  const auto pose_i = graph.add_vertex(SE3()),
             pose_j = graph.add_vertex(SE3(Vector3(1, 2, 3), SE3::Quaternion{0, 0, 0.6, 0.8}));
  const auto velocity_i = graph.add_vertex(Vector3(1, 0, 0)), velocity_j = graph.add_vertex(Vector3(1, 1, 0));
  const auto bias_i = graph.add_vertex(ImuBias(ImuBias::Constant(0.02)));
  const auto bias_j = graph.add_vertex(ImuBias(ImuBias::Zero()));
  const auto down = graph.add_vertex(S2(Vector3(0.1, 0.2, -1)));
  file.edges.push_back(graph.add_edge(InertialBetween(sum.motion()), sum.information(), pose_i, velocity_i,
                                      bias_i, pose_j, velocity_j, bias_j));
  file.edges.push_back(graph.add_edge(InertialBetween(sum.motion()), sum.information(), pose_i, velocity_i,
                                      bias_i, pose_j, velocity_j, bias_j, down));
  file.edges.push_back(graph.add_edge(DirectionObservation(S2(Vector3(0, 0.6, -0.8))), pose_j, down));
  file.edges.push_back(graph.add_edge(OffsetPositionPrior(Vector3(1, 2, 3.1)), pose_j,
                                      graph.add_parameter(Vector3(0.1, 0, 0.4))));
  const GraphFile again = parse_graph(format_graph(file, {.format = "json"}), "g.json");
  EXPECT_EQ(again.graph.chi2(), graph.chi2());
}

TEST(InertialFields, RefuseADirectionWithoutLengthAndNormalizeAnyOther) {
  EXPECT_EQ(complaint_about("VERTEX_DIRECTION 1 0 0 0\n"),
            "g:1:20: expected a direction, got the zero vector");
  const GraphFile file = read_lines_of_json("VERTEX_DIRECTION 1 0 3e-300 -4e-300\n");
  EXPECT_LT((file.graph.estimate(file.graph.vertex<S2>(1)).vector() - Vector3(0, 0.6, -0.8)).norm(), 1e-15);
}

}  // namespace
}  // namespace boxplus
