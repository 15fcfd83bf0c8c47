// SPDX-License-Identifier: BSD-3-Clause
// The forms in which a program can state the same problem of bundle adjustment.
#pragma once

#include <string_view>

#include "boxplus/graph/graph.h"
#include "bundle/bundle_problem.h"

namespace boxplus::bench {

enum class BundleForm {
  kCamera,              ///< one vertex per camera, and Reprojection<BalCamera>
  kSeparateIntrinsics,  ///< a vertex for the pose and one for the intrinsics of each camera
  kSimpleRadial,        ///< as kSeparateIntrinsics, with the camera model SIMPLE_RADIAL: f, cx, cy, k
  kRadial,              ///< the same with RADIAL, which has another coefficient
  kOpenCv,              ///< the same with OPENCV
  kOpenCvFisheye,       ///< the same with OPENCV_FISHEYE
  kSharedIntrinsics,    ///< one vertex for the intrinsics of all cameras
  kCustomEdge,          ///< one vertex per camera, and a user's error function with automatic derivatives
  kCustomEdgeOfThree,   ///< the same with a vertex for the pose and one for the intrinsics of each camera
  kCustomJacobians      ///< one vertex per camera, and the user's own Jacobians
};
inline constexpr BundleForm kBundleForms[] = {BundleForm::kCamera,
                                              BundleForm::kSeparateIntrinsics,
                                              BundleForm::kSimpleRadial,
                                              BundleForm::kRadial,
                                              BundleForm::kOpenCv,
                                              BundleForm::kOpenCvFisheye,
                                              BundleForm::kSharedIntrinsics,
                                              BundleForm::kCustomEdge,
                                              BundleForm::kCustomEdgeOfThree,
                                              BundleForm::kCustomJacobians};
std::string_view describe(BundleForm form);

/// The graph of a problem. Its points are marked to be eliminated.
Graph make_bundle_graph(const BundleProblem& problem, BundleForm form);

}  // namespace boxplus::bench
