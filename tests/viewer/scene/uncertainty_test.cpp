// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/uncertainty.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <string>

#include "boxplus/io/graph_file.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Uncertainty uncertainty_of(const Graph& graph, bool stop = false) {
  const std::atomic<bool> flag = stop;
  return read_uncertainty(graph, make_structure(graph), flag);
}

Graph parsed(const std::string& text) {
  return parse_graph(text, "test.g2o").graph;
}

TEST(Uncertainty, OfAPoseIsInTheWorldFrame) {
  // Pose 1 looks along y. In its frame, the variances are 1/4 along x and 1/25 along y.
  const Uncertainty found =
      uncertainty_of(parsed("VERTEX_SE2 0 0 0 1.5707963267948966\n"
                            "FIX 0\n"
                            "VERTEX_SE2 1 0 10 1.5707963267948966\n"
                            "EDGE_SE2 0 1 10 0 0 4 0 0 25 0 10000\n"));
  EXPECT_THAT(found.vertices, ElementsAre(0, 1));
  ASSERT_THAT(found.covariances, SizeIs(12));
  EXPECT_THAT(std::vector(found.covariances.begin(), found.covariances.begin() + 6),
              ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_THAT(std::vector(found.covariances.begin() + 6, found.covariances.end()),
              ElementsAre(FloatNear(0.04F, 1e-6F), FloatNear(0, 1e-6F), 0, FloatNear(0.25F, 1e-6F), 0, 0));
  EXPECT_EQ(found.note, "covariances of all 2 positions");
}

TEST(Uncertainty, OfPosesInSpaceHasAllAxes) {
  // Pose 1 is turned by 90° around z.
  const Uncertainty found = uncertainty_of(
      parsed("VERTEX_SE3:QUAT 0 0 0 0 0 0 0.70710678118654757 0.70710678118654757\n"
             "FIX 0\n"
             "VERTEX_SE3:QUAT 1 0 1 0 0 0 0.70710678118654757 0.70710678118654757\n"
             "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 4 0 0 0 0 0 25 0 0 0 0 16 0 0 0 10000 0 0 10000 0 10000\n"));
  ASSERT_THAT(found.covariances, SizeIs(12));
  EXPECT_THAT(std::vector(found.covariances.begin() + 6, found.covariances.end()),
              ElementsAre(FloatNear(0.04F, 1e-6F), FloatNear(0, 1e-6F), FloatNear(0, 1e-6F),
                          FloatNear(0.25F, 1e-6F), FloatNear(0, 1e-6F), FloatNear(0.0625F, 1e-6F)));
}

TEST(Uncertainty, OfAGraphWithoutAFixedVertexNamesTheOneThatIsHeld) {
  const Uncertainty found =
      uncertainty_of(parsed("VERTEX_SE2 7 0 0 0\nVERTEX_SE2 8 1 0 0\nEDGE_SE2 7 8 1 0 0 1 0 0 1 0 1\n"));
  EXPECT_EQ(found.note, "covariances of all 2 positions, relative to vertex 7");
}

TEST(Uncertainty, OfAGraphInPartsNamesTheHeldVertexOfEachPart) {
  std::string text;
  for (int id = 0; id < 28; ++id) text += "VERTEX_SE2 " + std::to_string(id) + " 0 0 0\n";
  for (int id = 0; id < 6; id += 2)
    text += "EDGE_SE2 " + std::to_string(id) + " " + std::to_string(id + 1) + " 1 0 0 1 0 0 1 0 1\n";
  std::string more = text;
  for (int id = 6; id < 28; id += 2)
    more += "EDGE_SE2 " + std::to_string(id) + " " + std::to_string(id + 1) + " 1 0 0 1 0 0 1 0 1\n";
  for (int id = 6; id < 28; ++id) text += "FIX " + std::to_string(id) + "\n";
  EXPECT_THAT(uncertainty_of(parsed(text)).note,
              HasSubstr(", relative to the vertices 0, 2 and 4 of their parts of the graph"));
  EXPECT_THAT(uncertainty_of(parsed(more)).note,
              HasSubstr(", relative to the vertices 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22 and 2 more"));
}

TEST(Uncertainty, OfBundleAdjustmentNamesTheCameraWhosePoseIsHeld) {
  const BundleSimulation bundle = simulate_bundle(BundleShape::kRing, {.cameras = 4, .points = 60});
  const Uncertainty found = uncertainty_of(bundle.graph);
  const std::size_t place = found.note.find(", relative to vertex ");
  ASSERT_NE(place, std::string::npos) << found.note;
  const auto id = static_cast<std::size_t>(std::stoi(found.note.substr(place + 21)));
  ASSERT_LT(id, 4U) << "it is no camera";
  for (std::size_t camera = 0; camera < 4; ++camera) {
    const auto first = found.covariances.begin() + static_cast<std::ptrdiff_t>(6 * camera);
    const bool is_held = std::all_of(first, first + 6, [](float value) { return value == 0; });
    EXPECT_EQ(is_held, camera == id) << found.note;
  }
}

TEST(Uncertainty, OfALargeGraphIsThatOfVerticesThatAreSpreadOverAllOfIt) {
  const int count = 3 * static_cast<int>(Uncertainty::kMostVertices);
  std::string text;
  for (int id = 0; id < count; ++id) text += "VERTEX_SE2 " + std::to_string(id) + " 0 0 0\n";
  for (int id = 1; id < count; ++id)
    text += "EDGE_SE2 " + std::to_string(id - 1) + " " + std::to_string(id) + " 0 0 0 1 0 0 1 0 1\n";
  const Uncertainty found = uncertainty_of(parsed(text));
  ASSERT_THAT(found.vertices, SizeIs(Uncertainty::kMostVertices));
  EXPECT_THAT(found.covariances, SizeIs(6 * Uncertainty::kMostVertices));
  for (std::uint32_t k = 0; k < Uncertainty::kMostVertices; ++k) EXPECT_EQ(found.vertices[k], 3 * k);
  EXPECT_THAT(found.note, HasSubstr("2000 positions, spread evenly over all 6000"));
}

TEST(Uncertainty, OfAnUndeterminedGraphIsTheReasonWhyThereIsNone) {
  const Uncertainty found =
      uncertainty_of(parsed("VERTEX_SE2 7 0 0 0\nFIX 7\nVERTEX_SE2 8 1 0 0\nVERTEX_SE2 9 1 0 0\n"
                            "EDGE_SE2 7 8 1 0 0 1 0 0 1 0 1\n"));
  EXPECT_THAT(found.vertices, IsEmpty());
  EXPECT_THAT(found.covariances, IsEmpty());
  EXPECT_THAT(found.note, HasSubstr("vertex 9"));
}

TEST(Uncertainty, CanBeStopped) {
  const Uncertainty found = uncertainty_of(
      parsed("VERTEX_SE2 7 0 0 0\nVERTEX_SE2 8 1 0 0\nEDGE_SE2 7 8 1 0 0 1 0 0 1 0 1\n"), true);
  EXPECT_THAT(found.vertices, IsEmpty());
  EXPECT_THAT(found.note, HasSubstr("stopped"));
}

}  // namespace
}  // namespace boxplus::viewer
