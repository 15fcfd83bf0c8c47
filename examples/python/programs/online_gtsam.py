# SPDX-License-Identifier: BSD-3-Clause
# A pose graph that grows, with an estimate after each motion, in GTSAM.

import worlds

world = worlds.online()

# [program]
import gtsam
import numpy as np

isam = gtsam.ISAM2(gtsam.ISAM2Params())
noise = gtsam.noiseModel.Gaussian.Information(world.omega)
graph = gtsam.NonlinearFactorGraph()
graph.add(gtsam.PriorFactorPose2(0, gtsam.Pose2(), gtsam.noiseModel.Isotropic.Sigma(3, 1e-6)))
initial = gtsam.Values()
initial.insert(0, gtsam.Pose2())
isam.update(graph, initial)
for k, z in enumerate(world.odometry, 1):
    graph, initial = gtsam.NonlinearFactorGraph(), gtsam.Values()
    initial.insert(k, isam.calculateEstimatePose2(k - 1).compose(gtsam.Pose2(*z)))
    for i, measured in [(k - 1, z), *world.closures.get(k, ())]:
        graph.add(gtsam.BetweenFactorPose2(i, k, gtsam.Pose2(*measured), noise))
    isam.update(graph, initial)
result = isam.calculateEstimate()
poses = np.array([[pose.x(), pose.y(), pose.theta()] for pose in map(result.atPose2, range(len(world.truth)))])
# [/program]
