# SPDX-License-Identifier: BSD-3-Clause
# The amplitude, decay and frequency of an oscillation.

import worlds

world = worlds.curve()

# [program]
import numpy as np
from boxplus import BatchedEdge, Graph, Vector3, optimize


class Oscillation(BatchedEdge):
    def error(self, x, data):
        return x[:, 0] * np.exp(-x[:, 1] * data[:, 0]) * np.cos(x[:, 2] * data[:, 0]) - data[:, 1]


graph = Graph()
curve = graph.add_vertex(Vector3(1, 0, 2.9))
graph.add_edges(Oscillation(), curve, measurements=np.c_[world.t, world.y], informations=1 / 0.05**2)
optimize(graph)
found = graph.estimate(curve)
# [/program]

np.testing.assert_allclose(found, world.truth, atol=0.05)
