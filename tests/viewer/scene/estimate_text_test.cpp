// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/estimate_text.h"

#include <gtest/gtest.h>

#include "boxplus/manifold/product.h"
#include "boxplus/types/ba.h"
#include "viewer/scene/element.h"

namespace boxplus::viewer {
namespace {

const SE3 kPose(Vector3(1, 2, -3.5), SO3::from_rotation_vector(Vector3(0, 0, 3.14159265358979)));

TEST(EstimateText, OfABalCameraHasItsPoseAndNamesItsParameters) {
  Graph graph;
  const auto camera = graph.add_vertex(Product<SE3, BalCamera>(kPose, BalCamera(500, -1e-7, 0)));
  const std::string text = estimate_text(graph, camera);
  EXPECT_EQ(text.substr(0, text.find('\n')), "position: 1 2 -3.5");
  EXPECT_NE(text.find("\nrotation: "), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.find("\nf: ")), "\nf: 500\nk1: -1e-07\nk2: 0");
  EXPECT_EQ(facts_of(graph, make_structure(graph), camera).estimate, text);
}

TEST(EstimateText, OfOtherTypesIsWhatThereIs) {
  Graph graph;
  EXPECT_EQ(estimate_text(graph, graph.add_vertex(SE2(1, 2, 0.5))), "position: 1 2\nangle: 0.5");
  EXPECT_EQ(estimate_text(graph, graph.add_vertex(Vector3(1, 2, 3))), "position: 1 2 3");
  EXPECT_EQ(estimate_text(graph, graph.add_vertex(SimplePinholeCamera(500, 320, 240))),
            "f: 500\ncx: 320\ncy: 240");
  EXPECT_EQ(estimate_text(graph, graph.add_vertex(4.0)), "");
}

}  // namespace
}  // namespace boxplus::viewer
