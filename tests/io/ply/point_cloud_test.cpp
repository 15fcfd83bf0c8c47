// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply/point_cloud.h"

#include <gtest/gtest.h>

#include <limits>

#include "boxplus/types/slam2d.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

TEST(PointCloud, HasAnIndexForEachElementWithAFinitePosition) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(3, 4), 9);
  const auto pose = graph.add_vertex(SE2(1, 2, 0.5), 4);
  const auto lost = graph.add_vertex(Vector2(std::numeric_limits<double>::quiet_NaN(), 0), 5);
  const auto line = graph.add_vertex(Line2(), 6);
  const auto sensor = graph.add_parameter(SE2());
  const PointCloud cloud({graph}, ".ply");
  ASSERT_EQ(cloud.vertices.size(), 2u);
  EXPECT_EQ(cloud.index_of(pose), 0u) << "the order of the ids";
  EXPECT_EQ(cloud.index_of(point), 1u);
  EXPECT_EQ(cloud.vertices[1].position, (std::array{3.0, 4.0, 0.0}));
  EXPECT_NE(cloud.vertices[0].color, cloud.vertices[1].color);
  for (const VertexRef& absent : {VertexRef(lost), VertexRef(line), VertexRef(sensor)})
    EXPECT_EQ(cloud.index_of(absent), PointCloud::kAbsent);
  EXPECT_TRUE(cloud.lines.empty());
}

TEST(PointCloud, HasTheTipOfThePyramidAsIndexOfACamera) {
  const GraphFile file = read_model_texts({});
  const PointCloud cloud({file.graph, file.edges, file.kept, file.model.get()}, ".ply");
  const VertexRef camera = *file.graph.find_vertex(5);
  EXPECT_EQ(cloud.index_of(camera), 3u) << "after three points";
  EXPECT_EQ(cloud.vertices[3].position[1], -0.125);
  EXPECT_EQ(cloud.lines[0], (std::array<std::size_t, 2>{3, 4}));
}

}  // namespace
}  // namespace boxplus
