// SPDX-License-Identifier: BSD-3-Clause
// The tags of g2o's type libraries sba, sim3 and icp. The files contain poses of cameras in the world
// (T_world_camera), also for the tags with :EXPMAP, although g2o's vertices contain the inverse.
#include "boxplus/io/registry.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

void register_exponential_map(Registry& registry) {
  using Pose = SE3RotationVector;
  registry.vertex<Pose>("VERTEX_SE3:EXPMAP", "1 1 2 -3 0 0 0.6 0.8");
  registry.parameter<StereoCamera>("PARAMS_CAMERAPARAMETERS", "6 500 320 240 0.1");
  registry.edge<TwistBetween, Pose, Pose>("EDGE_SE3:EXPMAP",
                                          "0 1 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<PointImage<2>, Vector3, Pose, Parameter<StereoCamera>>("EDGE_PROJECT_XYZ2UV:EXPMAP",
                                                                       "2 1 6 310 250 1 0 1");
  registry.edge<PointImage<3>, Vector3, Pose, Parameter<StereoCamera>>("EDGE_PROJECT_XYZ2UVU:EXPMAP",
                                                                       "2 1 6 310 250 300 1 0 0 1 0 1");
  registry.edge<CalibratedPointImage<2>, Vector3, Pose>("EDGE_SE3_PROJECT_XYZ:EXPMAP",
                                                        "2 1 310 250 1 0 1 500 510 320 240");
  registry.edge<CalibratedPointImage<3>, Vector3, Pose>("EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP",
                                                        "2 1 310 250 300 1 0 0 1 0 1 500 510 320 240 50");
  registry.edge<KnownPointImage<2>, Pose>("EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP",
                                          "1 310 250 1 0 1 2 3 4 500 510 320 240");
  registry.edge<KnownPointImage<3>, Pose>("EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP",
                                          "1 310 250 300 1 0 0 1 0 1 2 3 4 500 510 320 240 50");
  registry.edge<InverseDepthImage, Vector3, Pose, Pose, Parameter<StereoCamera>>("EDGE_PROJECT_PSI2UV:EXPMAP",
                                                                                 "2 0 1 6 310 250 1 0 1");
}

void register_stereo_poses(Registry& registry) {
  registry.vertex<StereoPose>("VERTEX_CAM", "3 1 2 -3 0 0 0.6 0.8 500 510 320 240 0.1");
  registry.vertex<StereoIntrinsics>("VERTEX_INTRINSICS", "8 500 510 320 240 0.1");
  registry.edge<PointImage<2>, Vector3, StereoPose>("EDGE_PROJECT_P2MC", "2 3 310 250 1 0 1");
  registry.edge<PointImage<3>, Vector3, StereoPose>("EDGE_PROJECT_P2SC", "2 3 310 250 300 1 0 0 1 0 1");
  registry.edge<PointImage<2>, Vector3, StereoPose, StereoIntrinsics>("EDGE_PROJECT_P2MC_INTRINSICS",
                                                                      "2 3 8 310 250 1 0 1");
  registry.edge<CameraBetween, StereoPose, StereoPose>(
      "EDGE_CAM", "3 4 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<Range, StereoPose, StereoPose>("EDGE_SCALE", "3 4 2 1");
}

void register_mounted_cameras(Registry& registry) {
  using Camera = Product<SE3, PinholeCamera>;
  registry.parameter<Camera>("PARAMS_CAMERACALIB", "7 0 0 1 0 0.6 0 0.8 500 510 320 240");
  registry.parameter<Product<SE3, PinholeCamera, double>>("PARAMS_STEREOCAMERACALIB",
                                                          "8 0 0 1 0 0.6 0 0.8 500 510 320 240 0.1");
  registry.edge<DepthImage, SE3, Vector3, Parameter<Camera>>("EDGE_PROJECT_DEPTH",
                                                             "0 2 7 310 250 3 1 0 0 1 0 1");
  registry.edge<DisparityImage, SE3, Vector3, Parameter<Camera>>("EDGE_PROJECT_DISPARITY",
                                                                 "0 2 7 310 250 0.3 1 0 0 1 0 1");
}

void register_similarities(Registry& registry) {
  registry.vertex<SimilarityCamera>("VERTEX_SIM3:EXPMAP",
                                    "5 0.1 0.2 0.3 1 2 -3 0.1 500 510 320 240 400 410 300 200");
  registry.edge<SimilarityBetween, SimilarityCamera, SimilarityCamera>(
      "EDGE_SIM3:EXPMAP",
      "5 9 0.1 0.2 0.3 1 2 3 0.1 1 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<SimilarityImage, Vector3, SimilarityCamera>("EDGE_PROJECT_SIM3_XYZ:EXPMAP",
                                                            "2 5 310 250 1 0 1");
  registry.edge<InverseSimilarityImage, Vector3, SimilarityCamera>("EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP",
                                                                   "2 5 310 250 1 0 1");
}

}  // namespace

void register_ba(Registry& registry) {
  register_exponential_map(registry);
  register_stereo_poses(registry);
  register_similarities(registry);
  register_mounted_cameras(registry);
  registry.edge<SurfaceMatch, SE3, SE3>("EDGE_V_V_GICP", "0 1 1 2 3 0 0 1 2 3 4 0 0.6 0.8");
}

}  // namespace boxplus
