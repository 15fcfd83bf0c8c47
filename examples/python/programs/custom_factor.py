# SPDX-License-Identifier: BSD-3-Clause
# A factor that the library does not have: distances of poses from known beacons.

import worlds

world = worlds.beacons()

# [program]
import numpy as np
from boxplus import SE2, BatchedEdge, Between, Graph, optimize


class BeaconRange(BatchedEdge):
    def error(self, pose, data):
        return np.linalg.norm(pose[:, :2] - data[:, :2], axis=1) - data[:, 2]


graph = Graph()
ids = graph.add_vertices(SE2, None, world.guess)
graph.fix(0)
graph.add_edges(Between, ids[:-1], ids[1:], measurements=world.odometry, informations=world.omega)
graph.add_edges(BeaconRange(), ids[world.pose], measurements=np.c_[world.places, world.distances], informations=1 / 0.05**2)
optimize(graph)
poses = graph.estimates(SE2)[1]
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.15
