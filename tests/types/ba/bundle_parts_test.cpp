// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/bundle_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_bundle.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/prior.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A pose, a point and two cameras. The principal point of the first camera is fixed.
struct Scene {
  Graph graph;
  VertexHandle<SE3> pose = graph.add_vertex(SE3());
  VertexHandle<Vector3> point = graph.add_vertex(Vector3(0, 0, 5));
  VertexHandle<OpenCvCamera> camera =
      graph.add_parameter(OpenCvCamera(500.0, 501.0, 320.0, 240.0, 0.0, 0.0, 0.0, 0.0));
  VertexHandle<Product<SE3, BalCamera>> bal = graph.add_vertex(Product(SE3(), BalCamera(500.0, 0.0, 0.0)));

  Scene() {
    graph.unfix(camera);
    graph.fix_directions(camera, {2, 3});
  }
  std::vector<int> directions(VertexRef vertex) const {
    const std::span<const int> fixed = graph.fixed_directions(vertex);
    return {fixed.begin(), fixed.end()};
  }
};

TEST(BundleParts, HaveNamesByWhichTheyAreFound) {
  EXPECT_EQ(bundle_parts().size(), 6u);
  for (const BundlePart part : bundle_parts()) EXPECT_EQ(find_bundle_part(to_string(part)), part);
  EXPECT_EQ(find_bundle_part("lens"), std::nullopt);
}

TEST(BundleParts, OfIntrinsicsAreDirectionsOfCameras) {
  Scene scene;
  EXPECT_EQ(hold(scene.graph, BundlePart::kFocalLengths), 2u);
  EXPECT_THAT(scene.directions(scene.camera), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(scene.directions(scene.bal), ElementsAre(6));
  EXPECT_EQ(hold(scene.graph, BundlePart::kDistortion), 2u);
  EXPECT_TRUE(scene.graph.is_fixed(scene.camera)) << "all directions are held";
  EXPECT_THAT(scene.directions(scene.bal), ElementsAre(6, 7, 8));
  EXPECT_EQ(hold(scene.graph, BundlePart::kFocalLengths, false), 2u);
  EXPECT_FALSE(scene.graph.is_fixed(scene.camera));
  EXPECT_THAT(scene.directions(scene.camera), ElementsAre(2, 3, 4, 5, 6, 7));
  EXPECT_EQ(hold(scene.graph, BundlePart::kPrincipalPoints, false), 1u) << "BAL has none";
  EXPECT_THAT(scene.directions(scene.camera), ElementsAre(4, 5, 6, 7));
}

TEST(BundleParts, OfPosesAndPointsAreWholeVerticesOrThePosesOfBal) {
  Scene scene;
  EXPECT_EQ(hold(scene.graph, BundlePart::kPoses), 2u);
  EXPECT_TRUE(scene.graph.is_fixed(scene.pose));
  EXPECT_THAT(scene.directions(scene.bal), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(hold(scene.graph, BundlePart::kPoints), 1u);
  EXPECT_TRUE(scene.graph.is_fixed(scene.point));
  EXPECT_EQ(hold(scene.graph, BundlePart::kPoses, false), 2u);
  EXPECT_FALSE(scene.graph.is_fixed(scene.pose));
  EXPECT_THAT(scene.directions(scene.bal), IsEmpty());
}

TEST(BundleParts, ThatAreHeldKeepTheirBitsInARun) {
  BundleSimulation bundle = simulate_bundle(BundleShape::kRing, {.cameras = 6, .points = 60});
  hold(bundle.graph, BundlePart::kIntrinsics);
  const auto camera = bundle.graph.vertex<Product<SE3, BalCamera>>(3);
  const Product<SE3, BalCamera> before = bundle.graph.estimate(camera);
  EXPECT_TRUE(optimize(bundle.graph).converged());
  EXPECT_EQ(bundle.graph.estimate(camera).get<1>().parameters, before.get<1>().parameters);
  EXPECT_NE(bundle.graph.estimate(camera).get<0>().vector(), before.get<0>().vector());
}

TEST(PixelSigma, IsTheStandardDeviationOfAllReprojectionErrors) {
  BundleSimulation bundle = simulate_bundle(BundleShape::kRing, {.cameras = 6, .points = 60});
  const double chi2 = bundle.graph.chi2();
  bundle.graph.add_edge(Prior(Vector3(0, 0, 0)), 0.0, bundle.graph.vertex<Vector3>(6));
  EXPECT_EQ(set_pixel_sigma(bundle.graph, 0.5), bundle.graph.edge_count() - 1);
  EXPECT_NEAR(bundle.graph.chi2(), 4 * chi2, 1e-9 * chi2);
  for (const double sigma : {0.0, -1.0, 1e200, 1e-200, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(set_pixel_sigma(bundle.graph, sigma), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
