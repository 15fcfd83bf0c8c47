# SPDX-License-Identifier: BSD-3-Clause
# A smooth path around round obstacles, with fixed ends, in GTSAM.

import worlds

world = worlds.plan()

# [program]
import functools

import gtsam
import numpy as np


def smooth(factor, values, jacobians):
    a, b, c = (values.atPoint2(key) for key in factor.keys())
    if jacobians is not None:
        jacobians[0] = np.eye(2)
        jacobians[1] = -2 * np.eye(2)
        jacobians[2] = np.eye(2)
    return a - 2 * b + c


def clear(disc, factor, values, jacobians):
    offset = values.atPoint2(factor.keys()[0]) - disc[:2]
    distance = np.linalg.norm(offset)
    overlap = world.margin + disc[2] - distance
    if jacobians is not None:
        jacobians[0] = -offset[None] / distance if overlap > 0 else np.zeros((1, 2))
    return np.array([max(0.0, overlap)])


graph = gtsam.NonlinearFactorGraph()
initial = gtsam.Values()
for key, point in enumerate(world.path):
    initial.insert(key, gtsam.Point2(*point))
fixed = gtsam.noiseModel.Isotropic.Sigma(2, 1e-6)
for key in (0, len(world.path) - 1):
    graph.add(gtsam.PriorFactorPoint2(key, gtsam.Point2(*world.path[key]), fixed))
noise = gtsam.noiseModel.Isotropic.Sigma(2, 1 / np.sqrt(100))
for key in range(len(world.path) - 2):
    graph.add(gtsam.CustomFactor(noise, [key, key + 1, key + 2], smooth))
noise = gtsam.noiseModel.Isotropic.Sigma(1, 1 / np.sqrt(1000))
for disc in world.obstacles:
    for key in range(len(world.path)):
        graph.add(gtsam.CustomFactor(noise, [key], functools.partial(clear, disc)))
optimizer = gtsam.LevenbergMarquardtOptimizer(graph, initial, gtsam.LevenbergMarquardtParams())
result = optimizer.optimize()
path = np.array([result.atPoint2(key) for key in range(len(world.path))])
# [/program]
