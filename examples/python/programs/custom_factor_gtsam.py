# SPDX-License-Identifier: BSD-3-Clause
# A factor that the library does not have: distances of poses from known beacons. In GTSAM.

import worlds

world = worlds.beacons()

# [program]
import functools

import gtsam
import numpy as np


def beacon_range(place, distance, factor, values, jacobians):
    pose = values.atPose2(factor.keys()[0])
    offset = pose.translation() - place
    if jacobians is not None:
        forward, left = offset / np.linalg.norm(offset) @ pose.rotation().matrix()
        jacobians[0] = np.array([[forward, left, 0]])
    return np.array([np.linalg.norm(offset) - distance])


graph = gtsam.NonlinearFactorGraph()
initial = gtsam.Values()
for key, pose in enumerate(world.guess):
    initial.insert(key, gtsam.Pose2(*pose))
graph.add(gtsam.PriorFactorPose2(0, gtsam.Pose2(), gtsam.noiseModel.Isotropic.Sigma(3, 1e-6)))
noise = gtsam.noiseModel.Gaussian.Information(world.omega)
for key, z in enumerate(world.odometry):
    graph.add(gtsam.BetweenFactorPose2(key, key + 1, gtsam.Pose2(*z), noise))
noise = gtsam.noiseModel.Isotropic.Sigma(1, 0.05)
for key, place, distance in zip(world.pose, world.places, world.distances):
    error = functools.partial(beacon_range, place, distance)
    graph.add(gtsam.CustomFactor(noise, [key], error))
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
result = optimizer.optimize()
poses = np.array([[pose.x(), pose.y(), pose.theta()] for pose in map(result.atPose2, range(len(world.guess)))])
# [/program]
