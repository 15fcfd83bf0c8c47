// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/image_fields.h"

#include <gmock/gmock.h>

#include "boxplus/types/ba.h"
#include "boxplus/types/slam3d.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

const std::string kPoint = "VERTEX_TRACKXYZ 1 0 4 7\n";
const std::string kPose = "VERTEX_SE3:EXPMAP 2 1 2 3 0 0 0.6 0.8\n";

template <class E>
const E& only_edge(const GraphFile& file) {
  return file.graph.measurement(EdgeHandle<E>{file.edges.at(0)});
}

TEST(CameraPoses, AreNormalizedAndWrittenWithTheDigitsThatWereRead) {
  const std::string line = "VERTEX_SE3:EXPMAP 2 1 2 3 0.182574 0.365148 0.547723 0.730297\n";
  const GraphFile file = parse_graph(line, "g");
  const auto x = file.graph.typed<SE3RotationVector>(file.graph.all_vertices().at(0));
  EXPECT_NEAR(file.graph.estimate(x).quaternion().squared_norm(), 1, 1e-15);
  EXPECT_EQ(format_graph(file), line);
}

TEST(CameraPoses, AreReadAsTheyWereWrittenAfterManySteps) {
  GraphFile file = parse_graph(kPose, "g");
  const auto x = file.graph.typed<SE3RotationVector>(file.graph.all_vertices().at(0));
  const double step[] = {0.1, 0.2, 0.3, 0.3, -0.2, 0.1};
  for (int i = 0; i < 1000; ++i) {
    file.graph.set_estimate(x, Manifold<SE3RotationVector>::oplus(file.graph.estimate(x), step));
    const std::string text = format_graph(file);
    EXPECT_EQ(format_graph(parse_graph(text, "g")), text);
  }
}

TEST(ImagesOfG2o, MayLackTheirCamera) {
  const GraphFile file = parse_graph(kPoint + kPose + "EDGE_SE3_PROJECT_XYZ:EXPMAP 1 2 0.1 0.2 1 0 1\n", "g");
  EXPECT_EQ(only_edge<CalibratedPointImage<2>>(file).camera.parameters, (Vector<double, 4>(1, 1, 0, 0)));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].line, 3);
  EXPECT_THAT(file.notes[0].text, HasSubstr("without the camera"));
  EXPECT_THAT(format_graph(file), HasSubstr("0.1 0.2 1 0 1 1 1 0 0\n"));
}

TEST(ImagesOfG2o, MayLackTheirKnownPoint) {
  const GraphFile file =
      parse_graph(kPose + "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP 2 0.1 0.2 0 1 0 0 1 0 1\n", "g");
  const auto& edge = only_edge<KnownPointImage<3>>(file);
  EXPECT_EQ(edge.point, Vector3(0, 0, 1));
  EXPECT_EQ(edge.bf, 1);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_THAT(file.notes[0].text, HasSubstr("without the known point"));
}

TEST(CamerasOfG2o, HaveDefaultIntrinsics) {
  const GraphFile file = parse_graph("VERTEX_CAM 3 1 2 3 0 0 0.6 0.8\n", "g");
  const auto x = file.graph.typed<StereoPose>(file.graph.all_vertices().at(0));
  EXPECT_EQ(file.graph.estimate(x).intrinsics.parameters, (Vector<double, 4>(300, 300, 320, 320)));
  EXPECT_EQ(file.graph.estimate(x).intrinsics.baseline, 0.1);
  EXPECT_EQ(file.notes.size(), 1u);
}

TEST(OptionalFields, AreMissingTogether) {
  EXPECT_EQ(complaint("VERTEX_CAM 3 1 2 3 0 0 0.6 0.8 300\n"),
            "g:1:35: expected a camera parameter (fx fy cx cy), got the end of the line");
}

TEST(Similarities, MustHaveAUsableScale) {
  EXPECT_THAT(complaint("VERTEX_SIM3:EXPMAP 5 0 0 0 1 2 3 300 1 1 0 0\n"),
              HasSubstr("g:1:22: expected the logarithm of a similarity with a scale between"));
  EXPECT_THAT(complaint("VERTEX_SIM3:EXPMAP 5 0 0 0 1e300 2 3 1 1 1 0 0\n"), HasSubstr("finite translation"));
}

TEST(SurfaceMatches, AreRefusedIfTheirInformationIsNotThatOfTheNormal) {
  GraphFile file = parse_graph(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
      "EDGE_V_V_GICP 0 1 1 2 3 0 0 1 2 3 4 0 0 1\n",
      "g");
  EXPECT_NEAR(file.graph.chi2(), 0.01 * 2 + 1, 1e-14);
  file.graph.set_information(file.edges[0], Information(2));
  try {
    std::ignore = format_graph(file);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("SurfaceMatch"));
  }
}

}  // namespace
}  // namespace boxplus
