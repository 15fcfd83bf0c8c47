# SPDX-License-Identifier: BSD-3-Clause
# Poses and landmarks from odometry, angles and distances, in GTSAM.

import worlds

world = worlds.landmarks()

# [program]
import gtsam
import numpy as np
from gtsam.symbol_shorthand import L, X

graph = gtsam.NonlinearFactorGraph()
initial = gtsam.Values()
for k, pose in enumerate(world.guess):
    initial.insert(X(k), gtsam.Pose2(*pose))
for k, point in enumerate(world.points_guess):
    initial.insert(L(k), gtsam.Point2(*point))
graph.add(gtsam.PriorFactorPose2(X(0), gtsam.Pose2(), gtsam.noiseModel.Isotropic.Sigma(3, 1e-6)))
noise = gtsam.noiseModel.Gaussian.Information(world.omega)
for k, z in enumerate(world.odometry):
    graph.add(gtsam.BetweenFactorPose2(X(k), X(k + 1), gtsam.Pose2(*z), noise))
noise = gtsam.noiseModel.Diagonal.Sigmas(np.array([0.02, 0.1]))
for k, l, angle, distance in zip(world.pose, world.point, world.angles, world.ranges):
    graph.add(gtsam.BearingRangeFactor2D(X(k), L(l), gtsam.Rot2(angle), distance, noise))
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
result = optimizer.optimize()
landmarks = np.array([result.atPoint2(L(k)) for k in range(len(world.points_guess))])
# [/program]
