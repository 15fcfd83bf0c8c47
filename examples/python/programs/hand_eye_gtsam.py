# SPDX-License-Identifier: BSD-3-Clause
# The pose X of a camera on a robot's hand, from motions of both: robot X = X camera. In GTSAM.

import worlds

world = worlds.hand_eye()

# [program]
import functools

import gtsam
import numpy as np


def pose(row):
    x, y, z, qx, qy, qz, qw = row
    return gtsam.Pose3(gtsam.Rot3.Quaternion(qw, qx, qy, qz), np.array([x, y, z]))


def hand_eye(robot, camera, factor, values, jacobians):
    x = values.atPose3(factor.keys()[0])
    difference = x.compose(camera).between(robot.compose(x))
    if jacobians is not None:
        back = camera.compose(difference).inverse()
        jacobians[0] = np.eye(6) - back.AdjointMap()
    return gtsam.Pose3.Logmap(difference)


graph = gtsam.NonlinearFactorGraph()
noise = gtsam.noiseModel.Unit.Create(6)
for a, b in zip(world.robot, world.camera):
    error = functools.partial(hand_eye, pose(a), pose(b))
    graph.add(gtsam.CustomFactor(noise, [0], error))
initial = gtsam.Values()
initial.insert(0, gtsam.Pose3())
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
x = optimizer.optimize().atPose3(0)
# [/program]
