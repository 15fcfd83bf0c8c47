# SPDX-License-Identifier: BSD-3-Clause
# A smooth path around round obstacles, with fixed ends.

import worlds

world = worlds.plan()

# [program]
import numpy as np
from boxplus import BatchedEdge, Graph, Vector2, optimize


class Smooth(BatchedEdge):
    def error(self, a, b, c):
        return a - 2 * b + c


class Clear(BatchedEdge):
    def error(self, p, disc):
        return np.maximum(0, world.margin + disc[:, 2] - np.linalg.norm(p - disc[:, :2], axis=1))


graph = Graph()
ids = graph.add_vertices(Vector2, None, world.path)
for end in (ids[0], ids[-1]):
    graph.fix(end)
graph.add_edges(Smooth(), ids[:-2], ids[1:-1], ids[2:], informations=100)
for disc in world.obstacles:
    graph.add_edges(Clear(), ids, measurements=np.tile(disc, (len(ids), 1)), informations=1000)
optimize(graph)
path = graph.estimates(Vector2)[1]
# [/program]

distances = np.linalg.norm(path[:, None] - world.obstacles[:, :2], axis=2) - world.obstacles[:, 2]
assert distances.min() > 0.2 > (np.linalg.norm(world.path[:, None] - world.obstacles[:, :2], axis=2)).min() - 1
