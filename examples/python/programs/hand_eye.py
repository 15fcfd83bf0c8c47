# SPDX-License-Identifier: BSD-3-Clause
# The pose X of a camera on a robot's hand, from motions of both: robot X = X camera.

import worlds

world = worlds.hand_eye()

# [program]
import numpy as np
from boxplus import SE3, BatchedEdge, Graph, optimize, rows


class HandEye(BatchedEdge):
    def error(self, x, data):
        return rows.ominus(rows.times(data[:, :7], x), rows.times(x, data[:, 7:]))


graph = Graph()
x = graph.add_vertex(SE3())
graph.add_edges(HandEye(), x, measurements=np.c_[world.robot, world.camera])
optimize(graph)
# [/program]

assert abs(graph.estimate(x).ominus(world.truth)).max() < 2e-3
