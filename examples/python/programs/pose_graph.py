# SPDX-License-Identifier: BSD-3-Clause
# A pose graph from arrays.

import worlds

world = worlds.pose_graph()

# [program]
from boxplus import SE2, Between, Graph, optimize

graph = Graph()
graph.add_vertices(SE2, None, world.guess)
graph.fix(0)
graph.add_edges(Between, world.i, world.j, measurements=world.z, informations=world.omega)
optimize(graph)
poses = graph.estimates(SE2)[1]
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.4
