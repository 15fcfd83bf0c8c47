# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment with known intrinsics, in GTSAM.

import worlds

world = worlds.bundle()

# [program]
import gtsam
import numpy as np
from gtsam.symbol_shorthand import L, X

graph = gtsam.NonlinearFactorGraph()
initial = gtsam.Values()
for i, (x, y, z, qx, qy, qz, qw) in enumerate(world.cameras_guess):
    initial.insert(X(i), gtsam.Pose3(gtsam.Rot3.Quaternion(qw, qx, qy, qz), np.array([x, y, z])))
for k, point in enumerate(world.points_guess):
    initial.insert(L(k), gtsam.Point3(*point))
for i in range(2):
    graph.add(gtsam.PriorFactorPose3(X(i), initial.atPose3(X(i)), gtsam.noiseModel.Isotropic.Sigma(6, 1e-6)))
K = gtsam.Cal3_S2(world.focal, world.focal, 0, *world.center)
huber = gtsam.noiseModel.mEstimator.Huber.Create(2)
noise = gtsam.noiseModel.Robust.Create(huber, gtsam.noiseModel.Unit.Create(2))
for i, k, pixel in zip(world.camera, world.point, world.pixels):
    graph.add(gtsam.GenericProjectionFactorCal3_S2(pixel, noise, X(i), L(k), K))
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
result = optimizer.optimize()
found = np.array([result.atPoint3(L(k)) for k in range(len(world.points_guess))])
# [/program]
