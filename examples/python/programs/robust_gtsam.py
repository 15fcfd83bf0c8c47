# SPDX-License-Identifier: BSD-3-Clause
# A pose graph with false loop closures, in GTSAM.

import worlds

world = worlds.pose_graph(false_closures=4)

# [program]
import gtsam
import numpy as np

graph = gtsam.NonlinearFactorGraph()
initial = gtsam.Values()
for key, pose in enumerate(world.guess):
    initial.insert(key, gtsam.Pose2(*pose))
graph.add(gtsam.PriorFactorPose2(0, gtsam.Pose2(), gtsam.noiseModel.Isotropic.Sigma(3, 1e-6)))
noise = gtsam.noiseModel.Gaussian.Information(world.omega)
kernel = gtsam.noiseModel.mEstimator.GemanMcClure.Create(10)
robust = gtsam.noiseModel.Robust.Create(kernel, noise)
for k, (i, j, z) in enumerate(zip(world.i, world.j, world.z)):
    chosen = noise if k < world.odometry else robust
    graph.add(gtsam.BetweenFactorPose2(i, j, gtsam.Pose2(*z), chosen))
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
result = optimizer.optimize()
poses = np.array([[pose.x(), pose.y(), pose.theta()] for pose in map(result.atPose2, range(len(world.guess)))])
# [/program]
